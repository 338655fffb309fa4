// The energy guard: compares the energy of the cloth with the work done on it, and asks for smaller steps
// where more is missing than a run may lose. core/README.md, section 4, "Energy guard".
#pragma once
#include <array>
#include <functional>

#include "dynamics/advance.h"

namespace drape::dynamics {

inline constexpr std::int64_t kGuardSteps = 256;  // between two checks, at least
inline constexpr double kGuardAllowed = 0.01;     // of the largest energy, in a run

// True where all work is known, or all that is not known takes energy: without bodies, self-contact, fit,
// wind and rigid links.
bool guard_watches(const System& system, const State& state);

// Before a step of h (s). Begins the balance where it is due, at the start and after a pause; follows a
// change of the step.
void guard_step(const System& system, Motion& motion, State& state, double h);
// After the velocities of pins have jumped, from those of `before` (m/s): follows the energy of the step.
void guard_jump(const System& system, Motion& motion, State& state, const std::array<Array, 3>& before);
// Sets the inputs of an advance by `set`, where pins jump. The paper's scheme takes the jump up in its next
// step; its H changes at once, and is followed.
void guard_set_inputs(const System& system, Motion& motion, State& state, const std::function<void()>& set);
// Before an advance along a path. Where pins change their velocity by so much that cloth that follows them
// gains more than the largest energy, its intervals are checked at once.
void guard_advance(const System& system, const Path& path, State& state);
// Before a change of the system: ends the balance, and completes the last half kick. Changes that are not
// rare may come in each interval, as in a ramp.
enum class Change { kRare, kFrequent };
void change_begin(const System& system, Motion& motion, State& state, Change change);

// Takes note of what the damping -m c v takes, by the present kinetic energy (J).
void guard_damped(const System& system, State& state, double kinetic);

enum class Guard { kKept, kRepeat, kLost };

// After an interval of `length` s. kRepeat: a part of the allowed energy was lost or gained in the steps
// since the last check, and smaller steps can be taken. kLost: ten times the allowed energy is missing.
Guard guard_check(const System& system, Motion& motion, State& state, double length);

// The same look at the present state, without a verdict: for what a run has lost at its end.
void guard_look(const System& system, Motion& motion, State& state);

// J, missing at the last check beyond what is not known.
double guard_missing(const State& state);
// The same, or the ripple of T + U if that is larger: what smaller steps are to reduce.
double guard_excess(const State& state);
// True where that is ten times the allowed energy.
bool guard_lost(const System& system, const State& state);

// Doubles the refinement of the automatic step, up to a bound. False: it is there already. `size`: J, the
// largest energy with the interval that failed. `again`: for the same interval.
bool guard_refine(State& state, double size, bool again);

// Smaller steps do not help: takes what is missing as it is, with the refinement and the steps from before.
inline constexpr double kGuardHelps = 0.7;  // a refinement leaves less than this share of what is missing
void guard_accept(State& state, double refinement);

// J, the largest energy so far, which counts as no less than a floor.
double guard_size(const System& system, const State& state);

}  // namespace drape::dynamics
