// A run that has gained or lost more than 1 % of its largest energy is told of.
#include "instance/balance_watch.h"

#include <gtest/gtest.h>

namespace drape::instance {
namespace {

drape_outputs outputs_of(double kinetic, double gravity, double balance_error) {
  drape_outputs o{};
  o.has_energy = o.has_balance = 1;
  o.energy.kinetic = kinetic;
  o.energy.gravity = gravity;
  o.energy.balance_error = balance_error;
  return o;
}

// The largest energy is 2 J of motion and 3 J of gravity from the start.
TEST(BalanceWatch, TellsOfMoreThanAHundredthOfTheLargestEnergy) {
  for (const double error : {0.0499, 0.0501, -0.0501}) {
    BalanceWatch watch;
    balance_update(watch, outputs_of(0, 7, 0), 0);
    balance_update(watch, outputs_of(2, 4, error), 0.5);
    balance_update(watch, outputs_of(0, 7, 0), 1);
    const std::string problem = balance_problem(watch);
    if (std::abs(error) <= 0.05) {
      EXPECT_EQ(problem, "");
      continue;
    }
    const std::string way = error > 0 ? "gained" : "lost";
    EXPECT_NE(problem.find("at 0.5 s the cloth has " + way + " 0.0501 J"), std::string::npos) << problem;
    EXPECT_NE(problem.find("1 % of its largest energy"), std::string::npos) << problem;
  }
}

TEST(BalanceWatch, IsSilentWithoutABalance) {
  BalanceWatch watch;
  drape_outputs o = outputs_of(1, 0, 5);
  o.has_balance = 0;
  balance_update(watch, o, 1);
  EXPECT_EQ(balance_problem(watch), "");
}

}  // namespace
}  // namespace drape::instance
