#include "contact/edge/gap.h"

#include <algorithm>
#include <cmath>

#include "math/closest_points.h"
#include "math/vector3.h"

namespace drape::contact {
namespace {

using namespace math::vector3;

constexpr double kThin = 1e-12;       // of a squared length: below it a direction is undefined
constexpr double kBeyond = 1e-9;      // of an edge: a link over the joint of two edges counts
constexpr double kPast = 0.5;         // of a link: how far beyond its end the closest point may be
constexpr double kSteep = 0.01;       // sine between a cell and the outward axis of a tip
constexpr int kNewton = 12;           // maximum of iterations
constexpr double kConverged = 1e-13;  // of the side of a cell

// Turns the unit vector n to the side from which the body falls away in all directions. Returns the smallest
// sine of these, or 0 where there is no such side.
double side_set(const body::SharpFeature& r, Vec3& n) {
  double low = INFINITY, high = -INFINITY;
  for (const Vec3& f : r.fall) {
    const double falls = -dot(n, f);
    low = std::min(low, falls);
    high = std::max(high, falls);
  }
  if (low > 0) return low;
  if (high >= 0) return 0;
  n = -1.0 * n;
  return -high;
}

// Sets the gap of an element over the feature: where `sines`, the smallest of its sines, is above `sine`.
void over_set(const body::SharpFeature& r, double sines, double sine, const Vec3& n, double distance,
              EdgeGap& gap) {
  if (!(sines > sine)) return;
  const double rise = std::min(sines / sine - 1, 1.0);
  gap.over = true;
  gap.share = rise * rise * (3 - 2 * rise);
  gap.n = n;
  gap.distance = distance;
  gap.inside = INFINITY;
  for (std::size_t k = 0; k < r.fall.size(); ++k)
    if (const double falls = -dot(n, r.fall[k]); falls > sine)
      gap.inside = std::min(gap.inside, falls * r.length[k]);
}

}  // namespace

// The link passes over (or under) the edge where its ends are on both sides of the plane through the edge and
// its outward direction. At an edge that turns by more than 90 degrees, the closest point on the line of the
// link may then lie beyond its end, by half a link at most. There the weights are up to 3/2 and sum |W_k| up
// to 2. The penalty is divided by (sum |W_k|)^2, so that it stiffens the nodes like a point on the link with
// weights |W_k|/sum |W_j|.
EdgeGap gap_link_edge(const body::SharpFeature& edge, const Vec3* end, double sine) {
  EdgeGap gap;
  const Vec3 e = end[1] - end[0], f = edge.to - edge.from, r = end[0] - edge.from, across = cross(e, f);
  const auto [s, t, skew] = math::lines_closest(e, f, r);
  const bool crosses = skew && t >= -kBeyond && t <= 1 + kBeyond;
  const bool on_link = crosses && s > 0 && s < 1;
  Vec3 n = crosses ? (1 / norm(across)) * across : across;
  if (on_link) {
    gap.clearance = std::abs(dot(r, n));
  } else {
    const double to_ends = std::min(math::segment_distance2(end[0], edge.from, edge.to),
                                    math::segment_distance2(end[1], edge.from, edge.to));
    gap.clearance = std::sqrt(std::min({to_ends, math::segment_distance2(edge.from, end[0], end[1]),
                                        math::segment_distance2(edge.to, end[0], end[1])}));
    if (!crosses || !(s > -kPast && s < 1 + kPast)) return gap;
    const Vec3 side = cross(f, edge.out);
    if (!(dot(r, side) * dot(end[1] - edge.from, side) < 0)) return gap;
  }
  const double sines = side_set(edge, n);
  over_set(edge, sines, sine, n, dot(r, n), gap);
  const double spread = std::abs(1 - s) + std::abs(s);  // 1 on the link
  gap.share /= spread * spread;
  gap.weight[0] = 1 - s;
  gap.weight[1] = s;
  return gap;
}

// The distance is also a minimum along the cloth: n.m >= sine |m| for the directions m from the link into its
// cells.
EdgeGap gap_link_tip(const body::SharpFeature& tip, const Vec3* end, const Vec3 (*beyond)[2], int cells,
                     double sine) {
  EdgeGap gap;
  const Vec3 link = end[1] - end[0];
  const double t = math::segment_closest(tip.from, end[0], end[1]);
  const Vec3 arm = end[0] + t * link - tip.from;
  gap.clearance = norm(arm);
  const double length2 = dot(link, link);
  if (!(t > 0 && t < 1) || !(dot(arm, arm) > kThin * length2)) return gap;
  Vec3 n = (1 / gap.clearance) * arm;
  double sines = side_set(tip, n);
  for (int k = 0; k < cells && sines > 0; ++k) {
    Vec3 into = (1 - t) * (beyond[k][0] - end[0]) + t * (beyond[k][1] - end[1]);
    into -= (dot(into, link) / length2) * link;
    sines = std::min(sines, dot(n, into) / norm(into));
  }
  over_set(tip, sines, sine, n, dot(arm, n), gap);
  gap.weight[0] = 1 - t;
  gap.weight[1] = t;
  return gap;
}

namespace {

// The closest point (u, v) to p on the bilinear surface, by Gauss-Newton from its middle:
// (x - p).x_u = (x - p).x_v = 0.
struct BilinearClosest {
  double u, v;
  Vec3 arm, along_u, along_v;
  bool inside;
};
BilinearClosest bilinear_closest(const Vec3& p, const Vec3* c) {
  const Vec3 twist = (c[3] - c[2]) - (c[1] - c[0]);
  BilinearClosest f{0.5, 0.5, {}, {}, {}, false};
  for (int k = 0; k < kNewton; ++k) {
    f.along_u = (c[1] - c[0]) + f.v * twist;
    f.along_v = (c[2] - c[0]) + f.u * twist;
    f.arm = c[0] + f.u * (c[1] - c[0]) + f.v * (c[2] - c[0]) + (f.u * f.v) * twist - p;
    const double uu = dot(f.along_u, f.along_u), uv = dot(f.along_u, f.along_v),
                 vv = dot(f.along_v, f.along_v), ru = dot(f.arm, f.along_u), rv = dot(f.arm, f.along_v);
    const double det = uu * vv - uv * uv;
    if (!(det > kThin * uu * vv)) return f;
    const double du = (uv * rv - vv * ru) / det, dv = (uv * ru - uu * rv) / det;
    if (std::abs(du) < kConverged && std::abs(dv) < kConverged) break;
    f.u = std::clamp(f.u + du, -1.0, 2.0);
    f.v = std::clamp(f.v + dv, -1.0, 2.0);
  }
  f.inside = f.u > 0 && f.u < 1 && f.v > 0 && f.v < 1;
  return f;
}

// Whether the line through p along `out` intersects the cell, and where: Newton in the plane normal to it.
bool axis_intersects(const Vec3& p, const Vec3& out, const Vec3* c, double& u, double& v) {
  const Vec3 other = std::abs(out[0]) < 0.6 * norm(out) ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 a = cross(out, other), b = cross(out, a), twist = (c[3] - c[2]) - (c[1] - c[0]);
  u = v = 0.5;
  for (int k = 0; k < kNewton; ++k) {
    const Vec3 along_u = (c[1] - c[0]) + v * twist, along_v = (c[2] - c[0]) + u * twist;
    const Vec3 arm = c[0] + u * (c[1] - c[0]) + v * (c[2] - c[0]) + (u * v) * twist - p;
    const double au = dot(a, along_u), av = dot(a, along_v), bu = dot(b, along_u), bv = dot(b, along_v),
                 ra = dot(a, arm), rb = dot(b, arm), det = au * bv - av * bu;
    if (det == 0) return false;
    const double du = (av * rb - bv * ra) / det, dv = (bu * ra - au * rb) / det;
    u = std::clamp(u + du, -1.0, 2.0);
    v = std::clamp(v + dv, -1.0, 2.0);
    if (std::abs(du) < kConverged && std::abs(dv) < kConverged) break;
  }
  return u >= 0 && u <= 1 && v >= 0 && v <= 1;
}

void weights_set(double u, double v, EdgeGap& gap) {
  gap.weight[0] = (1 - u) * (1 - v);
  gap.weight[1] = u * (1 - v);
  gap.weight[2] = (1 - u) * v;
  gap.weight[3] = u * v;
}

}  // namespace

// The cell passes over (or under) the tip where its closest point is on the cell, or the outward axis of the
// tip intersects it. Where the cell is steeper than the tip, or the closest point is beyond its sides, the
// height along the axis counts. Only the stop acts on it, so that nothing jumps as the tip slides from cell
// to cell.
EdgeGap gap_cell_tip(const body::SharpFeature& tip, const Vec3* c, double sine) {
  EdgeGap gap;
  const Vec3& p = tip.from;
  const double sides2 =
      std::min(std::min(math::segment_distance2(p, c[0], c[1]), math::segment_distance2(p, c[2], c[3])),
               std::min(math::segment_distance2(p, c[0], c[2]), math::segment_distance2(p, c[1], c[3])));
  const BilinearClosest f = bilinear_closest(p, c);
  gap.clearance = std::sqrt(f.inside ? std::min(sides2, dot(f.arm, f.arm)) : sides2);
  if (f.inside) {
    const Vec3 across = cross(f.along_u, f.along_v);
    Vec3 n = (1 / norm(across)) * across;
    const double sines = side_set(tip, n);
    weights_set(f.u, f.v, gap);
    over_set(tip, sines, sine, n, dot(f.arm, n), gap);
  }
  double u = 0, v = 0;
  const Vec3& out = tip.out;
  if (gap.over || !axis_intersects(p, out, c, u, v)) return gap;
  weights_set(u, v, gap);
  Vec3 at{0, 0, 0},
      n = cross((1 - v) * (c[1] - c[0]) + v * (c[3] - c[2]), (1 - u) * (c[2] - c[0]) + u * (c[3] - c[1]));
  for (int k = 0; k < 4; ++k) at += gap.weight[k] * c[k];
  n = (dot(n, out) < 0 ? -1 : 1) / norm(n) * n;
  if (dot(n, out) < kSteep) n = out;
  over_set(tip, tip.sharp, sine, n, dot(at - p, n), gap);
  gap.share = 0;
  return gap;
}

}  // namespace drape::contact
