#include "contact/self/search.h"

#include <algorithm>
#include <cmath>

#include "contact/self/mesh.h"
#include "math/closest_points.h"
#include "math/vector3.h"

namespace drape::contact {
namespace {

using namespace math::vector3;

constexpr double kFarthest = 1e15;  // buckets

// The bounding ball of a cell, and the bucket of its centre.
struct Ball {
  Vec3 centre;
  double radius;
  std::array<std::int64_t, 3> bucket;
};

Vec3 place(const State& s, model::NodeIndex n) { return {s.x[n], s.y[n], s.z[n]}; }

std::vector<Ball> balls_of(const model::SelfMesh& mesh, const State& s) {
  std::vector<Ball> balls;
  balls.reserve(mesh.cell.size());
  for (const model::SelfCell& cell : mesh.cell) {
    Ball ball{{0, 0, 0}, 0, {}};
    for (model::NodeIndex n : cell.node) ball.centre += 0.25 * place(s, n);
    for (model::NodeIndex n : cell.node) ball.radius = std::max(ball.radius, norm(place(s, n) - ball.centre));
    balls.push_back(ball);
  }
  return balls;
}

// Cells by the hash of their bucket: those of hash k are item[start[k]] .. item[start[k + 1] - 1].
struct Buckets {
  std::size_t mask = 0;
  std::vector<std::uint32_t> start, item;
};

std::size_t bucket_hash(const Buckets& b, const std::array<std::int64_t, 3>& at) {
  const auto mixed = std::uint64_t(at[0]) * 0x9e3779b97f4a7c15u + std::uint64_t(at[1]) * 0xc2b2ae3d27d4eb4fu +
                     std::uint64_t(at[2]) * 0x165667b19e3779f9u;
  return (mixed ^ (mixed >> 29)) & b.mask;
}

Buckets buckets_fill(std::vector<Ball>& balls, double width) {
  Buckets b;
  std::size_t slots = 16;
  while (slots < 2 * balls.size()) slots *= 2;
  b.mask = slots - 1;
  b.start.assign(slots + 1, 0);
  b.item.resize(balls.size());
  for (Ball& ball : balls) {
    for (std::size_t k = 0; k < 3; ++k) ball.bucket[k] = std::int64_t(std::floor(ball.centre[k] / width));
    ++b.start[bucket_hash(b, ball.bucket) + 1];
  }
  for (std::size_t k = 0; k < slots; ++k) b.start[k + 1] += b.start[k];
  std::vector<std::uint32_t> next(b.start.begin(), b.start.end() - 1);
  for (std::size_t k = 0; k < balls.size(); ++k)
    b.item[next[bucket_hash(b, balls[k].bucket)]++] = std::uint32_t(k);
  return b;
}

// Visits all pairs of cells in one bucket or in two adjacent ones, once.
template <class Visit>
void each_near(const Buckets& b, const std::vector<Ball>& balls, Visit visit) {
  std::vector<std::uint32_t> here, around;
  const auto collect = [&](const std::array<std::int64_t, 3>& at, std::vector<std::uint32_t>& to) {
    const std::size_t hash = bucket_hash(b, at);
    for (std::uint32_t k = b.start[hash]; k < b.start[hash + 1]; ++k)
      if (const auto& of = balls[b.item[k]].bucket; of[0] == at[0] && of[1] == at[1] && of[2] == at[2])
        to.push_back(b.item[k]);
  };
  for (std::size_t a = 0; a < balls.size(); ++a) {
    const auto& at = balls[a].bucket;
    here.clear();
    around.clear();
    collect(at, here);
    if (here.front() != a) continue;  // a bucket is visited at its first cell
    for (int k = 14; k < 27; ++k)     // half of the 26 neighbours
      collect({at[0] + k / 9 - 1, at[1] + k / 3 % 3 - 1, at[2] + k % 3 - 1}, around);
    for (std::size_t p = 0; p < here.size(); ++p) {
      for (std::size_t q = p + 1; q < here.size(); ++q) visit(here[p], here[q]);
      for (std::uint32_t q : around) visit(here[p], q);
    }
  }
}

struct Search {
  const System& system;
  const model::SelfMesh& mesh;
  const State& state;
  double margin;
};

// Whether two elements are far enough from each other along the cloth to touch.
bool apart(const model::SelfMesh& mesh, const model::SelfCell& a, const model::SelfBox& of,
           const model::SelfCell& b, const model::SelfBox& on) {
  if (a.lattice != b.lattice) return true;
  const int columns = std::max(on.low[0] - of.high[0], of.low[0] - on.high[0]);
  const int rows = std::max(on.low[1] - of.high[1], of.low[1] - on.high[1]);
  return std::max(columns, rows) >= mesh.exclusion_cells[std::size_t(a.lattice)];
}

model::SelfBox box_of(const model::SelfCell& cell) { return {{cell.i, cell.j}, {cell.i + 1, cell.j + 1}}; }

double contact_distance_of(const Search& s, model::NodeIndex a, model::NodeIndex b) {
  return self_contact_distance(s.system, s.mesh.lattice_of[a], s.mesh.lattice_of[b]);
}

// Whether a slab normal to `between`, wider than `reach`, separates two things: from the middle of one to
// that of the other, less the half width of both along it.
bool slab_separates(const Vec3& between, double half_widths, double reach) {
  const double length2 = dot(between, between), gap = length2 - half_widths;
  return gap > 0 && gap * gap > reach * reach * length2;
}

// The same for a point and a cell.
bool is_separated(const State& s, const Vec3& at, const model::SelfCell& cell, double reach) {
  const Vec3 middle = 0.5 * (place(s, cell.node[0]) + place(s, cell.node[3])), between = at - middle;
  double widest = -INFINITY;
  for (model::NodeIndex n : cell.node) widest = std::max(widest, dot(place(s, n) - middle, between));
  return slab_separates(between, widest, reach);
}

// Finds pairs of the particles of one cell and the triangles of another.
void points_find(const Search& s, const model::SelfCell& of, const model::SelfCell& on,
                 model::SelfPairs& found) {
  for (int k = of.node_first; k < of.node_end; ++k) {
    const model::NodeIndex n = s.mesh.own_node[std::size_t(k)];
    if (!apart(s.mesh, of, s.mesh.box[n], on, box_of(on))) continue;
    const Vec3 at = place(s.state, n);
    if (is_separated(s.state, at, on, contact_distance_of(s, n, on.node[0]) + s.margin)) continue;
    for (const auto& t :
         {std::array{on.node[0], on.node[1], on.node[3]}, std::array{on.node[0], on.node[3], on.node[2]}}) {
      model::SelfPoint pair{{n, t[0], t[1], t[2]}, contact_distance_of(s, n, t[0]), 0};
      pair.start = std::min(pair.contact_distance, s.mesh.max_contact_distance[n]);
      if (!s.mesh.parts[n]) pair.contact_distance = pair.start;
      const double reach = pair.contact_distance + s.margin;
      const math::TriangleClosest closest =
          math::triangle_closest(at, place(s.state, t[0]), place(s.state, t[1]), place(s.state, t[2]));
      if (closest.distance2 <= reach * reach) found.point.push_back(pair);
    }
  }
}

void crosses_find(const Search& s, const model::SelfCell& a, const model::SelfCell& b,
                  model::SelfPairs& found) {
  for (int i = a.edge_first; i < a.edge_end; ++i)
    for (int j = b.edge_first; j < b.edge_end; ++j) {
      model::NodeIndex e = model::NodeIndex(i), f = model::NodeIndex(j);
      if (!apart(s.mesh, a, s.mesh.edge[e].box, b, s.mesh.edge[f].box)) continue;
      if (s.mesh.edge[f].node[0] < s.mesh.edge[e].node[0]) std::swap(e, f);
      const model::NodeIndex *from = s.mesh.edge[e].node, *to = s.mesh.edge[f].node;
      model::SelfCross pair{
          {from[0], from[1], to[0], to[1]}, {e, f}, contact_distance_of(s, from[0], to[0]), 0};
      pair.start = pair.contact_distance;
      for (model::NodeIndex n : pair.node) {
        pair.start = std::min(pair.start, s.mesh.max_contact_distance[n]);
        if (!s.mesh.parts[n])
          pair.contact_distance = std::min(pair.contact_distance, s.mesh.max_contact_distance[n]);
      }
      const double reach = pair.contact_distance + s.margin;
      const Vec3 a0 = place(s.state, pair.node[0]), a1 = place(s.state, pair.node[1]),
                 b0 = place(s.state, pair.node[2]), b1 = place(s.state, pair.node[3]);
      const Vec3 between = 0.5 * ((a0 + a1) - (b0 + b1));
      const double half_widths = 0.5 * (std::abs(dot(a1 - a0, between)) + std::abs(dot(b1 - b0, between)));
      if (slab_separates(between, half_widths, reach)) continue;
      if (math::edges_closest(a0, a1, b0, b1).distance2 <= reach * reach) found.cross.push_back(pair);
    }
}

// Whether a slab normal to the line of centres, wider than `reach`, separates the cells.
bool are_separated(const State& s, const model::SelfCell& a, const model::SelfCell& b, const Vec3& between,
                   double reach) {
  double end = -INFINITY, begin = INFINITY;
  for (model::NodeIndex n : a.node) end = std::max(end, dot(place(s, n), between));
  for (model::NodeIndex n : b.node) begin = std::min(begin, dot(place(s, n), between));
  return begin - end > reach * norm(between);
}

// Visits all pairs of cells that may be nearer than `reach` (m), but for those that a seam excludes.
template <class Visit>
void each_pair(const model::SelfMesh& mesh, const State& state, double reach, Visit visit) {
  std::vector<Ball> balls = balls_of(mesh, state);
  double largest = 0, farthest = 0;
  for (const Ball& ball : balls) {
    largest = std::max(largest, ball.radius);
    farthest += std::abs(ball.centre[0]) + std::abs(ball.centre[1]) + std::abs(ball.centre[2]);
  }
  const double width = 2 * largest + reach;
  if (!(width > 0 && farthest < kFarthest * width)) return;  // the state is not finite
  const Buckets buckets = buckets_fill(balls, width);
  each_near(buckets, balls, [&](std::size_t p, std::size_t q) {
    const std::size_t a = std::min(p, q), b = std::max(p, q);
    const Vec3 between = balls[b].centre - balls[a].centre;
    const double far = balls[a].radius + balls[b].radius + reach;
    if (dot(between, between) > far * far || are_separated(state, mesh.cell[a], mesh.cell[b], between, reach))
      return;
    if (!self_cells_sewn(mesh, mesh.cell[a], mesh.cell[b])) visit(mesh.cell[a], mesh.cell[b]);
  });
}

}  // namespace

model::SelfPairs self_search(const System& system, const model::SelfMesh& mesh, const State& state,
                             double margin) {
  const Search search{system, mesh, state, margin};
  model::SelfPairs found;
  each_pair(mesh, state, mesh.contact_distance + margin,
            [&](const model::SelfCell& a, const model::SelfCell& b) {
              points_find(search, a, b, found);
              points_find(search, b, a, found);
              crosses_find(search, a, b, found);
            });
  const auto by_nodes = [](const auto& p, const auto& q) {
    return std::lexicographical_compare(p.node, p.node + 4, q.node, q.node + 4);
  };
  std::sort(found.point.begin(), found.point.end(), by_nodes);
  std::sort(found.cross.begin(), found.cross.end(), by_nodes);
  return found;
}

namespace {

constexpr double kInPlane = 1e-9;  // distance from a plane over the size of what lies in it

// Whether p -> q goes through the triangle a b c: its ends are on both sides of the plane, and the corners
// lie around the line. What lies in the plane but for rounding, as in a piece that starts flat, does not.
bool goes_through(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto volume = [](const Vec3& u, const Vec3& v, const Vec3& w) { return dot(u, cross(v, w)); };
  const Vec3 n = cross(b - a, c - a);
  const double before = dot(p - a, n), after = dot(q - a, n), in_plane = kInPlane * norm(n) * norm(q - p);
  if (!(before * after < 0 && std::min(std::abs(before), std::abs(after)) > in_plane)) return false;
  const Vec3 along = q - p;
  const double x = volume(along, a - p, b - p), y = volume(along, b - p, c - p),
               z = volume(along, c - p, a - p);
  return (x > 0 && y > 0 && z > 0) || (x < 0 && y < 0 && z < 0);
}

}  // namespace

std::vector<SelfCut> self_cuts(const model::SelfMesh& mesh, const State& s) {
  std::vector<SelfCut> cuts;
  const auto edges_through = [&](const model::SelfCell& of, const model::SelfCell& on) {
    for (int k = of.edge_first; k < of.edge_end; ++k) {
      const model::SelfEdge& e = mesh.edge[std::size_t(k)];
      if (!apart(mesh, of, e.box, on, box_of(on))) continue;
      const Vec3 p = place(s, e.node[0]), q = place(s, e.node[1]), a = place(s, on.node[0]),
                 d = place(s, on.node[3]);
      if (goes_through(p, q, a, place(s, on.node[1]), d) || goes_through(p, q, a, d, place(s, on.node[2])))
        cuts.push_back({{of.lattice, on.lattice}, 0.5 * (p + q)});
    }
  };
  each_pair(mesh, s, 0, [&](const model::SelfCell& a, const model::SelfCell& b) {
    edges_through(a, b);
    edges_through(b, a);
  });
  return cuts;
}

}  // namespace drape::contact
