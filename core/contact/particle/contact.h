// Contact of particles with bodies within a step. It keeps the cloth out of the bodies. core/README.md,
// section 7.
#pragma once
#include "body/distance_grid.h"
#include "contact/edge/edge_contact.h"
#include "contact/particle/contact_pass.h"
#include "contact/particle/update_neighbours.h"
#include "model/field.h"
#include "model/scheme.h"
#include "model/system.h"

namespace drape::contact {

// Workspace of contact with bodies; made once per System.
struct ContactWorkspace {
  std::vector<body::DistanceGrid> distance_grids;  // [bodies]
  std::vector<Array> old;                          // [bodies][blocks x 3 x kRowUnit] m/s, v_{n-1/2}
  std::vector<Array> given;                        // [bodies] as in ContactPass; only with System::energy
  std::vector<Array> response;                     // [bodies] as in ContactPass
  std::vector<std::size_t>
      stale;                  // [nodes / kRowUnit] first nodes of blocks whose neighbours are out of date
  Array tied;                 // [nodes] 1 where pins and welds tie a particle to others; empty: nowhere
  std::vector<char> touched;  // [nodes / kRowUnit] 1 where contact changed tied nodes in the present step
  std::vector<model::ContactLaw> law;       // [lattices] of the present body
  std::vector<EdgeContactPair> edge_pairs;  // links and cells on sharp features, of the present pass
  EdgeSums edge_sums;
  EdgeScratch edge_scratch;
  NeighbourScratch neighbours;
  double edge_lost = 0;  // J, result of edge_narrow_phase
  // The half kick that the advance before has reported to the bodies is already subtracted.
  bool half_kick_reported = false;
  std::vector<math::Wrench> load;  // [bodies] N s, N m s (N, N m of accelerations), last synchronous pass
};
ContactWorkspace workspace_make(const System& system);

double max_contact_distance(const System& system);  // m, of all lattices

// Finds all neighbours of a new state. What is at rest on a body that stays, sticks.
void begin(const System& system, const ContactKernel& kernel, ContactWorkspace& workspace, State& state);

// Adds a problem for each piece that starts inside a body, or nearer to one than the thickness of the cloth
// allows.
void check_start(const System& system, const Scene& scene, ContactWorkspace& workspace, const State& state,
                 std::vector<Problem>& problems);

// Before a step changes them: stores the velocities of particles near bodies, and finds the pairs on sharp
// features.
void store_velocities(const System& system, ContactWorkspace& workspace, State& state);

// What the kick of a scheme does: of a step; of the last half kick, which turns v_{n-1/2} into v_n; or of
// accelerations, with stops as in the last step, before the first and at the rest of a fit as in the next.
ContactCoefficients coefficients_of(const System& system, const State& state, const model::Scheme& scheme);

// The present contact law of a lattice on a body. In a fit friction is off until all seams are closed and
// what has been sewn has come to rest.
model::ContactLaw current_law(const System& system, const State& state, const model::Body& body,
                              const model::Lattice& lattice);

// Marks the particles that pins and welds tie to others; call it for new constraints.
void mark_tied(const System& system, const constraint::Constraints& constraints, ContactWorkspace& workspace);

// A field of synchronous velocities or of accelerations, by scheme.pass.
struct SynchronousPass {
  const model::Scheme& scheme;
  model::Field field;  // m/s or m/s^2
};

// Warm start, before pins and welds: gives particles that several constraints act on the bodies' impulse of
// the last step.
void warm_start(const System& system, const ContactWorkspace& workspace, const model::Scheme& scheme,
                State& state);
void warm_start_synchronous(const System& system, ContactWorkspace& workspace, const State& state,
                            const SynchronousPass& of);

// Adds the contact of bodies to a free step. Needs store_velocities. Returns the largest change of a
// velocity, m/s. `on`: again in the same step, after other constraints have changed velocities: what shares
// particles with them responds anew.
double apply(const System& system, const ContactKernel& kernel, ContactWorkspace& workspace,
             const model::Scheme& scheme, bool on, State& state);

// Whether the last apply acted on particles that pins or welds tie to others; in a fit, also whether links,
// cells or several surfaces share particles. (In a motion the next steps bring those into agreement: in an
// impact that crumples a cell round a thin body, the stops of its two sides may contradict each other.)
bool couples(const System& system, const ContactWorkspace& workspace, const State& state);

// After particles and bodies have moved, or velocities have jumped: updates the neighbours of particles that
// may touch something else by the end of the next step. `drift`: s, how long they have moved since the last
// call; `ahead`: s, the next step.
void update_proximity(const System& system, const ContactKernel& kernel, ContactWorkspace& workspace,
                      State& state, double drift, double ahead);

// After particles have been moved otherwise than by a step: the next update_proximity compares each with its
// free distance.
void invalidate_proximity(State& state);

// Adds contact to the field of a pass. workspace.load is then that of this half kick, as impulses; for
// accelerations, it is a force.
double apply_synchronous(const System& system, const ContactKernel& kernel, ContactWorkspace& workspace,
                         const State& state, const SynchronousPass& of, bool on);

// The energy (J) that the contact of the last pass has dissipated and brought in, of the velocities `v`
// [nodes] that pins and welds have left after it. Only with System::energy.
ContactWork contact_work(const ContactWorkspace& workspace, const State& state, const double* const v[3]);

// The longest step (s) in which no particle leaves the region that its neighbours were searched in.
double max_step(const System& system, const State& state);

// The same, with the node that it is for.
MaxStep max_step_setter(const System& system, const State& state);

bool any_near(const State& state);  // a particle is near a body, or a link near a sharp feature

// What contact adds to omega^2 of a lattice, 1/s^2.
double added_omega2(const System& system, const State& state, int lattice);

// Forces of the stops beyond the penalties, N along the normals. `particle` is in the order of the particles
// that touch, `pair` in that of edge_narrow_phase. Both are empty where nothing is so deep.
struct ContactStops {
  std::vector<double> particle, pair;
};
bool any_stopped(const System& system, const State& state);  // something is at its stop, or nearly

// Stop forces at the accelerations [nodes] (m/s^2) that all other forces leave, after the warm start;
// adds contact to them.
ContactStops stop_forces(const System& system, EdgeScratch& scratch, const State& state,
                         const std::vector<EdgeContactPair>& pairs, model::Field acceleration);

// Count, largest depth (m) and largest pressure (Pa) of the present contact; and the energy of the penalties,
// J.
model::ContactSummary contact_summary(const System& system, const State& state, const ContactStops& stops);
double contact_energy(const System& system, const State& state);

// The pressure of bodies on each node, Pa, [nodes], summed over the surfaces that it touches.
std::vector<double> contact_pressure(const System& system, const State& state, const ContactStops& stops);

}  // namespace drape::contact
