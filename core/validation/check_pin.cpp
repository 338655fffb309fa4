// Checks that pins and probes are on their pieces, and that no point of the cloth belongs to two pins.
#include <algorithm>
#include <cmath>

#include "piece/outline/outline.h"
#include "scene/diagnostics.h"
#include "validation/checks.h"

namespace drape::validation {

namespace {

struct Box {
  Vec2 low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
};

// A closed set of points that a pin supports: one point, a chain of segments, or the area inside loops.
struct Held {
  enum Kind { kPoint, kChain, kArea } kind;
  std::vector<piece::OutlineLoop> loops;  // for a point or a chain: one loop, with its points in order
  Box box;
};

Held held_make(Held::Kind kind, std::vector<piece::OutlineLoop> loops) {
  Held held{kind, std::move(loops), {}};
  for (const Vec2& p : held.loops[0].points)
    for (std::size_t k = 0; k < 2; ++k)
      held.box.low[k] = std::min(held.box.low[k], p[k]), held.box.high[k] = std::max(held.box.high[k], p[k]);
  return held;
}

Held held_make(Held::Kind kind, std::vector<Vec2> points) {
  return held_make(kind, std::vector<piece::OutlineLoop>{{std::move(points), {}}});
}

// True if `test` is true for a segment.
template <class Test>
bool any_segment(const Held& h, Test test) {
  for (const piece::OutlineLoop& loop : h.loops) {
    const std::size_t n = loop.points.size(), segments = h.kind == Held::kArea ? n : n - 1;
    for (std::size_t k = 0; k < segments; ++k)
      if (test(loop.points[k], loop.points[(k + 1) % n])) return true;
  }
  return false;
}

double segment_distance(Vec2 a, Vec2 b, Vec2 p) {
  const double x = b[0] - a[0], y = b[1] - a[1], length2 = x * x + y * y;
  const double t = length2 > 0 ? std::clamp(((p[0] - a[0]) * x + (p[1] - a[1]) * y) / length2, 0.0, 1.0) : 0;
  return std::hypot(p[0] - a[0] - t * x, p[1] - a[1] - t * y);
}

bool holds(const Held& h, Vec2 p, double contact) {
  for (std::size_t k = 0; k < 2; ++k)
    if (p[k] < h.box.low[k] - contact || p[k] > h.box.high[k] + contact) return false;
  if (h.kind == Held::kArea) return piece::outline_distance(h.loops, p) <= contact;
  const Vec2 first = h.loops[0].points[0];
  return std::hypot(p[0] - first[0], p[1] - first[1]) <= contact ||
         any_segment(h, [&](Vec2 a, Vec2 b) { return segment_distance(a, b, p) <= contact; });
}

// The intersection of the segments a b and c d, if there is one.
bool crossing(Vec2 a, Vec2 b, Vec2 c, Vec2 d, Vec2& at) {
  const double x = b[0] - a[0], y = b[1] - a[1], u = d[0] - c[0], v = d[1] - c[1], det = x * v - y * u;
  if (det == 0) return false;  // parallel: if they touch, an end of one is on the other
  const double s = ((c[0] - a[0]) * v - (c[1] - a[1]) * u) / det;
  const double t = ((c[0] - a[0]) * y - (c[1] - a[1]) * x) / det;
  at = {a[0] + s * x, a[1] + s * y};
  return s >= 0 && s <= 1 && t >= 0 && t <= 1;
}

// Finds a point common to all sets. If there is one, then a vertex of a set or an intersection of two sets is
// one.
bool common_point(const std::vector<const Held*>& sets, double contact, Vec2& at) {
  const auto in_all = [&](Vec2 p) {
    const bool all =
        std::all_of(sets.begin(), sets.end(), [&](const Held* h) { return holds(*h, p, contact); });
    if (all) at = p;
    return all;
  };
  for (const Held* h : sets)
    for (const piece::OutlineLoop& loop : h->loops)
      if (std::any_of(loop.points.begin(), loop.points.end(), in_all)) return true;
  for (std::size_t i = 0; i < sets.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (any_segment(*sets[i], [&](Vec2 a, Vec2 b) {
            return any_segment(*sets[j], [&](Vec2 c, Vec2 d) {
              Vec2 p;
              return crossing(a, b, c, d, p) && in_all(p);
            });
          }))
        return true;
  return false;
}

std::vector<Held> pin_held(const scene::PieceSpec& piece, const scene::PinSpec& pin) {
  std::vector<Held> held;
  for (const Vec2& p : pin.at) held.push_back(held_make(Held::kPoint, {p}));
  for (int e : pin.edges)
    if (e >= 0 && e < int(piece.outline.size()))
      held.push_back(held_make(Held::kChain, piece::outline_edge(piece, e)));
  if (!pin.region.empty()) held.push_back(held_make(Held::kArea, pin.region));
  return held;
}

// Two pins on one point could contradict each other. One message for each pair of pins.
void clash_check(const Scene& scene, const scene::PinSpec& a, const scene::PinSpec& b, const Held& cloth,
                 Problems& problems) {
  const scene::PieceSpec& piece = scene.pieces[std::size_t(a.piece)];
  const double contact = piece::outline_touch(piece);
  for (const Held& p : pin_held(piece, a))
    for (const Held& q : pin_held(piece, b)) {
      bool apart = false;
      for (std::size_t k = 0; k < 2; ++k)
        apart = apart || p.box.low[k] > q.box.high[k] + contact || q.box.low[k] > p.box.high[k] + contact;
      std::vector<const Held*> sets{&p, &q};
      if (p.kind == Held::kArea && q.kind == Held::kArea) sets.push_back(&cloth);
      Vec2 at;
      if (apart || !common_point(sets, contact, at)) continue;
      return problems.push_back({"pin." + b.name, "and pin." + a.name + " both hold the point " +
                                                      scene::point_text(at) + " of the piece " +
                                                      scene::in_quotes(piece.name) +
                                                      "; a point belongs to one pin"});
    }
}

void point_check(const scene::PieceSpec& piece, const Held& cloth, Vec2 p, const std::string& path,
                 Problems& problems) {
  const double distance = piece::outline_distance(cloth.loops, p);
  if (distance <= piece::outline_touch(piece)) return;
  std::string where = " m off the piece " + scene::in_quotes(piece.name);
  for (std::size_t h = 1; h < cloth.loops.size(); ++h)
    if (piece::outline_contains({cloth.loops[h]}, p))
      where = " m inside " + scene::entry("holes", h - 1) + " of the piece " + scene::in_quotes(piece.name);
  problems.push_back({path, "= " + scene::point_text(p) + " lies " + scene::rounded(distance) + where});
}

void edges_check(const scene::PieceSpec& piece, const scene::PinSpec& pin, const std::string& path,
                 Problems& problems) {
  const int count = static_cast<int>(piece.outline.size());
  for (std::size_t i = 0; i < pin.edges.size(); ++i)
    if (pin.edges[i] < 0 || pin.edges[i] >= count)
      problems.push_back(
          {scene::entry(path + ".edges", i), "= " + std::to_string(pin.edges[i]) + "; allowed: 0 to " +
                                                 std::to_string(count - 1) +
                                                 " (edge i runs from point i of the outline to the next)"});
}

}  // namespace

void pins_check(const Scene& scene, const std::vector<bool>& valid, Problems& problems) {
  std::vector<Held> cloths;  // [pieces] empty where the outline has a fault
  for (std::size_t p = 0; p < scene.pieces.size(); ++p)
    cloths.push_back(valid[p] ? held_make(Held::kArea, piece::outline_flatten(scene.pieces[p])) : Held{});
  std::vector<const scene::PinSpec*> pins;
  for (const scene::PinSpec& pin : scene.pins) {
    const std::string path = "pin." + pin.name;
    const std::size_t before = problems.size();
    piece::polygon_problems(pin.region, path + ".region", problems);
    if (pin.piece < 0 || !valid[std::size_t(pin.piece)]) continue;
    const scene::PieceSpec& piece = scene.pieces[std::size_t(pin.piece)];
    const Held& cloth = cloths[std::size_t(pin.piece)];
    for (std::size_t i = 0; i < pin.at.size(); ++i)
      point_check(piece, cloth, pin.at[i], scene::entry(path + ".at", i), problems);
    edges_check(piece, pin, path, problems);
    if (problems.size() > before && !pin.region.empty()) continue;
    for (const scene::PinSpec* other : pins)
      if (other->piece == pin.piece) clash_check(scene, *other, pin, cloth, problems);
    pins.push_back(&pin);
  }
  for (const scene::ProbeSpec& probe : scene.probes)
    if (probe.piece >= 0 && valid[std::size_t(probe.piece)])
      point_check(scene.pieces[std::size_t(probe.piece)], cloths[std::size_t(probe.piece)], probe.at,
                  "probe." + probe.name + ".at", problems);
}

}  // namespace drape::validation
