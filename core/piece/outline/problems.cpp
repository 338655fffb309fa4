#include <algorithm>
#include <cmath>
#include <cstdio>

#include "piece/outline/crossings.h"
#include "piece/outline/outline.h"
#include "scene/diagnostics.h"

namespace drape::piece {
namespace {

using Problems = std::vector<Problem>;

constexpr double kMaxNodes = 4e6;          // largest number of nodes of a piece
constexpr std::size_t kMaxCrossings = 10;  // largest number of crossings reported for one piece

std::string loop_name(std::size_t loop) { return loop == 0 ? "outline" : scene::entry("holes", loop - 1); }

struct Extent {
  Vec2 low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  double along(std::size_t k) const { return high[k] - low[k]; }
  double size() const { return std::max(along(0), along(1)); }
};

void extent_grow(Extent& e, Vec2 p) {
  for (std::size_t k = 0; k < 2; ++k)
    e.low[k] = std::min(e.low[k], p[k]), e.high[k] = std::max(e.high[k], p[k]);
}

// True if all points are on one line.
bool is_flat(const std::vector<Vec2>& points, double contact) {
  const Vec2 p = points[0];
  Vec2 far{0, 0};  // from p
  for (const Vec2& q : points)
    if (std::hypot(q[0] - p[0], q[1] - p[1]) > std::hypot(far[0], far[1])) far = {q[0] - p[0], q[1] - p[1]};
  const double length = std::hypot(far[0], far[1]);
  return std::all_of(points.begin(), points.end(), [&](Vec2 q) {
    return std::abs(far[0] * (q[1] - p[1]) - far[1] * (q[0] - p[0])) <= contact * length;
  });
}

// Checks that there are enough points and that none repeats its predecessor.
bool points_check(const std::vector<Vec2>& points, const std::string& path, double contact,
                  Problems& problems) {
  const std::size_t before = problems.size(), n = points.size();
  if (n < 3) {
    problems.push_back({path, "has " + std::to_string(n) + " points; allowed: at least 3"});
    return false;
  }
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 p = points[k], q = points[(k + 1) % n];
    if (std::hypot(q[0] - p[0], q[1] - p[1]) > contact) continue;
    if (k + 1 == n)
      problems.push_back({path, "repeats its first point at the end; an outline closes by itself"});
    else
      problems.push_back({scene::entry(path, k + 1), "= " + scene::point_text(q) + " repeats point " +
                                                         std::to_string(k) + "; allowed: more than " +
                                                         scene::rounded(contact) + " m away"});
  }
  return problems.size() == before;
}

// Checks that points with straight edges enclose an area. Curves may enclose one between points on a line.
bool area_check(const std::vector<Vec2>& points, const std::string& path, double contact,
                Problems& problems) {
  if (!is_flat(points, contact)) return true;
  problems.push_back({path, "encloses no area"});
  return false;
}

bool curves_check(const scene::PieceSpec& piece, const std::string& path, Problems& problems) {
  const std::size_t before = problems.size(), count = piece.outline.size();
  std::vector<int> curve_of(count, -1);
  for (std::size_t c = 0; c < piece.curves.size(); ++c) {
    const scene::CurveSpec& curve = piece.curves[c];
    const std::string at = scene::entry(path + ".curves", c);
    if (curve.edge < 0 || std::size_t(curve.edge) >= count) {
      problems.push_back({at + ".edge", "= " + std::to_string(curve.edge) + "; allowed: 0 to " +
                                            std::to_string(count - 1) +
                                            " (edge i runs from point i of the outline to the next)"});
      continue;
    }
    const auto edge = std::size_t(curve.edge);
    if (curve_of[edge] >= 0)
      problems.push_back({at + ".edge", "= " + std::to_string(edge) + " has a curve already, curves[" +
                                            std::to_string(curve_of[edge]) + "]; allowed: one an edge"});
    curve_of[edge] = int(c);
    if (curve.bezier.size() > 2)
      problems.push_back({at + ".bezier", "has " + std::to_string(curve.bezier.size()) +
                                              " control points; allowed: 1 (quadratic) or 2 (cubic)"});
    if (!curve.bezier.empty()) continue;
    const Vec2 p = piece.outline[edge], q = piece.outline[(edge + 1) % count];
    const double half = std::hypot(q[0] - p[0], q[1] - p[1]) / 2;
    if (!(curve.radius >= half * (1 - 1e-9)))
      problems.push_back({at + ".arc", "= " + scene::number_text(curve.radius) + " m; allowed: at least " +
                                           scene::rounded(half) + " m, half the chord of edge " +
                                           std::to_string(edge)});
  }
  return problems.size() == before;
}

// Reports crossings. The edge of the later loop is named first: a hole crosses the outline.
void crossings_report(const std::vector<OutlineCrossing>& found, const std::vector<std::string>& name,
                      const std::string& path, Problems& problems) {
  for (const OutlineCrossing& c : found) {
    const auto first = std::size_t(c.loop[0]), last = std::size_t(c.loop[1]);
    std::string what = "edge " + std::to_string(c.edge[first == last ? 0 : 1]);
    what += c.crosses ? " crosses " : " touches ";
    if (first != last) what += "edge " + std::to_string(c.edge[0]) + " of " + name[first];
    else what += c.edge[0] == c.edge[1] ? "itself" : "edge " + std::to_string(c.edge[1]);
    problems.push_back(
        {path + name[last], "is no simple outline: " + what + " at " + scene::point_text(c.at)});
  }
}

// Checks, for loops that do not cross, that each hole is inside the outline and not inside another hole.
void nesting_check(const std::vector<OutlineLoop>& loops, const std::string& path, Problems& problems) {
  for (std::size_t h = 1; h < loops.size(); ++h) {
    const Vec2 p = loops[h].points[0];
    if (!outline_contains({loops[0]}, p))
      problems.push_back({path + "." + loop_name(h), "lies outside the outline, at " + scene::point_text(p)});
    for (std::size_t k = 1; k < loops.size(); ++k)
      if (k != h && outline_contains({loops[k]}, p))
        problems.push_back({path + "." + loop_name(h), "lies inside " + loop_name(k) + ", at " +
                                                           scene::point_text(p) + "; holes do not nest"});
  }
}

void cell_check(const scene::PieceSpec& piece, const std::vector<OutlineLoop>& loops, const std::string& path,
                Problems& problems) {
  if (!(piece.cell > 0)) return;
  Extent plane, turned;
  const double c = std::cos(piece.grain), s = std::sin(piece.grain);
  for (const Vec2& p : loops[0].points) {
    extent_grow(plane, p);
    extent_grow(turned, {p[0] * c + p[1] * s, p[1] * c - p[0] * s});
  }
  const double shorter = std::min(plane.along(0), plane.along(1));
  const double nodes = (turned.along(0) / piece.cell + 1) * (turned.along(1) / piece.cell + 1);
  const std::string value = "= " + scene::number_text(piece.cell) + " m";
  if (piece.cell > shorter * (1 + 1e-9))
    problems.push_back({path + ".cell", value + "; allowed: at most the piece's shorter side, " +
                                            scene::rounded(shorter) + " m"});
  if (nodes > kMaxNodes)
    problems.push_back({path + ".cell", value + " makes about " + scene::rounded(nodes) +
                                            " nodes; allowed: at most " + scene::rounded(kMaxNodes) +
                                            " a piece"});
}

// A cell size for flattening curves before that of the piece is known to be valid: at least 1e-4 of the
// piece.
double drawing_cell(const scene::PieceSpec& piece) {
  Extent e;
  for (const Vec2& p : piece.outline) extent_grow(e, p);
  for (const scene::CurveSpec& curve : piece.curves) {
    for (const Vec2& p : curve.bezier) extent_grow(e, p);
    if (curve.large && curve.bezier.empty())
      extent_grow(e, {e.low[0] + 2 * curve.radius, e.low[1] + 2 * curve.radius});
  }
  return std::max(piece.cell, 1e-4 * e.size());
}

}  // namespace

