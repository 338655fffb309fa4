// Links and cells of cloth on ridges and tips of bodies within a step. core/README.md, section 7.
#pragma once
#include <algorithm>
#include <memory>
#include <vector>

#include "body/distance_grid.h"
#include "contact/edge/gap.h"
#include "contact/particle/contact_pass.h"
#include "math/smooth_ramp.h"
#include "model/system.h"

namespace drape::contact {

// What a pair does at t_n.
struct EdgeContactPair {
  std::size_t body, pair;
  const model::EdgeElement* element;
  EdgeGap gap;         // n in space
  Vec3 at;             // m, of the cloth: sum W_k r_k
  Vec3 body_velocity;  // m/s, of the body there
  Vec3 old{0, 0, 0};   // m/s, of the cloth there at t_{n-1/2}
  double stiffness;    // N/m
};

// Vectors that the functions below work in, made once per System: they keep what they have grown to.
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

inline bool edge_any(const State& s) {  // a pair is near
  for (const model::BodyContact& c : s.body)
    if (!c.edges.pair.empty()) return true;
  return false;
}

// For a new state, before its surroundings are looked at, and after: what is at rest sticks.
void edge_begin(const System& system, State& state);
void edge_stick(const System& system, State& state);

// After particles and bodies have moved, and their surroundings were looked at: which pairs may touch in the
// next step, of `ahead` s.
void edge_update_proximity(const System& system, EdgeScratch& scratch, State& state, std::size_t body,
                           double ahead);

// Before places change otherwise than in a step, by as much as `moved` (m): notes which pairs are out of the
// bodies, since a jump may take them through. Gives J as ridge_keep.
double edge_record_sides(const System& system, EdgeScratch& scratch, State& state, double moved);

// The longest step (s) in which nodes near a ridge move by no more than a quarter of the layer.
double edge_max_step(const System& system, const State& state);

// Before a step: finds what touches at t_n, and keeps its velocities. Gives J that penalties have lost since
// the step before otherwise than by their work: as their share fell, or as pairs opened.
double edge_store_velocities(const System& system, State& state, std::vector<EdgeContactPair>& touches);

// The same of a state that does not change.
double edge_narrow_phase(const System& system, const State& state, std::vector<EdgeContactPair>& touches);

// Velocities, and in a step places, that touching changes. Inertia is mass over lightness.
struct EdgeField {
  double* v[3];
  double* r[3];                      // null: nothing moves
  const double* inverse_mass_scale;  // or null
};

// The pairs of a pass, its coefficients, and what it changes.
struct EdgePass {
  const std::vector<EdgeContactPair>& touches;
  ContactCoefficients c;
  EdgeField field;
  State* moves = nullptr;  // receives what goes on with it; null: nothing does
};

// Gives in advance what pairs got in the step before.
void edge_warm_start(const System& system, const State& state, const EdgePass& pass);

// What touching does to a free motion. Adds the impulses to load [bodies], J to dissipated and input.
struct EdgeSums {
  std::vector<math::Wrench> load;
  std::vector<double> stop;  // [touches] N s along n
  double dissipated, input;
};
void edge_respond(const System& system, const State& state, const EdgePass& pass, EdgeScratch& scratch,
                  EdgeSums& sums);

// Links and cells of a lattice that are cut by a ridge of a body, or deeper in its layer than anything is to
// be.
struct EdgeDepth {
  std::size_t count = 0;
  double depth = 0;  // m, of the deepest, and where it is
  Vec3 at{0, 0, 0};
};
EdgeDepth edge_deepest(const System& system, const State& state, std::size_t body,
                       const model::Lattice& lattice, body::DistanceGrid& voxels);

// Visits (touch, its place in ridge_look, depth in m, force of the penalty in N) where links and cells are
// within their layer.
template <class Visit>
void edge_pairs_visit(const System& system, const State& s, Visit visit) {
  if (!edge_any(s)) return;
  std::vector<EdgeContactPair> touches;
  edge_narrow_phase(system, s, touches);
  for (const EdgeContactPair& t : touches) {
    const double contact_distance = system.lattices[std::size_t(t.element->lattice)].contact_law.distance;
    const double depth = contact_distance - t.gap.distance;
    const double pressed =
        std::min(depth, contact_distance);  // past the ridge it is pushed as from the ridge itself
    if (depth > 0)
      visit(t, std::size_t(&t - touches.data()), depth,
            t.stiffness* math::smooth_ramp(kContactBlend * contact_distance, pressed));
  }
}

}  // namespace drape::contact
