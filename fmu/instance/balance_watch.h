// Watches the energy balance of a run: energy that no force accounts for was gained or lost by the steps.
#pragma once
#include <string>

#include "drape/drape.h"

namespace drape::instance {

struct BalanceWatch {
  bool begun = false;
  double gravity = 0;          // J, at the start
  double largest = 0;          // J, the largest energy so far, with gravity from the start and the input
  double error = 0, time = 0;  // J, s: the largest balance error so far, and when
};

// Takes note of the outputs at a time (s). Does nothing where the balance is not computed.
void balance_update(BalanceWatch& watch, const drape_outputs& outputs, double time);

// A sentence where more than 1 % of the largest energy is unaccounted for; empty if not.
std::string balance_problem(const BalanceWatch& watch);

// The same, or else what the energy guard of the cloth says.
std::string energy_problem(const BalanceWatch& watch, drape_cloth* cloth);

}  // namespace drape::instance
