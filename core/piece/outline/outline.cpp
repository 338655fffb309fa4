// Curves become chords. An arc from P to Q has the radius r, the angle a < 2 pi and the chord c = |Q - P| = 2
// r sin(a/2). Its point at the angle f is at the distance 2 r sin(f/2) from P. Its direction from P is that
// of Q - P, rotated by (f - a)/2 where the angle increases and by (a - f)/2 where it decreases. No centre is
// needed, so flat arcs of a large radius lose no precision.
#include "piece/outline/outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drape::piece {
namespace {

constexpr double kSag = 1e-3;  // of a cell, largest distance between a curve and its chords

Vec2 minus(Vec2 p, Vec2 q) { return {p[0] - q[0], p[1] - q[1]}; }

double cross(Vec2 p, Vec2 q) { return p[0] * q[1] - p[1] * q[0]; }

// Appends the points of an arc between p and q.
void arc_append(std::vector<Vec2>& points, const scene::CurveSpec& curve, Vec2 p, Vec2 q, double sag) {
  const Vec2 chord = minus(q, p);
  const double length = std::hypot(chord[0], chord[1]);
  const double half = std::asin(std::min(1.0, length / (2 * curve.radius)));
  const double angle = 2 * (curve.large ? std::numbers::pi - half : half);
  const double step = 4 * std::asin(std::sqrt(std::min(1.0, sag / curve.radius) / 2));  // 2 acos(1 - sag/r)
  const int n = std::max(1, int(std::ceil(angle / step)));
  for (int k = 1; k < n; ++k) {
    const double f = angle * k / n, turn = (curve.right ? f - angle : angle - f) / 2;
    const double reach = std::sin(f / 2) / std::sin(angle / 2);
    const double c = reach * std::cos(turn), s = reach * std::sin(turn);
    points.push_back({p[0] + c * chord[0] - s * chord[1], p[1] + s * chord[0] + c * chord[1]});
  }
}

// Appends the points of a Bezier curve between p and q.
void bezier_append(std::vector<Vec2>& points, const scene::CurveSpec& curve, Vec2 p, Vec2 q, double sag) {
  const std::vector<Vec2>& c = curve.bezier;
  const auto bend = [](Vec2 u, Vec2 v, Vec2 w) {
    return std::hypot(u[0] - 2 * v[0] + w[0], u[1] - 2 * v[1] + w[1]);
  };
  const double second =
      c.size() == 1 ? 2 * bend(p, c[0], q) : 6 * std::max(bend(p, c[0], c[1]), bend(c[0], c[1], q));
  const int n = std::max(1, int(std::ceil(std::sqrt(second / (8 * sag)))));
  for (int k = 1; k < n; ++k) {
    const double t = double(k) / n, s = 1 - t;
    Vec2 r;
    for (std::size_t a = 0; a < 2; ++a)
      r[a] = c.size() == 1 ? s * s * p[a] + 2 * s * t * c[0][a] + t * t * q[a]
                           : s * s * s * p[a] + 3 * s * t * (s * c[0][a] + t * c[1][a]) + t * t * t * q[a];
    points.push_back(r);
  }
}

OutlineLoop loop_turned(OutlineLoop loop) {
  std::reverse(loop.points.begin(), loop.points.end());
  std::reverse(loop.edge.begin(), loop.edge.end());
  std::rotate(loop.edge.begin(), loop.edge.begin() + 1, loop.edge.end());
  return loop;
}

double segment_distance(Vec2 p, Vec2 q, Vec2 point) {
  const Vec2 d = minus(q, p), e = minus(point, p);
  const double square = d[0] * d[0] + d[1] * d[1];
  const double t = square > 0 ? std::clamp((d[0] * e[0] + d[1] * e[1]) / square, 0.0, 1.0) : 0;
  return std::hypot(e[0] - t * d[0], e[1] - t * d[1]);
}

bool crosses_ray(Vec2 p, Vec2 q, Vec2 point) {  // the ray runs along +x
  if ((p[1] > point[1]) == (q[1] > point[1])) return false;
  const double side = cross(minus(q, p), minus(point, p));
  return (q[1] > p[1]) == (side > 0);
}

const std::vector<Vec2>& points_of(const OutlineLoop& loop) { return loop.points; }
// NOLINTNEXTLINE(bugprone-return-const-ref-from-parameter): the loops outlive the calls
const std::vector<Vec2>& points_of(const std::vector<Vec2>& loop) { return loop; }
const std::vector<Vec2>& points_of(const std::vector<Vec2>* loop) { return *loop; }

template <class Loops>
bool contains(const Loops& loops, Vec2 point) {
  bool inside = false;
  for (const auto& loop : loops)
    for (std::size_t k = 0, n = points_of(loop).size(); k < n; ++k)
      if (crosses_ray(points_of(loop)[k], points_of(loop)[(k + 1) % n], point)) inside = !inside;
  return inside;
}

template <class Loops>
double distance(const Loops& loops, Vec2 point) {
  if (contains(loops, point)) return 0;
  double smallest = INFINITY;
  for (const auto& loop : loops)
    for (std::size_t k = 0, n = points_of(loop).size(); k < n; ++k)
      smallest =
          std::min(smallest, segment_distance(points_of(loop)[k], points_of(loop)[(k + 1) % n], point));
  return smallest;
}

}  // namespace

