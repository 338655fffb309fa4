// Contact within a step: what keeps the cloth out of bodies. core/README.md, section 7.
#pragma once
#include "body/closest_features.h"
#include "body/distance_grid.h"
#include "contact/edge/edge_contact.h"
#include "contact/particle/contact_pass.h"
#include "model/field.h"
#include "model/scheme.h"
#include "model/system.h"

namespace drape::contact {

// Room for contact; made once per System.
struct ContactWorkspace {
  std::vector<body::DistanceGrid> distance_grids;  // [bodies]
  std::vector<Array> old;                          // [bodies][blocks x 3 x kRowUnit] v_{n-1/2}
  std::vector<std::size_t> stale;                  // [nodes / kRowUnit] first nodes of blocks to look at anew
  Array tied;                 // [nodes] 1 where pins and welds tie a particle to others; empty: nowhere
  std::vector<char> touched;  // [nodes / kRowUnit] where tied nodes have been touched in the present step
  std::vector<model::ContactLaw> law;       // [lattices] of the present body
  std::vector<EdgeContactPair> edge_pairs;  // links and cells on ridges, of the present pass
  EdgeSums edge_sums;
  EdgeScratch edge_scratch;
  body::ClosestFeatures found;  // of one particle
  double edge_lost = 0;         // J, of ridge_look
  bool half_kick_reported =
      false;  // what bodies were told of the half step before this advance is taken out already
  std::vector<math::Wrench> load;    // [bodies] of the last synchronous pass
  double dissipated = 0, input = 0;  // J, likewise
};
ContactWorkspace workspace_make(const System& system);

// Looks at all surroundings; for a new state.
void begin(const System& system, const ContactKernel& kernel, ContactWorkspace& workspace, State& state);

// Pieces that start inside a body, or nearer to one than the cloth's thickness lets them.
void check_start(const System& system, const Scene& scene, ContactWorkspace& workspace, const State& state,
                 std::vector<Problem>& problems);

// What is on ridges, and the velocities of all that is near, before a step changes them.
void store_velocities(const System& system, ContactWorkspace& workspace, State& state);

// What the kick of a scheme does: of a step; of the last half kick, which turns v_{n-1/2} into v_n; or of
// accelerations, with stops as in the last step, before the first and at the rest of a fit as in the next.
ContactCoefficients coefficients_of(const System& system, const State& state, const model::Scheme& scheme);

// How a lattice touches a body now: in a fit nothing rubs while seams are to be closed, and until what has
// been sewn has settled.
model::ContactLaw current_law(const System& system, const State& state, const model::Body& body,
                              const model::Lattice& lattice);

// Notes which particles are tied to others; for new constraints.
void mark_tied(const System& system, const constraint::Constraints& constraints, ContactWorkspace& workspace);

// A field of synchronous velocities or of accelerations, by scheme.pass.
struct SynchronousPass {
  const model::Scheme& scheme;
  model::Field field;  // m/s or m/s^2
};

// Before pins and welds: gives particles that are not alone what the bodies did to them in the step before.
void warm_start(const System& system, const ContactWorkspace& workspace, const model::Scheme& scheme,
                State& state);
void warm_start_synchronous(const System& system, ContactWorkspace& workspace, const State& state,
                            const SynchronousPass& pass);

// Adds to a free step what the bodies do. Needs touch_keep.
void apply(const System& system, const ContactKernel& kernel, ContactWorkspace& workspace,
           const model::Scheme& scheme, State& state);

// After the particles and bodies have moved, or velocities have jumped: looks at the surroundings of those
// that may have come near something else, or will. `drift`: how long they moved since the last watch, s;
// `ahead`: the next step.
void update_proximity(const System& system, const ContactKernel& kernel, ContactWorkspace& workspace,
                      State& state, double drift, double ahead);

// After particles have been put elsewhere: all are compared with their budgets at the next watch.
void invalidate_proximity(State& state);

// What contact does to synchronous velocities [nodes] in the last half kick of `half` s, which is what
// room.load then holds, as impulses; or to accelerations (half = 0), as forces.
void apply_synchronous(const System& system, const ContactKernel& kernel, ContactWorkspace& workspace,
                       const State& state, const SynchronousPass& pass);

// The longest step (s) in which no particle goes past what its surroundings were searched for.
double max_step(const System& system, const State& state);

bool any_near(const State& state);  // a particle is near a body, or a link near a ridge

// omega^2 that contact adds to that of a lattice, 1/s^2.
double added_omega2(const System& system, const State& state, int lattice);

// What stops hold now beyond the penalties, N along the normals: of particles that touch and of the pairs of
// ridge_look, in their order. Empty where nothing is so deep.
struct ContactStops {
  std::vector<double> particle, pair;
};
bool any_stopped(const System& system, const State& state);  // something is, nearly

// Of the accelerations a [nodes] that all else leaves, carry given.
ContactStops stop_forces(const System& system, EdgeScratch& scratch, const State& state,
                         const std::vector<EdgeContactPair>& pairs, double* const a[3]);

// What touches now, and the energy of the penalties, J.
model::ContactSummary contact_summary(const System& system, const State& state, const ContactStops& stops);
double contact_energy(const System& system, const State& state);

// The pressure of bodies on each node, Pa, summed over the surfaces that it touches.
std::vector<double> contact_pressure(const System& system, const State& state, const ContactStops& stops);

}  // namespace drape::contact
