// The energy that a change of parameters puts into the cloth, through the C interface.
#include "tuning_fixture.h"

namespace drape::api {

using namespace tests;
namespace {

double total(const drape_energy& e) { return e.kinetic + e.stretch + e.shear + e.bending + e.gravity; }

// The energy input is the work of the change: all energies after it minus those before. The error of the
// balance does not jump. The sums have 1e2 terms, each rounded.
void expect_work(const Cloth& c) {
  const drape_energy before = energy(c);
  ASSERT_EQ(drape_commit(c.get()), DRAPE_OK);
  const drape_energy after = energy(c);
  const double size = total(before) + total(after);
  EXPECT_NE(after.input, before.input);
  EXPECT_NEAR(after.input - before.input, total(after) - total(before), 1e-14 * size);
  EXPECT_NEAR(after.dissipated, before.dissipated, 1e-14 * size);
  EXPECT_NEAR(after.balance_error, before.balance_error, 1e-14 * size);
}

// Gravity doubled in free fall doubles the potential energy of the weight. The velocity does not change.
TEST(TuningEnergy, WorkOfDoublingGravityInFreeFall) {
  Logged logged;
  const Cloth c = open_sheet(logged, false);
  ASSERT_TRUE(c);
  run(c, 10);
  const double mass = 0.15 * 0.05 * 0.05, work = mass * kG * (height(c) + 0.025);
  const drape_energy before = energy(c);
  drape_parameters_of(c.get())->gravity[2] *= 2;
  expect_work(c);
  EXPECT_NEAR(energy(c).input - before.input, work, 1e-12 * work);
  EXPECT_NEAR(energy(c).kinetic, before.kinetic, 1e-14 * before.kinetic);
}

// Doubling a diagram under strain doubles its energy. A density of 1.5 times multiplies the energies of
// weight and motion by 1.5.
TEST(TuningEnergy, WorkOfAStifferAndAHeavierCloth) {
  Logged logged;
  const Cloth c = open_sheet(logged, true);
  ASSERT_TRUE(c);
  run(c, 40);
  const drape_energy before = energy(c);
  for (double* force : {&drape_parameters_of(c.get())->fabric[0].warp.force[0],
                        &drape_parameters_of(c.get())->fabric[0].warp.force[1],
                        &drape_parameters_of(c.get())->fabric[0].weft.force[0],
                        &drape_parameters_of(c.get())->fabric[0].weft.force[1]})
    *force *= 2;
  expect_work(c);
  EXPECT_NEAR(energy(c).stretch, 2 * before.stretch, 1e-12 * before.stretch);
  drape_parameters_of(c.get())->fabric[0].areal_density *= 1.5;
  expect_work(c);
  EXPECT_NEAR(energy(c).gravity, 1.5 * before.gravity, 1e-12 * before.gravity);
}

// Along a ramp the works of its steps add up, and the error of the balance stays of order h^2, that of the
// scheme.
TEST(TuningEnergy, BalanceAlongARamp) {
  double errors[2], inputs[2];
  for (int halved = 0; halved < 2; ++halved) {
    Logged logged;
    const Cloth c = open_sheet(logged, true, halved ? "0.0000152587890625" : "0.000030517578125");
    ASSERT_TRUE(c);
    run(c, 20);
    tune_everything(c);
    drape_parameters_of(c.get())->ramp = 20 * kQ;
    errors[halved] = 0;
    for (int k = 0; k < 30; ++k) {
      run(c, 1);
      errors[halved] = std::max(errors[halved], std::abs(energy(c).balance_error));
    }
    inputs[halved] = energy(c).input;
  }
  EXPECT_GT(std::abs(inputs[0]), 100 * errors[0]);
  EXPECT_NEAR(inputs[1], inputs[0], 1e-3 * std::abs(inputs[0]));
  EXPECT_NEAR(errors[0] / errors[1], 4, 0.5);
}

}  // namespace
}  // namespace drape::api
