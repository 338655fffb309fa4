#include "instance/balance_watch.h"

#include <algorithm>
#include <cmath>

#include "instance/unfinished.h"

namespace drape::instance {

void balance_update(BalanceWatch& watch, const drape_outputs& outputs, double time) {
  if (!outputs.has_energy || !outputs.has_balance) return;
  const drape_energy& e = outputs.energy;
  if (!watch.begun) watch.begun = true, watch.gravity = e.gravity;
  double energy = std::abs(e.gravity - watch.gravity) + std::abs(e.input);
  for (double part : {e.kinetic, e.stretch, e.shear, e.bending, e.contact}) energy += std::abs(part);
  watch.largest = std::max(watch.largest, energy);
  if (std::abs(e.balance_error) <= std::abs(watch.error)) return;
  watch.error = e.balance_error;
  watch.time = time;
}

std::string balance_problem(const BalanceWatch& watch) {
  constexpr double kAllowed = 0.01;
  return energy_missing({watch.error, watch.largest, watch.time, kAllowed});
}

std::string energy_problem(const BalanceWatch& watch, drape_cloth* cloth) {
  const std::string problem = balance_problem(watch);
  return problem.empty() ? energy_missing(drape_energy_unaccounted(cloth)) : problem;
}

}  // namespace drape::instance
