// The state of the energy guard: core/README.md, section 4, "Energy guard".
#pragma once
#include <cstdint>

namespace drape::model {

struct EnergyGuard {
  bool begun = false;  // there is a balance to compare with
  double h = 0;        // s, the step to whose energy the balance belongs
  double balance = 0;  // J, the balance that would leave nothing unaccounted
  double gravity =
      0;  // J, potential energy of gravity from which its change counts; less the present one in a pause
  double largest = 0;          // J, largest energy of all checks
  double unaccounted = 0;      // J, at the last check: gained, or lost where negative
  double step_energy = 0;      // J, the energy of the step that would leave no ripple
  double ripple = 0;           // J, at the last check: how far T + U has moved away from H
  double worst = 0;            // J, the unaccounted energy that was the largest share of the largest energy
  double worst_size = 1;       // J, the largest energy then
  double worst_time = 0;       // s, when that was
  double damped = 0;           // J, taken by the damping -m c v, from its power at checks of the step limit
  double power = 0;            // W, at the last of them
  double variance = 0;         // J^2, of that sum
  double since = 0;            // s, time since the last of them
  std::int64_t opened = 0;     // step at which the balance began
  std::int64_t checked = 0;    // step of the last check, or the step from which a balance may begin
  std::int64_t period = 1;     // steps between two checks, at least; doubles from check to check
  double refinement = 1;       // the automatic step is divided by it
  int refinements = 0;         // how often that has grown
  std::int64_t refined = 0;    // step at which it last changed
  double missing_refined = 0;  // J, what was missing when it last grew
  double ripple_refined = 0;   // J, the ripple then
  double size_refined = 0;     // J, the largest energy then
  double ripple_largest = 0;   // J, of the checks since the refinement last changed, or was kept
  bool failing = false;        // the last check failed, and the step is as small as the guard makes it
};

}  // namespace drape::model