void polygon_problems(const std::vector<Vec2>& polygon, const std::string& path, Problems& problems) {
  if (polygon.empty()) return;  // could not be read
  scene::PieceSpec piece;
  piece.outline = polygon;
  const double contact = outline_touch(piece);
  if (!points_check(polygon, path, contact, problems) || !area_check(polygon, path, contact, problems))
    return;
  crossings_report(outline_crossings(outline_flatten(piece), contact, kMaxCrossings), {""}, path, problems);
}

void outline_problems(const scene::PieceSpec& piece, const std::string& path, Problems& problems) {
  if (piece.outline.empty()) return;  // could not be read
  const std::size_t before = problems.size();
  const double contact = outline_touch(piece);
  if (points_check(piece.outline, path + ".outline", contact, problems) && piece.curves.empty())
    area_check(piece.outline, path + ".outline", contact, problems);
  for (std::size_t h = 0; h < piece.holes.size(); ++h)
    if (const std::string at = scene::entry(path + ".holes", h);
        points_check(piece.holes[h], at, contact, problems))
      area_check(piece.holes[h], at, contact, problems);
  curves_check(piece, path, problems);
  if (problems.size() > before) return;

  scene::PieceSpec drawn = piece;
  drawn.cell = drawing_cell(piece);
  cell_check(piece, outline_flatten(drawn), path, problems);
  if (problems.size() == before && piece.cell > 0) drawn.cell = piece.cell;
  const std::vector<OutlineLoop> loops = outline_flatten(drawn);
  std::vector<std::string> name;
  for (std::size_t l = 0; l < loops.size(); ++l) name.push_back(loop_name(l));
  const std::vector<OutlineCrossing> found =
      outline_crossings(loops, contact + 2e-9 * drawn.cell, kMaxCrossings);
  crossings_report(found, name, path + ".", problems);
  if (!found.empty()) return;
  if (is_flat(loops[0].points, contact)) problems.push_back({path + ".outline", "encloses no area"});
  nesting_check(loops, path, problems);
}

}  // namespace drape::piece
