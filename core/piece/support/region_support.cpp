// The nodes that a region supports: those inside it or on its boundary, and the corners of cells whose cloth
// is inside. The region is cut along the grid like the piece, so only cells on its boundary need a detailed
// test. core/README.md, section 4.
#include "piece/support/region_support.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "piece/grid/cut.h"
#include "piece/outline/outline.h"

namespace drape::piece {
namespace {

constexpr double kMin = 0.2;  // smallest s

double cross(Vec2 a, Vec2 p, Vec2 q) { return (p[0] - a[0]) * (q[1] - a[1]) - (p[1] - a[1]) * (q[0] - a[0]); }

// The part of the region in the half plane sign (v[axis] - bound) >= 0 (Sutherland and Hodgman 1974).
std::vector<Vec2> clipped(const std::vector<Vec2>& polygon, std::size_t axis, double bound, double sign) {
  std::vector<Vec2> kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2 p = polygon[k], q = polygon[(k + 1) % polygon.size()];
    const double a = sign * (p[axis] - bound), b = sign * (q[axis] - bound);
    if (a >= 0) kept.push_back(p);
    if ((a < 0) == (b < 0)) continue;
    Vec2 r;
    r[axis] = bound;
    r[1 - axis] = cut_snapped(p[1 - axis] + a / (a - b) * (q[1 - axis] - p[1 - axis]));
    if (kept.empty() || r != kept.back()) kept.push_back(r);
  }
  return kept;
}

struct Region {
  const Grid& grid;
  std::vector<Vec2> polygon;  // in cells, clipped slightly outside the grid
  Cut cut;                    // cut of the region; its parts are not used
  std::vector<char> held;     // [nodes]
};

Region region_make(const Grid& grid, const std::vector<Vec2>& polygon) {
  Region region{grid, {}, {}, std::vector<char>(std::size_t(grid.nodes()), 0)};
  for (const Vec2& p : polygon) region.polygon.push_back(grid_coordinates(grid, p));
  if (polygon_area(region.polygon) < 0) std::reverse(region.polygon.begin(), region.polygon.end());
  for (std::size_t axis : {0u, 1u}) {
    region.polygon = clipped(region.polygon, axis, -2, 1);
    region.polygon = clipped(region.polygon, axis, (axis ? grid.rows : grid.columns) + 1, -1);
  }
  if (region.polygon.size() > 2) region.cut = cut_make({region.polygon});
  return region;
}

// State of a place of the grid: kPlaceOutside, kPlaceWhole or, where the boundary cuts it, a part number.
int place_state(const Region& r, int i, int j) {
  const int column = i - r.cut.i0, row = j - r.cut.j0;
  if (column < 0 || row < 0 || column >= r.cut.columns || row >= r.cut.rows) return kPlaceOutside;
  return r.cut.first[std::size_t(row * r.cut.columns + column)];
}

// True if p -> q crosses the boundary rather than just touching it.
bool crosses_rim(const Region& r, Vec2 p, Vec2 q) {
  for (std::size_t k = 0, n = r.polygon.size(); k < n; ++k) {
    const Vec2 a = r.polygon[k], b = r.polygon[(k + 1) % n];
    const double ap = cross(a, b, p), aq = cross(a, b, q), pa = cross(p, q, a), pb = cross(p, q, b);
    const double rim = kSnap * std::hypot(b[0] - a[0], b[1] - a[1]);
    const double own = kSnap * std::hypot(q[0] - p[0], q[1] - p[1]);
    if (std::min(ap, aq) < -rim && std::max(ap, aq) > rim && std::min(pa, pb) < -own &&
        std::max(pa, pb) > own)
      return true;
  }
  return false;
}

// True if a polygon of cloth (in cells) at a place is inside the region: its corners are, and no edge or
// corner of the boundary extends into it.
bool is_inside(const Region& r, int i, int j, const std::vector<Vec2>& cloth) {
  const int state = place_state(r, i, j);
  if (state == kPlaceWhole || state == kPlaceOutside) return state == kPlaceWhole;
  for (std::size_t k = 0; k < cloth.size(); ++k)
    if (polygon_distance(r.polygon, cloth[k]) > kSnap ||
        crosses_rim(r, cloth[k], cloth[(k + 1) % cloth.size()]))
      return false;
  return std::none_of(r.polygon.begin(), r.polygon.end(), [&](Vec2 p) {
    double edge = INFINITY;
    for (std::size_t k = 0; k < cloth.size(); ++k)
      edge = std::min(edge, polygon_distance({cloth[k], cloth[(k + 1) % cloth.size()]}, p));
    return edge > kSnap && polygon_distance(cloth, p) == 0;
  });
}

// [cells] 1 where all cloth of the cell is inside: that of its place and that of parts merged into it.
std::vector<char> cells_inside(const Region& r) {
  const Grid& grid = r.grid;
  std::vector<char> inside(grid.cells.size(), 1);
  for (std::size_t c = 0; c < grid.cells.size(); ++c) {
    const GridCell& cell = grid.cells[c];
    const double x = cell.i, y = cell.j;
    if (!grid_is_cut(grid, cell.i, cell.j))
      inside[c] = is_inside(r, cell.i, cell.j, {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}});
  }
  for (const GridPart& part : grid.parts) {
    if (grid.paper || !inside[std::size_t(part.cell)]) continue;
    std::vector<Vec2> cloth;
    for (const Vec2& p : part.loops[0]) cloth.push_back(grid_coordinates(grid, p));
    if (!is_inside(r, part.i, part.j, cloth)) inside[std::size_t(part.cell)] = 0;
  }
  return inside;
}

