// Self-contact, of cloth with cloth, within a step. core/README.md, section 8.
#pragma once
#include "contact/particle/contact.h"
#include "contact/self/groups.h"

namespace drape::contact {

// Workspace of self-contact; made once per System.
struct SelfContactWorkspace {
  SelfContactPairs touches;
  SelfGroups groups;      // of these pairs
  ContactCoefficients c;  // of the last pass
};

inline bool self_enabled(const System& system) { return !system.self.cell.empty(); }

// Whether any pair touched in the last pass; whether any pair is near.
inline bool self_any_touching(const SelfContactWorkspace& workspace) {
  return !workspace.touches.pair.empty();
}
inline bool self_any(const State& s) { return s.self.pairs && s.self.pairs->size() > 0; }

// Searches for the near pairs of a new state.
void self_begin(const System& system, State& state);

// Adds a problem for pieces that go through each other or themselves at the start: contact would not undo it.
void self_check_start(const System& system, const Scene& scene, const State& state,
                      std::vector<Problem>& problems);

// After velocities have changed otherwise than in a step, or positions by up to `moved` (m).
void self_invalidate_proximity(const System& system, State& state, double moved);

// Before a step of h (s): finds the pairs that touch at t_n, and stores their velocities.
void self_store_velocities(const System& system, const SelfContactKernel& kernel,
                           SelfContactWorkspace& workspace, State& state, double h);

// Adds self-contact to a free step. Needs self_store_velocities.
void self_apply(const System& system, const SelfContactKernel& kernel, SelfContactWorkspace& workspace,
                const model::Scheme& scheme, State& state);

// After self_store_velocities: the energy (J) that contact distances bring in as they grow, half a step of h
// (s) before t_n and after it.
double self_parting_work(const System& system, const SelfContactWorkspace& workspace, const State& state,
                         double h);

// The energy (J) that the pairs of the last pass have dissipated, of the velocities `v` [nodes] that pins and
// welds have left after it.
double self_work(const SelfContactKernel& kernel, SelfContactWorkspace& workspace, const double* const v[3]);

// After the particles have moved for `drift` s.
void self_update_proximity(const System& system, State& state, double drift);

// As apply_synchronous.
void self_synchronous(const System& system, const SelfContactKernel& kernel, SelfContactWorkspace& workspace,
                      const State& state, const SynchronousPass& pass);

// Count, largest depth (m) and largest pressure (Pa) of the present pairs; and the energy of the penalties,
// J.
model::ContactSummary self_summary(const System& system, const State& state);
double self_energy(const System& system, const State& state);

}  // namespace drape::contact