double outline_touch(const scene::PieceSpec& piece) {
  Vec2 low = piece.outline[0], high = low;
  for (const Vec2& p : piece.outline)
    for (std::size_t a = 0; a < 2; ++a) low[a] = std::min(low[a], p[a]), high[a] = std::max(high[a], p[a]);
  return 1e-9 + 1e-9 * std::max(high[0] - low[0], high[1] - low[1]);
}

std::vector<Vec2> outline_edge(const scene::PieceSpec& piece, int edge) {
  const Vec2 p = piece.outline[std::size_t(edge)];
  const Vec2 q = piece.outline[(std::size_t(edge) + 1) % piece.outline.size()];
  std::vector<Vec2> points{p};
  for (const scene::CurveSpec& curve : piece.curves) {
    if (curve.edge != edge) continue;
    if (curve.bezier.empty()) arc_append(points, curve, p, q, kSag * piece.cell);
    else bezier_append(points, curve, p, q, kSag * piece.cell);
  }
  points.push_back(q);
  return points;
}

std::vector<OutlineLoop> outline_flatten(const scene::PieceSpec& piece) {
  std::vector<OutlineLoop> loops(1);
  for (int e = 0; e < int(piece.outline.size()); ++e) {
    const std::vector<Vec2> points = outline_edge(piece, e);
    loops[0].points.insert(loops[0].points.end(), points.begin(), points.end() - 1);
    loops[0].edge.resize(loops[0].points.size(), e);
  }
  if (polygon_area(loops[0].points) < 0) loops[0] = loop_turned(loops[0]);
  for (const std::vector<Vec2>& hole : piece.holes) {
    OutlineLoop loop{hole, std::vector<int>(hole.size())};
    for (std::size_t e = 0; e < hole.size(); ++e) loop.edge[e] = int(e);
    loops.push_back(polygon_area(hole) > 0 ? loop_turned(loop) : loop);
  }
  return loops;
}

double polygon_area(const std::vector<Vec2>& polygon) {
  double twice = 0;
  for (std::size_t k = 0; k + 1 < polygon.size(); ++k)
    twice += cross(minus(polygon[k], polygon[0]), minus(polygon[k + 1], polygon[0]));
  return twice / 2;
}

Vec2 polygon_centre(const std::vector<Vec2>& polygon) {
  const double area = polygon_area(polygon);
  Vec2 sum{0, 0};
  for (std::size_t k = 0; k + 1 < polygon.size(); ++k) {
    const Vec2 p = minus(polygon[k], polygon[0]), q = minus(polygon[k + 1], polygon[0]);
    for (std::size_t a = 0; a < 2; ++a) sum[a] += cross(p, q) * (p[a] + q[a]) / 6;
  }
  return {polygon[0][0] + sum[0] / area, polygon[0][1] + sum[1] / area};
}

double outline_area(const std::vector<OutlineLoop>& loops) {
  double area = 0;
  for (const OutlineLoop& loop : loops) area += polygon_area(loop.points);
  return area;
}

bool outline_contains(const std::vector<OutlineLoop>& loops, Vec2 point) { return contains(loops, point); }

double outline_distance(const std::vector<OutlineLoop>& loops, Vec2 point) { return distance(loops, point); }

double polygons_distance(const std::vector<std::vector<Vec2>>& rim_and_holes, Vec2 point) {
  return distance(rim_and_holes, point);
}

double polygon_distance(const std::vector<Vec2>& polygon, Vec2 point) {
  return distance(std::array{&polygon}, point);
}

}  // namespace drape::piece
