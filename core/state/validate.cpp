#include "state/validate.h"

#include <algorithm>

namespace drape::state {
namespace {

// Whether every node is one of a particle.
template <class Nodes>
bool all_particles(const System& system, const Nodes& nodes) {
  return std::all_of(std::begin(nodes), std::end(nodes), [&](std::size_t n) { return system.mass[n] > 0; });
}

bool blocks_agree(const System& system, const model::ContactBlocks& blocks) {
  const auto in_pool = [&](std::uint32_t k) { return k < blocks.pool.size(); };
  if (!std::all_of(blocks.free.begin(), blocks.free.end(), in_pool)) return false;
  for (const model::ContactBlock& b : blocks.pool) {
    const model::Lattice& l = system.lattices[std::size_t(b.lattice)];
    if (b.node % math::kRowUnit != 0 || !l.owns(b.node)) return false;
  }
  std::uint32_t before = 0;
  for (const model::ContactPlace& place : blocks.order) {
    if (!in_pool(place.block) || place.node < before) return false;
    if (blocks.pool[place.block].node != std::size_t(place.node) * math::kRowUnit) return false;
    before = place.node;
  }
  return true;
}

bool edges_agree(const System& system, const model::Body& body, const model::EdgeContact& c) {
  const std::size_t features = body.sharp.feature.size();
  if (c.near.size() != (features > 0 ? system.nodes : 0)) return false;
  if (features == 0 && !(c.fresh.empty() && c.node.empty() && c.pair.empty())) return false;
  if (c.last.size() != c.node.size() || c.from.size() != c.node.size()) return false;
  if (c.active_after_travel.size() != c.pair.size()) return false;
  return all_particles(system, c.fresh) && all_particles(system, c.node) &&
         std::is_sorted(c.node.begin(), c.node.end()) &&
         std::all_of(c.pair.begin(), c.pair.end(),
                     [&](const model::EdgePair& pair) { return pair.feature < features; });
}

bool self_agrees(const System& system, const model::SelfState& self) {
  const bool enabled = !system.self.cell.empty();
  if (bool(self.pairs) != enabled) return false;
  const std::size_t size = enabled ? self.pairs->size() : 0,
                    blocks = (size + model::kPairsPerBlock - 1) / model::kPairsPerBlock;
  if (self.active_after_travel.size() != size || self.block_active_after_travel.size() != blocks)
    return false;
  if (!enabled) return self.hold.empty();
  return std::all_of(self.pairs->point.begin(), self.pairs->point.end(),
                     [&](const model::SelfPoint& p) { return all_particles(system, p.node); }) &&
         std::all_of(self.pairs->cross.begin(), self.pairs->cross.end(),
                     [&](const model::SelfCross& p) { return all_particles(system, p.node); });
}

std::string relaxation_problem(const System& system, const State& s) {
  const model::RelaxationState& r = s.relaxation;
  const bool stores = r.measure_every > 0;
  for (std::size_t k = 0; stores && k < 3; ++k)
    if (r.place[k].size() != system.nodes || r.force[k].size() != system.nodes)
      return "relaxation.place is empty, but a measurement is under way";
  if (!s.inverse_mass_scale.empty())
    for (const std::size_t n : system.particle)
      if (!(s.inverse_mass_scale[n] > 0)) return "inverse_mass_scale is 0 at a particle";
  return system.fit || s.inverse_mass_scale.empty() ? "" : "inverse_mass_scale belongs to a fit";
}

}  // namespace

Shape shape_of(const System& system) {
  Shape shape;
  shape[Length::kNodes] = shape[Length::kNodesOrNone] = system.nodes;
  shape[Length::kGroups] = system.nodes / math::kRowUnit;
  shape[Length::kPins] = system.constraints.pins.size();
  shape[Length::kBodies] = system.bodies.size();
  shape[Length::kPairs] = system.seams.pair.size();
  shape[Length::kPairNumbers] = 3 * system.seams.pair.size();
  shape[Length::kSelfEdges] = system.self.edge.size();
  shape[Length::kEdgeElements] = system.edge_elements.element.size();
  shape[Length::kLattices] = system.lattices.size();
  return shape;
}

std::string state_problem(const System& system, bool rates, const State& s) {
  for (const Array* w : {&s.wx, &s.wy, &s.wz})
    if (w->empty() == rates) return "wx does not fit to the damping and air in force";
  for (std::size_t b = 0; b < s.body.size(); ++b) {
    if (!blocks_agree(system, s.body[b].blocks)) return "body.blocks do not fit together";
    if (!edges_agree(system, system.bodies[b], s.body[b].edges)) return "body.edges do not fit together";
  }
  if (!self_agrees(system, s.self)) return "self.pairs do not fit together";
  return relaxation_problem(system, s);
}

}  // namespace drape::state
