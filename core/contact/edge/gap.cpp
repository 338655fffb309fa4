#include "contact/edge/gap.h"

#include <algorithm>
#include <array>
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
constexpr double kLean = 0.7;         // sine by which a link may lean against a narrow face
constexpr double kLeanBlend = 0.2;    // of it, over which the penalty begins
constexpr double kEitherSide = 0.05;  // cosine to the outward direction, below which either side may be out
constexpr double kNarrow = 0.125;     // of a link or cell: kBlend
constexpr int kNewton = 12;           // maximum of iterations
constexpr double kConverged = 1e-13;  // of the side of a cell

// A feature, and how far (m) the element reaches from its foot along each direction in which the body falls
// away.
struct Falls {
  const body::SharpFeature& feature;
  double sine, blend;  // blend: m, of a reach, over which a face passes for narrow
  Vec3 corner[4];      // [corners] m, from the foot
  int corners;

  double reach(const Vec3& f) const {
    double farthest = 0;
    for (int k = 0; k < corners; ++k) farthest = std::max(farthest, dot(corner[k], f));
    return farthest;
  }
};

// Whether the element is over the feature with the normal n, by the directions f; and the share of the
// penalty.
struct Over {
  double share = INFINITY;  // before it is smoothed
  bool over = true;
};
Over over_by(const Falls& of, const Vec3& n) {
  Over over;
  for (std::size_t k = 0; k < of.feature.fall.size(); ++k) {
    const Vec3& f = of.feature.fall[k];
    const double falls = -dot(n, f);
    const double narrow = std::clamp((of.reach(f) - of.feature.length[k]) / of.blend, 0.0, 1.0);
    const double wide_share = std::clamp(falls / of.sine - 1, 0.0, 1.0),
                 narrow_share = of.feature.turn * std::clamp((falls + kLean) / kLeanBlend, 0.0, 1.0);
    over.share = std::min(over.share, wide_share + narrow * (narrow_share - wide_share));
    over.over = over.over && falls > -kLean * narrow;
  }
  return over;
}

// How deep (m) the body is below the feature.
double inside_of(const body::SharpFeature& r, const Vec3& n) {
  double inside = INFINITY;
  for (std::size_t k = 0; k < r.fall.size(); ++k) inside = std::min(inside, -dot(n, r.fall[k]) * r.length[k]);
  return inside;
}

// Sets the gap of an element whose foot is at the vector `arm` from the feature, along the unit vector n or
// against it: n points outwards. Where it is across the outward direction, as on the rim of a thin sheet that
// the element lies flat on, either side may be out, and n points to where the element is.
void over_set(const Falls& of, Vec3 n, const Vec3& arm, EdgeGap& gap) {
  const double outwards = dot(n, of.feature.out);
  if (std::abs(outwards) < kEitherSide ? dot(arm, n) < 0 : outwards < 0) n = -1.0 * n;
  const Over over = over_by(of, n);
  if (!over.over) return;
  gap.over = true;
  gap.share = of.feature.bears ? over.share * over.share * (3 - 2 * over.share) : 0;
  gap.n = n;
  gap.distance = dot(arm, n);
  gap.inside = inside_of(of.feature, n);
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
  const Vec3 ends[2] = {-s * e, (1 - s) * e};
  over_set({edge, sine, kNarrow * norm(e), {ends[0], ends[1]}, 2}, n, r, gap);
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
  over_set({tip, sine, kNarrow * std::sqrt(length2), {-t * link, (1 - t) * link}, 2},
           (1 / gap.clearance) * arm, arm, gap);
  for (int k = 0; k < cells && gap.over; ++k) {
    Vec3 into = (1 - t) * (beyond[k][0] - end[0]) + t * (beyond[k][1] - end[1]);
    into -= (dot(into, link) / length2) * link;
    const double rise = std::clamp(dot(gap.n, into) / (sine * norm(into)) - 1, 0.0, 1.0);
    gap.over = rise > 0;
    gap.share = std::min(gap.share, rise * rise * (3 - 2 * rise));
  }
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
    const Vec3 across = cross(f.along_u, f.along_v), foot = p + f.arm;
    weights_set(f.u, f.v, gap);
    over_set(
        {tip, sine, kNarrow * norm(c[1] - c[0]), {c[0] - foot, c[1] - foot, c[2] - foot, c[3] - foot}, 4},
        unit(across), f.arm, gap);
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
  gap.over = true;
  gap.share = 0;
  gap.n = n;
  gap.distance = dot(at - p, n);
  gap.inside = inside_of(tip, n);
  return gap;
}

