#include "command/garmentcode/place_near.h"

#include <algorithm>
#include <cmath>

#include "math/vector3.h"
#include "piece/place.h"

namespace drape::command {
namespace {

using namespace math::vector3;

constexpr double kNear = 0.012;    // m, between a panel and the body
constexpr double kAround = 0.03;   // m, beyond a panel, because the body is known at its vertices only
constexpr double kThrough = 0.2;   // m, the largest part of the body that may be on the wrong side of a panel
constexpr double kOver = 0.05;     // m, above a shoulder: a strap bends as it is drawn over it
constexpr double kShoulder = 0.2;  // m, the largest height of a top above a seam that it obstructs
constexpr double kBeside = 0.01;   // m, on either side of a seam
constexpr double kGap = 0.02;      // m: edges nearer than this are sewn at once
constexpr double kCovers = 0.5;    // of the smaller panel: a larger overlap makes a second layer
constexpr double kParallel = 0.9;  // cosine between the normals of two layers

// The ends of the first edge of a side, in space (m).
struct Edge {
  Vec3 from, to;
  Vec3 middle() const { return 0.5 * (from + to); }
};
Edge edge_of(const Scene& scene, const scene::SeamSide& side) {
  const scene::PieceSpec& piece = scene.pieces[std::size_t(side.piece)];
  const auto i = std::size_t(side.edges[0]), n = piece.outline.size();
  return {piece::place_point(piece.place, piece.outline[i]),
          piece::place_point(piece.place, piece.outline[(i + 1) % n])};
}

// The bounding box of points of a plane.
struct Box {
  Vec2 low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  void add(const Vec2& p) {
    for (std::size_t k = 0; k < 2; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
  }
  double area() const { return std::max(high[0] - low[0], 0.0) * std::max(high[1] - low[1], 0.0); }
};

// The pose of a panel relative to the body: its distance (below 0 where the body comes through), and the
// outward direction. {0, 0, 0}: the panel was left where it was.
struct Stand {
  double off = 0;
  Vec3 out{0, 0, 0};
};

Stand panel_approach(scene::PieceSpec& piece, const std::vector<Vec3>& body) {
  scene::PlaceSpec& place = piece.place;
  Box box;
  for (const Vec2& p : piece.outline) box.add(p);
  const auto& [low, high] = box;
  const Vec3 normal = cross(place.axis_x, place.axis_y);
  double nearest = INFINITY, farthest[2] = {0, 0};  // [below, above]
  int count[2] = {0, 0};
  for (const Vec3& v : body) {
    const Vec3 d = v - place.origin;
    const double x = dot(d, place.axis_x), y = dot(d, place.axis_y), t = dot(d, normal);
    if (x < low[0] - kAround || x > high[0] + kAround || y < low[1] - kAround || y > high[1] + kAround)
      continue;
    const int side = t < 0 ? 0 : 1;
    ++count[side];
    farthest[side] = std::max(farthest[side], std::abs(t));
    nearest = std::min(nearest, std::abs(t));
  }
  const int body_side = count[1] > count[0];
  const double outward = body_side ? -1 : 1, through = farthest[1 - body_side];
  if (count[0] + count[1] == 0 || through > kThrough) return {};  // beside the body, or in the middle of it
  if (through > 0) place.origin += (outward * (through + kNear)) * normal;
  else if (nearest > kNear) place.origin -= (outward * (nearest - kNear)) * normal;
  return {through > 0 ? -through : nearest, outward * normal};
}

// True where most of the smaller panel lies over the other, nearer than kNear.
bool covers(const scene::PieceSpec& a, const Stand& as, const scene::PieceSpec& b, const Stand& bs) {
  if (dot(as.out, bs.out) < kParallel || std::abs(dot(b.place.origin - a.place.origin, as.out)) >= kNear)
    return false;
  Box of_a, of_b, both;
  for (const Vec2& p : a.outline) of_a.add(p);
  for (const Vec2& p : b.outline) {
    const Vec3 d = piece::place_point(b.place, p) - a.place.origin;
    of_b.add({dot(d, a.place.axis_x), dot(d, a.place.axis_y)});
  }
  for (std::size_t k = 0; k < 2; ++k) {
    both.low[k] = std::max(of_a.low[k], of_b.low[k]);
    both.high[k] = std::min(of_a.high[k], of_b.high[k]);
  }
  return both.area() > kCovers * std::min(of_a.area(), of_b.area());
}

// Separates layers. Panels that lay over another panel still do: from the body outwards, each moves out
// until it covers none below.
void layers_separate(Scene& scene, const std::vector<Stand>& stands) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < stands.size(); ++k)
    if (norm(stands[k].out) > 0) order.push_back(k);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return stands[a].off < stands[b].off; });
  for (std::size_t k = 1; k < order.size(); ++k)
    for (std::size_t below = 0; below < k; ++below) {
      scene::PieceSpec& piece = scene.pieces[order[k]];
      if (!covers(scene.pieces[order[below]], stands[order[below]], piece, stands[order[k]])) continue;
      const double over =
          dot(piece.place.origin - scene.pieces[order[below]].place.origin, stands[order[below]].out);
      piece.place.origin += (kNear - over) * stands[order[k]].out;
    }
}

// The rise (m) that a level seam needs for its sides to meet above what is between them.
double lift_needed(const Scene& scene, const scene::SeamSpec& seam, const std::vector<Vec3>& body) {
  const Edge a = edge_of(scene, seam.side[0]), b = edge_of(scene, seam.side[1]);
  const Vec3 gap = b.middle() - a.middle(), along = a.to - a.from;
  const double length = norm(gap), level = std::hypot(gap[0], gap[2]);
  if (length < kGap || level < 0.5 * length || std::abs(along[1]) > 0.5 * norm(along)) return 0;
  const Vec3 way{gap[0] / level, 0, gap[2] / level}, across{-way[2], 0, way[0]};
  const double half = std::abs(dot(along, across)) / 2 + kBeside,
               low = std::min(a.middle()[1], b.middle()[1]);
  double top = -INFINITY;
  for (const Vec3& v : body) {
    const Vec3 d = v - a.middle();
    const double t = dot(d, way);
    if (t > 0 && t < level && std::abs(dot(d, across)) < half) top = std::max(top, v[1]);
  }
  const double lift = top + kOver - low;
  return top - low < kShoulder && lift > 0 ? lift : 0;  // more body above the seam: a crotch, not a shoulder
}

}  // namespace

void garment_place_near(Scene& scene, const std::vector<Vec3>& body) {
  double lift = 0, farthest = 0;
  for (const scene::SeamSpec& seam : scene.seams) lift = std::max(lift, lift_needed(scene, seam, body));
  std::vector<Stand> stands;
  for (scene::PieceSpec& piece : scene.pieces) {
    piece.place.origin[1] += lift;
    stands.push_back(panel_approach(piece, body));
  }
  layers_separate(scene, stands);
  std::vector<scene::SeamSpec*> later;
  for (scene::SeamSpec& seam : scene.seams) {
    const Vec3 gap = edge_of(scene, seam.side[1]).middle() - edge_of(scene, seam.side[0]).middle();
    if (norm(gap) > kGap && std::abs(gap[1]) > 0.7 * norm(gap)) later.push_back(&seam);
    else farthest = std::max(farthest, norm(gap));
  }
  for (scene::SeamSpec* seam : later) seam->closed_at = std::ceil(100 * farthest / seam->speed) / 100;
}

}  // namespace drape::command
