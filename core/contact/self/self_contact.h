// Contact of cloth with cloth within a step. core/README.md, section 8.
#pragma once
#include "contact/particle/contact.h"
#include "contact/self/narrow_phase.h"

namespace drape::contact {

// Room of one step; made once per System.
struct SelfContactWorkspace {
  SelfContactPairs touches;
  double dissipated = 0;  // J, of the last synchronous pass
};

inline bool self_enabled(const System& system) { return !system.self.cell.empty(); }
inline bool self_any_touching(const SelfContactWorkspace& workspace) {
  return !workspace.touches.pair.empty();
}  // in the last pass
inline bool self_any(const State& s) { return s.self.pairs && s.self.pairs->size() > 0; }  // near each other

// Searches for what is near; for a new state.
void self_begin(const System& system, State& state);

// Pieces that go through each other or themselves at the start: what is tangled would stay so.
void self_check_start(const System& system, const Scene& scene, const State& state,
                      std::vector<Problem>& problems);

// After velocities have changed otherwise than in a step, or places by as much as `moved` (m).
void self_invalidate_proximity(const System& system, State& state, double moved);

// Before a step of h: finds what touches at t_n, and keeps its velocities.
void self_store_velocities(const System& system, SelfContactWorkspace& workspace, State& state, double h);

// Adds to a free step what touching does. Needs self_keep.
void self_apply(const System& system, SelfContactWorkspace& workspace, const model::Scheme& scheme,
                State& state);

// After the particles have moved for `drift` s.
void self_update_proximity(const System& system, State& state, double drift);

// As apply_synchronous.
void self_synchronous(const System& system, SelfContactWorkspace& workspace, const State& state,
                      const SynchronousPass& pass);

// What touches now: pairs; and the energy of the penalties, J.
model::ContactSummary self_summary(const System& system, const State& state);
double self_energy(const System& system, const State& state);

}  // namespace drape::contact