namespace {

// The lowest point of a bilinear cell along m in the plane through an edge and m: H = m.(x - from) where
// g.(x - from) = 0. With x = p + u a + v b + u v w that is v = -(A + B u)/(C + D u), and H'(u) = 0 is
// quadratic in u. `ma` is m.a, and so on. Where the edge runs rather along v, u and v change places.
struct LowestPoint {
  double u, v;
  bool found;
};
LowestPoint lowest_point(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& w, const Vec3& g,
                         const Vec3& m) {
  const double A = dot(g, p), B = dot(g, a), C = dot(g, b), D = dot(g, w);
  const double ma = dot(m, a), mb = dot(m, b), mw = dot(m, w);
  // 0 = ma (C + D u)^2 - [B (mb + mw u) + (A + B u) mw] (C + D u) + D (A + B u)(mb + mw u)
  const double q2 = ma * D * D - B * mw * D, q1 = 2 * (ma * D - B * mw) * C,
               q0 = ma * C * C - (B * mb + A * mw) * C + D * A * mb;
  const auto height = [&](double u, double& v) {
    v = -(A + B * u) / (C + D * u);
    return u * ma + v * mb + u * v * mw;
  };
  double root[2];
  int roots = 0;
  const double half = q1 / 2, det = half * half - q2 * q0;
  if (!(det >= 0)) return {0, 0, false};
  const double far = -(half + std::copysign(std::sqrt(det), half));  // without cancellation
  if (q2 != 0) root[roots++] = far / q2;
  if (far != 0) root[roots++] = q0 / far;
  constexpr double kAside = 1e-3;
  for (int k = 0; k < roots; ++k) {
    double v = 0, aside = 0;
    const double u = root[k], low = height(u, v);
    if (!(u > 0 && u < 1 && v > 0 && v < 1)) continue;
    if (height(u - kAside, aside) > low && height(u + kAside, aside) > low) return {u, v, true};
  }
  return {0, 0, false};
}

// The distance from an edge to a cell, m.
double cell_edge_clearance(const body::SharpFeature& edge, const Vec3* c) {
  double least2 = INFINITY;
  for (const auto& side : {std::array<int, 2>{0, 1}, {2, 3}, {0, 2}, {1, 3}})
    least2 = std::min(least2, math::edges_closest(c[side[0]], c[side[1]], edge.from, edge.to).distance2);
  for (const Vec3& end : {edge.from, edge.to}) {
    const BilinearClosest f = bilinear_closest(end, c);
    if (f.inside) least2 = std::min(least2, dot(f.arm, f.arm));
  }
  return std::sqrt(least2);
}

}  // namespace

EdgeGap gap_cell_edge(const body::SharpFeature& edge, const Vec3* c, double sine) {
  constexpr int kTurns = 3;  // of m to the normal of the cell
  EdgeGap gap;
  gap.clearance = cell_edge_clearance(edge, c);
  const Vec3 a = c[1] - c[0], b = c[2] - c[0], w = (c[3] - c[2]) - (c[1] - c[0]), p = c[0] - edge.from;
  const Vec3 span = edge.to - edge.from, f = unit(span);
  double u = 0.5, v = 0.5;
  Vec3 m;
  for (int k = 0; k < kTurns; ++k) {
    const Vec3 normal = unit(cross(a + v * w, b + u * w));
    m = normal - dot(normal, f) * f;
    const double length = norm(m);
    if (!(length > kSteep)) return gap;
    m = ((dot(m, edge.out) < 0 ? -1 : 1) / length) * m;
    const Vec3 g = cross(f, m);
    const bool along_v = std::abs(dot(g, b)) < std::abs(dot(g, a));
    const LowestPoint low = along_v ? lowest_point(p, b, a, w, g, m) : lowest_point(p, a, b, w, g, m);
    if (!low.found) return gap;
    u = along_v ? low.v : low.u, v = along_v ? low.u : low.v;
  }
  const Vec3 x = p + u * a + v * b + (u * v) * w;
  const double t = dot(x, span) / dot(span, span), distance = dot(x, m);
  if (!(t >= 0 && t <= 1)) return gap;
  gap.clearance = std::min(gap.clearance, std::abs(distance));
  weights_set(u, v, gap);
  const Vec3 foot = edge.from + x;
  over_set({edge, sine, kNarrow * norm(a), {c[0] - foot, c[1] - foot, c[2] - foot, c[3] - foot}, 4}, m,
           distance * m, gap);
  gap.share = 0;
  return gap;
}

}  // namespace drape::contact
