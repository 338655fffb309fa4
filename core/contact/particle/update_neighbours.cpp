#include "contact/particle/update_neighbours.h"

#include <algorithm>
#include <cmath>

#include "math/vector3.h"

namespace drape::contact {
namespace {

using namespace math::vector3;

constexpr double kMin = 0.02;          // of the contact distance: the smallest free distance
constexpr double kUsed = 0.7;          // of the free distance: a particle that has used more is updated too
constexpr double kAhead = 1.5;         // steps that a particle is extrapolated by
constexpr double kListedEdges = 0.15;  // of the mean edge, beyond contact: how far triangles are listed

model::ContactBlock block_make(std::size_t node, int lattice) {
  model::ContactBlock b{};
  b.node = node;
  b.lattice = lattice;
  for (double& o : b.offset) o = -model::kFar;
  return b;
}

void lane_clear(model::ContactBlock& b, std::size_t i) {
  for (auto& row : b.side) row[i] = 0;
  b.offset[i] = -model::kFar;
  b.sink[i] = 0;
  b.sticking[i] = 0;
  for (auto& row : b.warm_start) row[i] = 0;
  b.shared[i] = 0;
}

void lane_set(model::ContactBlock& b, std::size_t i, const body::ClosestFeature& contact, double sink,
              double sticking) {
  for (std::size_t k = 0; k < 3; ++k) {
    b.side[k][i] = contact.side[k];
    b.point[k][i] = contact.point[k];
  }
  for (std::size_t k = 0; k < 6; ++k) b.shape[k][i] = contact.shape[k];
  b.offset[i] = dot(contact.side, contact.point);
  b.sink[i] = sink;
  b.sticking[i] = sticking;
}

bool is_flat(const model::ContactBlock& b) {
  constexpr double kRounding = 1e-12;
  for (std::size_t i = 0; i < std::size_t(math::kRowUnit); ++i) {
    if (b.offset[i] == -model::kFar) continue;
    const double trace =
        b.shape[0][i] + b.shape[3][i] + b.shape[5][i];  // 1 of a face, 2 of an edge, 3 of a vertex
    if (trace > 1 + kRounding) return false;
  }
  return true;
}

std::size_t place_first(const model::ContactBlocks& blocks, std::uint32_t node) {
  const auto at = std::lower_bound(blocks.order.begin(), blocks.order.end(), node,
                                   [](const model::ContactPlace& p, std::uint32_t n) { return p.node < n; });
  return std::size_t(at - blocks.order.begin());
}

std::size_t places_of(const model::ContactBlocks& blocks, std::size_t first, std::uint32_t node) {
  std::size_t count = 0;
  while (first + count < blocks.order.size() && blocks.order[first + count].node == node) ++count;
  return count;
}

void block_insert(model::ContactBlocks& blocks, std::size_t at, std::uint32_t node, int lattice) {
  std::uint32_t k = std::uint32_t(blocks.pool.size());
  if (blocks.free.empty()) {
    blocks.pool.push_back(block_make(std::size_t(node) * math::kRowUnit, lattice));
  } else {
    k = blocks.free.back();
    blocks.free.pop_back();
    blocks.pool[k] = block_make(std::size_t(node) * math::kRowUnit, lattice);
  }
  blocks.order.insert(blocks.order.begin() + std::ptrdiff_t(at), {node, k});
}

// What one particle may touch.
struct Listed {
  const std::vector<body::ClosestFeature>& contact;
  const std::vector<double>& sink;  // [triangles] m, or empty
  bool shared;                      // its links may touch sharp features as well
};

// Puts it into the blocks of the particle's node.
void lane_write(model::ContactBlocks& blocks, std::uint32_t node, int lattice, std::size_t lane,
                const Listed& listed) {
  const auto& [contact, sink, shared] = listed;
  const std::size_t first = place_first(blocks, node), count = places_of(blocks, first, node);
  const double sticking = count > 0 ? blocks.pool[blocks.order[first].block].sticking[lane] : 0;
  for (std::size_t k = contact.size(); k < count; ++k)
    lane_clear(blocks.pool[blocks.order[first + k].block], lane);
  for (std::size_t k = 0; k < contact.size(); ++k) {
    if (k >= count) block_insert(blocks, first + k, node, lattice);
    model::ContactBlock& b = blocks.pool[blocks.order[first + k].block];
    lane_set(b, lane, contact[k], sink.empty() ? 0 : sink[std::size_t(contact[k].triangle)],
             k == 0 ? sticking : 0);
    b.shared[lane] = contact.size() > 1 || shared ? 1 : 0;
  }
  for (std::size_t k = 0; k < std::max(count, contact.size()); ++k) {
    model::ContactBlock& b = blocks.pool[blocks.order[first + k].block];
    b.shares = std::any_of(b.shared, b.shared + math::kRowUnit, [](double is) { return is > 0; });
    b.flat = is_flat(b);
  }
}

void blocks_prune(model::ContactBlocks& blocks, std::uint32_t node) {
  const std::size_t first = place_first(blocks, node);
  for (std::size_t k = places_of(blocks, first, node); k-- > 0;) {
    const std::uint32_t block = blocks.order[first + k].block;
    if (!blocks.pool[block].empty()) continue;
    blocks.free.push_back(block);
    blocks.order.erase(blocks.order.begin() + std::ptrdiff_t(first + k));
  }
}

// The side of the nearest surface in the blocks so far; false where there is none.
bool side_known(const model::ContactBlocks& blocks, std::uint32_t node, std::size_t lane, Vec3& side) {
  const std::size_t first = place_first(blocks, node);
  if (places_of(blocks, first, node) == 0) return false;
  const model::ContactBlock& b = blocks.pool[blocks.order[first].block];
  if (b.offset[lane] == -model::kFar) return false;
  side = {b.side[0][lane], b.side[1][lane], b.side[2][lane]};
  return true;
}

}  // namespace

double search_reach(const body::BodySurface& surface, double contact_distance) {
  return std::max(kListedDistances * contact_distance, contact_distance + kListedEdges * surface.edge_mean);
}

namespace {

// How far (m) a node may move until its distance to sharp features must be found again; marks whether one is
// near. Infinite where it is marked, or the body has none.
struct MovingNode {
  std::size_t n;
  const Vec3& x;           // m, in the body's frame
  double clearance, step;  // m: at least to the surface; of the next step
};
double edge_travel(const SharpRange& of, model::EdgeContact& c, const MovingNode& node,
                   std::vector<std::uint32_t>& scratch) {
  if (of.sharp.feature.empty()) return INFINITY;
  const auto& [n, x, clearance, step] = node;
  const double within = of.within + 2 * kAhead * step;
  double distance = clearance;
  if (distance <= within + of.margin)
    distance = body::sharp_features_distance(of.sharp, x, within + 2 * of.margin, scratch);
  const bool near = distance <= within + of.margin;
  if (near && !c.near[n]) c.fresh.push_back(std::uint32_t(n));
  c.near[n] = near;
  return near ? INFINITY : distance - within;
}

}  // namespace

void update_neighbours(const NeighbourBody& body, const NeighbourNodes& nodes, NeighbourScratch& scratch,
                       model::BodyContact& c) {
  body::ClosestFeatures& found = scratch.found;
  const auto& [surface, grid, features] = body;
  const auto& [node, lattice, contact_distance, x, step] = nodes;
  const auto name = std::uint32_t(node / math::kRowUnit);
  for (std::size_t i = 0; i < std::size_t(math::kRowUnit); ++i) {
    const std::size_t n = node + i;
    const Vec3 moved = x[i] + step[i] - Vec3{c.x[n], c.y[n], c.z[n]};
    if (!(dot(moved, moved) >= kUsed * kUsed * c.free_distance2[n])) continue;
    const body::Neighbourhood near = body::distance_grid_at(grid, x[i]);
    found.feature.clear();
    found.free_distance = near.clearance - contact_distance;
    Vec3 side{};
    if (near.triangle)
      body::closest_features_find(
          surface, *near.triangle,
          {x[i], contact_distance,
           std::min(std::max(kKeptDistances * contact_distance, contact_distance + kAhead * norm(step[i])),
                    grid.reach),
           grid.reach, near.listed, side_known(c.blocks, name, i, side) ? &side : nullptr},
          scratch.features, found);
    const double edge_free =
        edge_travel(features, c.edges, {n, x[i], near.clearance, norm(step[i])}, scratch.sharp);
    const double free_distance = std::max(std::min(found.free_distance, edge_free), kMin * contact_distance);
    c.x[n] = x[i][0], c.y[n] = x[i][1], c.z[n] = x[i][2];
    c.free_distance2[n] = free_distance * free_distance;
    const bool shared = !c.edges.near.empty() && c.edges.near[n];
    lane_write(c.blocks, name, lattice, i, {found.feature, features.sharp.sink, shared});
  }
  blocks_prune(c.blocks, name);
}

}  // namespace drape::contact
