// Where the contact of particles is enough. A straight link between two particles at the contact distance L
// from both faces of a sharp edge is at d = L cos a - x sin a from the edge. x is the distance along the link
// from the edge to its end, and a the angle of the link with the face there. Where sin a <= s for one of the
// faces, the link sinks in by no more than b s. With s = L/(8 b) that is L/8, and the link is left to its
// particles. So is an edge of turn T at which not even the symmetric link, a = T/2, x = b/2, sinks in by more
// than that: (b/2) sin(T/2) <= L/8.
#include "contact/edge/elements.h"

#include <algorithm>
#include <map>

#include "model/elements.h"

namespace drape::contact {
namespace {

constexpr double kSink = 0.125;    // of the contact distance
constexpr double kMaxSink = 0.75;  // of the contact distance: deeper, particles do not bear a link
constexpr double kFollowed = 2;    // cells: how far a face is followed
constexpr double kMargin = 0.25;   // of a cell
constexpr double kStretched = 1;   // of a cell: how far the nearer end of a link may be from what it touches
constexpr double kBucket = 2;      // of edge_near

void cell_add(const std::size_t* corner, int lattice,
              std::map<std::array<std::uint32_t, 2>, std::size_t>& links, model::EdgeElements& cloth) {
  constexpr int kSide[4][4] = {
      {0, 1, 2, 3}, {2, 3, 0, 1}, {0, 2, 1, 3}, {1, 3, 0, 2}};  // ends, and nodes across
  model::EdgeElement cell{{}, 4, true, lattice};
  for (int k = 0; k < 4; ++k) cell.node[k] = std::uint32_t(corner[k]);
  cloth.element.push_back(cell);
  for (const auto& side : kSide) {
    std::uint32_t n[4];
    for (int k = 0; k < 4; ++k) n[k] = cell.node[side[k]];
    if (n[0] > n[1]) std::swap(n[0], n[1]), std::swap(n[2], n[3]);
    const auto [at, is_new] = links.try_emplace({n[0], n[1]}, cloth.element.size());
    if (is_new) {
      cloth.element.push_back({{n[0], n[1], n[2], n[3], 0, 0}, 4, false, lattice});
      continue;
    }
    model::EdgeElement& link = cloth.element[at->second];
    if (link.nodes == 6) continue;  // a third cell shares it
    link.node[4] = n[2], link.node[5] = n[3];
    link.nodes = 6;
  }
}

void nodes_number(std::size_t nodes, model::EdgeElements& cloth) {
  cloth.first.assign(nodes + 1, 0);
  const auto each = [&](auto visit) {
    for (std::size_t p = 0; p < cloth.element.size(); ++p)
      for (int k = 0; k < cloth.element[p].weights(); ++k) visit(cloth.element[p].node[k], std::uint32_t(p));
  };
  each([&](std::uint32_t n, std::uint32_t) { ++cloth.first[n + 1]; });
  for (std::size_t n = 0; n < nodes; ++n) cloth.first[n + 1] += cloth.first[n];
  cloth.of_node.resize(cloth.first[nodes]);
  std::vector<std::uint32_t> next = cloth.first;
  each([&](std::uint32_t n, std::uint32_t p) { cloth.of_node[next[n]++] = p; });
}

}  // namespace

double edge_sine(const model::Lattice& l) { return kSink * l.contact_law.distance / l.cell; }
double edge_margin(const model::Lattice& l) { return kMargin * l.cell; }
double edge_near(const model::Lattice& l) {
  return kStretched * l.cell + l.contact_law.distance + edge_margin(l);
}

void edge_elements_make(System& system) {
  body::SharpBounds bounds{INFINITY, 0, INFINITY, !system.fit, INFINITY, 0};
  double near = 0;
  for (const model::Lattice& l : system.lattices) {
    const double contact_distance = l.contact_law.distance;
    bounds.sine = std::min(bounds.sine, 2 * edge_sine(l));
    bounds.half = std::max(bounds.half, l.cell / 2);
    bounds.sink = std::min(bounds.sink, kMaxSink * contact_distance);
    bounds.bend = std::min(bounds.bend, kSink * contact_distance);
    bounds.longest = std::max(bounds.longest, kFollowed * l.cell);
    near = std::max(near, edge_near(l));
  }
  bounds.sine = std::max(bounds.sine, system.fit ? body::kSharpSineFit : body::kSharpSine);
  if (system.fit) bounds.sink = std::max(bounds.sink, bounds.sine * bounds.half);
  bool any = false;
  for (model::Body& body : system.bodies) {
    body.sharp = body::sharp_features_make(body.mesh.surface, bounds, kBucket * near);
    any = any || !body.sharp.feature.empty();
  }
  if (!any) return;
  std::map<std::array<std::uint32_t, 2>, std::size_t> links;
  for (const model::Lattice& l : system.lattices)
    model::cells_visit(system, l, [&](const std::size_t* corner, double) {
      cell_add(corner, l.piece, links, system.edge_elements);
    });
  nodes_number(system.nodes, system.edge_elements);
}

}  // namespace drape::contact
