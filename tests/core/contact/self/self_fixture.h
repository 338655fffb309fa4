// Cloths in contact with themselves, and an independent check of distances and crossings: every pair, one by
// one.
#pragma once
#include "cloth_fixture.h"
#include "math/vector3.h"
#include "model/elements.h"

namespace drape::contact {

using namespace tests;

// A second rectangle of the same fabric.
inline scene::PieceSpec& sheet_add(Scene& scene, const std::string& name, double width, double height,
                                   double cell, const Vec3& origin) {
  scene::PieceSpec piece = scene.pieces[0];
  piece.name = name;
  piece.cell = cell;
  piece.outline = {{0, 0}, {width, 0}, {width, height}, {0, height}};
  piece.place = scene::PlaceSpec{};
  piece.place.origin = origin;
  scene.pieces.push_back(piece);
  return scene.pieces.back();
}

// A pin that holds all of the first piece.
inline scene::PinSpec hold_all(double width, double height) {
  scene::PinSpec pin;
  pin.name = "hold";
  pin.piece = 0;
  const double e = 1e-3;
  pin.region = {{-e, -e}, {width + e, -e}, {width + e, height + e}, {-e, height + e}};
  return pin;
}

struct PlainTriangle {
  std::size_t node[3];
  int lattice, i, j;
};

inline std::vector<PlainTriangle> triangles_of(const System& system) {
  std::vector<PlainTriangle> all;
  for (const model::Lattice& l : system.lattices)
    model::cells_visit(system, l, [&](const std::size_t* c, double) {
      const auto [i, j] = l.place_of(c[0]);
      all.push_back({{c[0], c[1], c[3]}, l.piece, i, j});
      all.push_back({{c[0], c[3], c[2]}, l.piece, i, j});
    });
  return all;
}

inline Vec3 at_node(const State& s, std::size_t n) { return {s.x[n], s.y[n], s.z[n]}; }

// The number of triangle sides that pass through triangles of cells that are not their neighbours.
inline int crossings(const Assembled& a) {
  using namespace math::vector3;
  const std::vector<PlainTriangle> all = triangles_of(a.system);
  std::vector<Vec3> low, high;
  for (const PlainTriangle& t : all) {
    Vec3 l{INFINITY, INFINITY, INFINITY}, h{-INFINITY, -INFINITY, -INFINITY};
    for (std::size_t n : t.node)
      for (std::size_t k = 0; k < 3; ++k) {
        l[k] = std::min(l[k], at_node(a.state, n)[k]);
        h[k] = std::max(h[k], at_node(a.state, n)[k]);
      }
    low.push_back(l);
    high.push_back(h);
  }
  int count = 0;
  for (std::size_t s = 0; s < all.size(); ++s)
    for (std::size_t t = 0; t < all.size(); ++t) {
      bool apart = false;
      for (std::size_t k = 0; k < 3; ++k) apart = apart || low[s][k] > high[t][k] || low[t][k] > high[s][k];
      if (apart) continue;
      if (all[s].lattice == all[t].lattice && std::abs(all[s].i - all[t].i) <= 1 &&
          std::abs(all[s].j - all[t].j) <= 1)
        continue;
      const Vec3 p = at_node(a.state, all[t].node[0]), e = at_node(a.state, all[t].node[1]) - p,
                 f = at_node(a.state, all[t].node[2]) - p;
      for (int k = 0; k < 3; ++k) {  // p + u e + v f = from + w g
        const Vec3 from = at_node(a.state, all[s].node[k]) - p,
                   g = at_node(a.state, all[s].node[(k + 1) % 3]) - p - from;
        Eigen::Matrix3d m;
        for (int r = 0; r < 3; ++r) m.row(r) << e[std::size_t(r)], f[std::size_t(r)], -g[std::size_t(r)];
        const Eigen::Vector3d x = m.partialPivLu().solve(Eigen::Vector3d(from[0], from[1], from[2]));
        count += x[0] > 0 && x[1] > 0 && x[0] + x[1] < 1 && x[2] > 0 && x[2] < 1;
      }
    }
  return count;
}

}  // namespace drape::contact
