// Pieces for tests: rectangles, random polygons, and the topology of their grids.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include "piece/grid/grid.h"
#include "piece/outline/outline.h"

namespace drape::tests {

inline scene::PieceSpec piece_of(std::vector<Vec2> outline, double cell) {
  scene::PieceSpec piece;
  piece.name = "p";
  piece.cell = cell;
  piece.outline = std::move(outline);
  return piece;
}

// A rectangle from (x, y), counter-clockwise from its low corner.
inline scene::PieceSpec rectangle(double x, double y, double width, double height, double cell) {
  return piece_of({{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}}, cell);
}

inline Scene scene_of(const scene::PieceSpec& piece, const std::vector<int>& pinned_edges = {}) {
  Scene scene;
  scene.pieces = {piece};
  if (!pinned_edges.empty()) {
    scene::PinSpec pin;
    pin.piece = 0;
    pin.edges = pinned_edges;
    scene.pins = {pin};
  }
  return scene;
}

inline bool is_sound(const scene::PieceSpec& piece) {
  std::vector<Problem> problems;
  piece::outline_problems(piece, "piece.p", problems);
  return problems.empty();
}

struct RandomPiece {
  std::mt19937_64 bits;
  explicit RandomPiece(unsigned seed) : bits(seed) {}
  double operator()(double low, double high) { return std::uniform_real_distribution<>(low, high)(bits); }
  int count(int low, int high) { return std::uniform_int_distribution<>(low, high)(bits); }

  // Corners at random distances round a centre.
  std::vector<Vec2> star(Vec2 centre, double nearest, double farthest, int corners) {
    std::vector<Vec2> points;
    for (int k = 0; k < corners; ++k) {
      const double f = 2 * std::numbers::pi * (k + (*this)(0, 0.8)) / corners, r = (*this)(nearest, farthest);
      points.push_back({centre[0] + r * std::cos(f), centre[1] + r * std::sin(f)});
    }
    if (bits() % 2) std::reverse(points.begin(), points.end());
    return points;
  }

  // With holes and curves, any grain and origin.
  scene::PieceSpec piece() {
    for (;;) {
      const Vec2 centre{(*this)(-2, 2), (*this)(-2, 2)};
      scene::PieceSpec p = piece_of(star(centre, 0.3, 1, count(6, 30)), (*this)(0.01, 0.4));
      if (bits() % 2) p.holes.push_back(star(centre, 0.02, 0.15, count(3, 9)));
      for (int e = 0; e < int(p.outline.size()); ++e) {
        if (bits() % 4) continue;
        scene::CurveSpec c;
        c.edge = e;
        const Vec2 a = p.outline[std::size_t(e)], b = p.outline[std::size_t(e + 1) % p.outline.size()];
        const double chord = std::hypot(b[0] - a[0], b[1] - a[1]);
        c.radius = chord * (*this)(0.6, 3);
        c.right = bits() % 2;
        if (bits() % 2)
          for (int k = count(1, 2); k > 0; --k)
            c.bezier.push_back({(a[0] + b[0]) / 2 + chord * (*this)(-0.3, 0.3),
                                (a[1] + b[1]) / 2 + chord * (*this)(-0.3, 0.3)});
        p.curves.push_back(c);
      }
      if (bits() % 2) p.grain = (*this)(-4, 4);
      if (bits() % 2) p.grid_origin = Vec2{(*this)(-50, 50), (*this)(-50, 50)};
      if (is_sound(p)) return p;
    }
  }

  // Corners on multiples of 1, 1/2 or 1/4 of a cell.
  scene::PieceSpec snapped_piece() {
    for (;;) {
      const double unit = 1.0 / double(1 << count(0, 2));
      const double size = (*this)(1, 6);
      scene::PieceSpec p = piece_of(star({0, 0}, 0.2 * size, size, count(3, 14)), 1);
      if (bits() % 3 == 0) p.holes.push_back(star({0, 0}, 0.05 * size, 0.4 * size, count(3, 6)));
      for (auto* loop : {&p.outline, p.holes.empty() ? &p.outline : &p.holes.front()})
        for (Vec2& q : *loop)
          for (double& v : q) v = std::round(v / unit) * unit;
      p.grid_origin = Vec2{0, 0};
      if (is_sound(p)) return p;
    }
  }
};

inline double grid_area(const piece::Grid& g) {
  double sum = 0;
  for (double a : g.area) sum += a;
  return sum;
}

// The cells as a complex: the number of connected pieces, and nodes - sides + cells, which is the number of
// connected pieces less that of their holes.
struct Topology {
  int pieces = 0, euler = 0;
};

inline Topology topology_of(const piece::Grid& g) {
  std::map<int, int> root;
  const auto find = [&](int n) {
    while (root[n] != n) n = root[n];
    return n;
  };
  std::set<std::pair<int, int>> sides;
  for (const piece::GridCell& c : g.cells) {
    for (int n : c.node) root.emplace(n, n);
    for (int k = 1; k < 4; ++k) root[find(c.node[k])] = find(c.node[0]);
    for (const auto& [k, l] : {std::pair{0, 1}, {0, 2}, {1, 3}, {2, 3}}) sides.insert({c.node[k], c.node[l]});
  }
  Topology topology;
  for (const auto& [n, r] : root) topology.pieces += n == r;
  topology.euler = int(root.size()) - int(sides.size()) + int(g.cells.size());
  return topology;
}

}  // namespace drape::tests
