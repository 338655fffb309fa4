// Motion in time: the step, its size, and advances on the communication grid. core/README.md, section 4.
#pragma once
#include <functional>
#include <string>

#include "contact/particle/contact.h"
#include "contact/self/self_contact.h"
#include "dynamics/constraint_projection.h"
#include "dynamics/energy_balance.h"
#include "dynamics/kernel/kernel.h"
#include "dynamics/prescribed_motion.h"

namespace drape::dynamics {

// The workspace of steps and outputs; made once per System.
struct Motion {
  const Kernel* kernel = nullptr;
  Workspace workspace;
  constraint::Constraints constraints;  // in force: of the pins and of the pairs of seams in `welded`
  std::vector<char> welded;             // [pairs]
  Array gap_rate;                       // as in State, of the present step
  HeldMotion held;
  Inputs inputs;              // at the end of the next advance
  Path path;                  // of the present advance
  Array now_x, now_y, now_z;  // [nodes] scratch: velocities, accelerations or forces at t_n
  std::vector<Vec3> torque;   // [pins] N m, of clamps
  Balance balance;
  State before;  // at the start of an interval that the energy guard may repeat
  contact::ContactWorkspace contact;
  contact::SelfContactWorkspace self;
};
Motion motion_make(const System& system);
inline model::Field motion_field(Motion& m) { return {m.now_x.data(), m.now_y.data(), m.now_z.data()}; }

// At most so many steps make a communication interval.
inline constexpr std::int64_t kMaxStepsPerInterval = 1000000;

enum class Advance { kDone, kStepAboveLimit, kTooManySteps, kEnergyLost, kNotFinite };

// Begins a new state: held points take the velocities of their pins; the step limit sets the number of steps
// in an interval of q.
void leapfrog_begin(const System& system, Motion& motion, State& state);

// After seams were welded, which jolts the cloth.
void leapfrog_welded(const System& system, Motion& motion, State& state);

// After a change of the system: the step limit is checked before the next step. Before the first step the
// number of steps is chosen anew.
void leapfrog_retuned(const System& system, Motion& motion, State& state);

// Completes the last half kick, so that velocities are those of t_n, as at the start. Needed before the
// system changes or the velocity of a pin jumps. The impulses go to the pins of the advance that ends.
void leapfrog_complete(const System& system, Motion& motion, State& state);

// One step of h (s). It leads to the share `u` of the present interval of the inputs' paths, and is the share
// `share` of that interval.
void leapfrog_step(const System& system, Motion& motion, State& state, double h, double u = 1,
                   double share = 0);

// c (1/s) of the step: that of the scene; a fit has its own.
double damping_of(const System& system, const State& state);

// g (m/s^2) of the step: that of the scene; 0 in a fit until all seams are closed.
Vec3 gravity_of(const System& system, const State& state);

// The last kick that a state still needs to be one of t_n: its time (s), h_old/2 in leapfrog and 0 in the
// paper's scheme; and the share of v that damping has left before it, 1 in leapfrog, whose damping is
// centred.
double last_half(const System& system, const State& state);
double last_decay(const System& system, const State& state);

// Called before an interval with its length over q. May change the system; returns true where it may have.
using IntervalBegins = std::function<bool(double intervals)>;

// Advances by `length` > 0 (s): whole communication intervals of q on the grid, or one interval of that
// length. Each interval of q has state.steps_per_interval steps. The number doubles when the step limit
// falls, and is chosen anew after 100 intervals without a change. kStepAboveLimit: the step limit fell below
// a given step. kTooManySteps: the automatic step fell below q / kMaxStepsPerInterval. kEnergyLost: the
// energy guard misses ten times what a run may lose. kNotFinite: the run left the finite numbers; the caller
// holds the state from before. `event` receives a sentence when the step changed.
Advance leapfrog_advance(const System& system, Motion& motion, State& state, double length,
                         std::string& event, const IntervalBegins& interval_begins = {});

// J of the last half kick, which the sums of the state lack.
struct HalfKick {
  double dissipated = 0;                          // by contact
  double work_of_drives = 0, work_of_bodies = 0;  // work_of_drives: of pins and closing seams
};

// The scheme of the last half kick, which completes the state to one of t_n; of the accelerations at t_n
// where there is none, and in a fit, whose steps have another inertia.
model::Scheme scheme_of_last_kick(const System& system, const State& state);

// Synchronous velocities of all nodes at the present time (into f [nodes]) and the loads of the pins on the
// outside world (load [pins]): their mean over the last half step, which the impulses of the state lack;
// before the first step, the present ones. Those of bodies are in motion.contact.load.
HalfKick leapfrog_synchronous(const System& system, Motion& motion, const State& state, model::Field f,
                              std::vector<math::Wrench>& load);
// The same by the half kick of a scheme.
HalfKick half_kick(const System& system, Motion& motion, const State& state, const model::Scheme& scheme,
                   model::Field f, std::vector<math::Wrench>& load);

// Accelerations F/m + g at t_n, before constraints and contact; in motion_field.
void free_accelerations(const System& system, Motion& motion, const State& state);

// The forces of the stops of bodies at t_n, whatever the velocity.
contact::ContactStops leapfrog_stops(const System& system, Motion& motion, const State& state);

// Projects constraints and applies contact to the velocities or accelerations of `scheme.pass`. What contact
// changes is projected again, so that it meets the velocities that pins and welds leave, as in a step. Adds
// to the loads [pins] where `load` is not null.
void project_synchronous(const System& system, Motion& motion, const State& state,
                         const model::Scheme& scheme, model::Field field, std::vector<math::Wrench>* load);

}  // namespace drape::dynamics