// Marks the nodes that the region supports.
void nodes_mark(Region& r) {
  const Grid& grid = r.grid;
  for (int n = 0; n < grid.nodes(); ++n) {
    if (grid.area[std::size_t(n)] == 0) continue;
    const auto [i, j] = grid.index(n);
    bool rim = false;
    for (int k = 0; k < 4; ++k) {
      const int state = place_state(r, i - k % 2, j - k / 2);
      if (state == kPlaceWhole) r.held[std::size_t(n)] = 1;
      rim = rim || state != kPlaceOutside;
    }
    if (rim && polygon_distance(r.polygon, {double(i), double(j)}) <= kSnap) r.held[std::size_t(n)] = 1;
  }
  const std::vector<char> inside = cells_inside(r);
  for (std::size_t c = 0; c < inside.size(); ++c)
    if (inside[c])
      for (int n : grid.cells[c].node) r.held[std::size_t(n)] = 1;
}

// The share of a link that is outside the region.
double share_outside(const Region& r, int from, int to) {
  const auto [i, j] = r.grid.index(from);
  const auto [k, l] = r.grid.index(to);
  const Vec2 p{double(i), double(j)}, q{double(k), double(l)};
  std::vector<double> at{0, 1};  // where it crosses the boundary
  for (std::size_t m = 0, n = r.polygon.size(); m < n; ++m) {
    const Vec2 u = r.polygon[m], v = r.polygon[(m + 1) % n];
    const double a = cross(p, q, u), b = cross(p, q, v);
    if ((a > 0) == (b > 0)) continue;
    const double t = a / (a - b), x = u[0] + t * (v[0] - u[0]), y = u[1] + t * (v[1] - u[1]);
    at.push_back(std::clamp((x - p[0]) * (q[0] - p[0]) + (y - p[1]) * (q[1] - p[1]), 0.0, 1.0));
  }
  std::sort(at.begin(), at.end());
  double outside = 0;
  for (std::size_t m = 0; m + 1 < at.size(); ++m) {
    const double t = (at[m] + at[m + 1]) / 2;
    const Vec2 middle{p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])};
    if (polygon_distance(r.polygon, middle) > 0) outside += at[m + 1] - at[m];
  }
  return outside;
}

// A link from a supported node to one that is not.
struct Leaving {
  int from, to;
  bool warp;
  double free;  // s
};

std::vector<Leaving> links_leaving(const Region& r) {
  std::map<std::pair<int, int>, bool> found;  // (from, to) -> warp
  for (const GridCell& c : r.grid.cells)
    for (const auto& [k, l] : {std::pair{0, 2}, {1, 3}, {0, 1}, {2, 3}}) {
      const int a = c.node[k], b = c.node[l];
      if (r.held[std::size_t(a)] == r.held[std::size_t(b)]) continue;
      found.emplace(r.held[std::size_t(a)] ? std::pair{a, b} : std::pair{b, a}, l - k == 2);
    }
  std::vector<Leaving> links;
  for (const auto& [ends, warp] : found)
    links.push_back({ends.first, ends.second, warp, share_outside(r, ends.first, ends.second)});
  return links;
}

// Also supports nodes that are only slightly outside. The next link of their yarn then includes the free
// length before it.
std::vector<Leaving> links_lengthened(Region& r) {
  std::vector<Leaving> near = links_leaving(r);
  std::erase_if(near, [](const Leaving& link) { return link.free >= kMin; });
  for (const Leaving& link : near) r.held[std::size_t(link.to)] = 1;
  std::vector<Leaving> links = links_leaving(r);
  const auto step = [&](const Leaving& link) {
    const auto a = r.grid.index(link.from), b = r.grid.index(link.to);
    return std::array<int, 2>{b[0] - a[0], b[1] - a[1]};
  };
  for (Leaving& link : links) {
    const auto before = std::find_if(near.begin(), near.end(), [&](const Leaving& b) {
      return b.to == link.from && step(b) == step(link);
    });
    if (before != near.end()) link.free += before->free;
    link.free = std::max(link.free, kMin);
  }
  return links;
}

}  // namespace

RegionSupport region_support(const Grid& grid, const std::vector<Vec2>& polygon, bool clamp) {
  Region region = region_make(grid, polygon);
  RegionSupport support;
  nodes_mark(region);
  if (clamp)
    for (const Leaving& link : links_lengthened(region)) {
      const double s = link.free;
      support.slopes.push_back({link.from, link.to, link.warp, 1 / (s * s), 2 * s - s * s, true});
    }
  for (int n = 0; n < grid.nodes(); ++n)
    if (region.held[std::size_t(n)]) support.nodes.push_back(n);
  return support;
}

}  // namespace drape::piece
