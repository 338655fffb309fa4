// Time: the step, its size, and advances on the communication grid. core/README.md, section 4.
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

// Room that steps and outputs work in; made once per System.
struct Motion {
  const Kernel* kernel = nullptr;
  Workspace workspace;
  constraint::Constraints constraints;  // at work: those of the pins and of the pairs of seams in `welded`
  std::vector<char> welded;             // [pairs]
  Array gap_rate;                       // as in State, of the present step
  HeldMotion held;
  Inputs inputs;              // where the next advance goes
  Path path;                  // of the present advance
  Array now_x, now_y, now_z;  // [nodes] a field of t_n while somebody works with it: velocities or forces
  std::vector<Vec3> torque;   // [pins] N m, of the slopes that clamps hold
  Balance balance;
  contact::ContactWorkspace contact;
  contact::SelfContactWorkspace self;
};
Motion motion_make(const System& system);
inline model::Field motion_field(Motion& m) { return {m.now_x.data(), m.now_y.data(), m.now_z.data()}; }

// Steps in a communication interval, at most.
inline constexpr std::int64_t kMaxStepsPerInterval = 1000000;

enum class Advance { kDone, kStepAboveLimit, kTooManySteps, kNotFinite };

// Steps in an interval of q that a state with this omega^2 (1/s^2) needs; may be infinite.
double leapfrog_steps(const System& system, double omega2);

// Begins a new state: held points take the velocity of their pins; looks at the step limit and chooses the
// number of steps in an interval of q.
void leapfrog_begin(const System& system, Motion& motion, State& state);

// After a change of the system: looks again before the next step; before the first step, chooses anew.
void leapfrog_retuned(const System& system, Motion& motion, State& state);

// Completes the last half kick, so that the state is one of t_n as at the start: before the system changes or
// the velocity of a pin jumps. Its impulses go to the pins of the advance that it ends.
void leapfrog_complete(const System& system, Motion& motion, State& state);

// One step of size h, which leads to the share u of the present interval of the inputs' paths; it is the
// share `share` of that interval.
void leapfrog_step(const System& system, Motion& motion, State& state, double h, double u = 1,
                   double share = 0);

// c (1/s) of the step: the scene's, in a fit its own.
double damping_of(const System& system, const State& state);

// g of the step: the scene's, in a fit none while seams are to be closed.
Vec3 gravity_of(const System& system, const State& state);

// What the state lacks at the end of a step: the time (s) of its last kick (h_old/2 in leapfrog, none in the
// paper's scheme), and the share of v that -m c v has left before it (1 in leapfrog, whose damping is
// centred).
double last_half(const System& system, const State& state);
double last_decay(const System& system, const State& state);

// What may change the system before an interval, given its length over q; true where it may have done so.
using IntervalBegins = std::function<bool(double intervals)>;

// Advances by `length` > 0: whole communication intervals of q on the grid, or one interval of its own
// length. Each interval of q has state.subs steps; that number doubles when the step limit falls and is
// chosen anew after 100 calm intervals. kStepAboveLimit: a given step met a limit below it. kTooManySteps:
// the automatic step fell below q / kSubsMost. kNotFinite: the run left the finite numbers; the caller holds
// the state from before. `event` receives a sentence when the step changed.
Advance leapfrog_advance(const System& system, Motion& motion, State& state, double length,
                         std::string& event, const IntervalBegins& interval_begins = {});

// J of the last half kick, which the sums of the state lack.
struct HalfKick {
  double dissipated_by_contact = 0, dissipated_by_self_contact = 0;
  double work_of_pins = 0, work_of_bodies = 0;
};

// The scheme of the last half kick, which completes the state to one of t_n; of the accelerations at t_n
// where there is none, and in a fit, whose steps have another inertia.
model::Scheme scheme_of_last_kick(const System& system, const State& state);

// Synchronous velocities of all nodes at the present time (into v [nodes]) and the loads of the pins on the
// outside world (load [pins]): their mean over the last half step, which the impulses of the state lack;
// before the first step, the present ones. Those of bodies are in motion.contact.load.
HalfKick leapfrog_synchronous(const System& system, Motion& motion, const State& state, model::Field v,
                              std::vector<math::Wrench>& load);

// What stops of bodies hold now: of the forces at t_n, whatever the velocity.
contact::ContactStops leapfrog_stops(const System& system, Motion& motion, const State& state);

// Projects constraints and applies contact to the velocities or accelerations of `scheme.pass`. What contact
// changes is projected again, so that it meets the velocities that pins and welds leave, as in a step. Adds
// to the loads [pins] where `load` is not null.
void project_synchronous(const System& system, Motion& motion, const State& state,
                         const model::Scheme& scheme, model::Field field, std::vector<math::Wrench>* load);

}  // namespace drape::dynamics
