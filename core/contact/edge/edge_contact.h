// Contact of links and cells of the cloth with sharp edges and tips of bodies within a step. core/README.md,
// section 7.
#pragma once
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "body/distance_grid.h"
#include "contact/edge/gap.h"
#include "contact/particle/contact_pass.h"
#include "math/smooth_ramp.h"
#include "model/system.h"

namespace drape::contact {

// The longest step (s) that a node near a body may take, and how fast (m/s) they may approach each other.
struct MaxStep {
  double step = INFINITY, speed = 0;
  std::size_t body = 0, node = 0;
};
inline void max_step_include(MaxStep& least, const MaxStep& other) {
  if (other.step < least.step) least = other;
}

// A cloth element and a sharp feature of a body that touch, or may, at t_n.
struct EdgeContactPair {
  std::size_t body, pair;  // pair: of EdgeContact::pair
  const model::EdgeElement* element;
  EdgeGap gap;         // n in the frame of space
  Vec3 at;             // m, point of the cloth: sum W_k r_k
  Vec3 body_velocity;  // m/s, of the body at that point
  Vec3 old{0, 0, 0};   // m/s, of that point of the cloth at t_{n-1/2}
  double stiffness;    // N/m
};

// Scratch vectors of the functions below. Made once per System, so that a step allocates nothing once they
// have grown.
struct EdgeResponse;
struct EdgeResponseEnd {
  void operator()(EdgeResponse* response) const;
};
struct EdgeScratch {
  std::vector<std::uint32_t> features, elements, nodes, joined;
  std::vector<Vec3> from;
  std::vector<model::EdgePair> found, pairs;
  std::vector<double> active_after_travel;
  std::vector<EdgeContactPair> touches;
  std::unique_ptr<EdgeResponse, EdgeResponseEnd> response;  // of edge_respond
};
EdgeScratch edge_scratch_make();

inline bool edge_any(const State& s) {  // an element is near a sharp feature
  for (const model::BodyContact& c : s.body)
    if (!c.edges.pair.empty()) return true;
  return false;
}

// What pairs add to omega^2 of the step limit, over that of the penalty on a particle. An edge crosses two
// links of a node at most; a narrow face has two edges.
inline double edge_added(const System& system, const State& s) {
  double added = 0;
  for (std::size_t b = 0; b < s.body.size(); ++b)
    if (!s.body[b].edges.pair.empty()) added = std::max(added, system.bodies[b].sharp.narrow ? 2.0 : 1.0);
  return added;
}

// Begins a new state, before its neighbours are found; edge_stick, after that, makes pairs at rest stick.
void edge_begin(const System& system, State& state);
void edge_stick(const System& system, State& state);

// After particles and bodies have moved and their neighbours are up to date: lists the pairs that may touch
// in the next step, of `ahead` s.
void edge_update_proximity(const System& system, EdgeScratch& scratch, State& state, std::size_t body,
                           double ahead);

// Before positions change otherwise than in a step, by up to `moved` (m): records which pairs are outside the
// bodies, since a jump may take them through. Returns J as edge_store_velocities.
double edge_record_sides(const System& system, EdgeScratch& scratch, State& state, double moved);

// The longest step (s) in which nodes near a sharp feature move by no more than a quarter of the contact
// distance.
MaxStep edge_max_step(const System& system, const State& state);

// Before a step: finds the pairs at t_n and stores their velocities. Returns the energy (J) that penalties
// have lost since the last step otherwise than by work: as their share fell, or as pairs opened.
double edge_store_velocities(const System& system, State& state, std::vector<EdgeContactPair>& touches);

// The same, without a change of the state.
double edge_narrow_phase(const System& system, const State& state, std::vector<EdgeContactPair>& touches);

// Velocities, and in a step positions, that contact changes. The inertia of a node is its mass over its
// inverse mass scale.
struct EdgeField {
  double* v[3];                      // [nodes] m/s, or accelerations
  double* r[3];                      // [nodes] m; null: nothing moves
  const double* inverse_mass_scale;  // [nodes]; null: 1 everywhere
};

// The pairs of a pass, its coefficients, and what it changes.
struct EdgePass {
  const std::vector<EdgeContactPair>& touches;
  ContactCoefficients c;
  EdgeField field;
  State* moves = nullptr;  // the state that receives sticking and warm starts; null: none does
  bool on = false;         // again in the same step: goes on from the impulses of the last pass
};

// Warm start: gives pairs their impulse of the last step.
void edge_warm_start(const System& system, const State& state, const EdgePass& pass);

// Results of edge_respond.
struct EdgeSums {
  std::vector<math::Wrench> load;  // [bodies] N s, N m s on the bodies
  std::vector<double> stop;        // [pairs of the pass] N s along n
};

// Adds contact to a free motion; needs the warm start. Gauss-Seidel sweeps over the pairs, until velocities
// change no more. Returns the largest change of a velocity, m/s: of the first sweep, if not `on`, the whole.
double edge_respond(const System& system, const State& state, const EdgePass& pass, EdgeScratch& scratch,
                    EdgeSums& sums);

// Energy (J) that contact has dissipated, and that moving bodies have brought in.
struct ContactWork {
  double dissipated = 0, input = 0;
};

// That of the last edge_respond, of the velocities `v` [nodes] that pins and welds have left after it.
ContactWork edge_work(const std::vector<EdgeContactPair>& touches, const EdgeScratch& scratch,
                      const double* const v[3]);

// Links and cells of a lattice that a sharp edge of a body cuts, or that are deeper than contact allows.
struct EdgeDepth {
  std::size_t count = 0;
  double depth = 0;  // m, of the deepest
  Vec3 at{0, 0, 0};  // m, where the deepest is
};
EdgeDepth edge_deepest(const System& system, const State& state, std::size_t body,
                       const model::Lattice& lattice, body::DistanceGrid& grid);

// Visits (pair, its index in edge_narrow_phase, depth in m, force of the penalty in N) of links and cells
// within their contact distance.
template <class Visit>
void edge_pairs_visit(const System& system, const State& s, Visit visit) {
  if (!edge_any(s)) return;
  std::vector<EdgeContactPair> touches;
  edge_narrow_phase(system, s, touches);
  for (const EdgeContactPair& t : touches) {
    const double contact_distance = system.lattices[std::size_t(t.element->lattice)].contact_law.distance;
    const double depth = contact_distance - t.gap.distance;
    // past the feature, the force is that at the feature itself
    const double pressed = std::min(depth, contact_distance);
    if (depth > 0)
      visit(t, std::size_t(&t - touches.data()), depth,
            t.stiffness* math::smooth_ramp(kContactBlend * contact_distance, pressed));
  }
}

}  // namespace drape::contact
