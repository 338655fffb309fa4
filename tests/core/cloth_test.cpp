// The C interface, from a scene file to outputs, and every way a run can go wrong.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>

#include "drape.h"

extern "C" int header_is_c(void);

namespace {

const char* kScene = R"(
[scene]
name = "cloth"
energy = true
%s
[fabric.f]
areal_density = 0.15
thickness = 0.0005
warp = { elongation_percent = [0, 1, 3], force = [0, 1, 9] }
weft = { elongation_percent = [0, 2, 6], force = [0, 1, 6] }
bias = { elongation_percent = [0, 2, 6], force = [0, 0.3, 2] }
bending = { rigidity_uN_cm2 = [1370, 900] }
[[piece]]
name = "sheet"
fabric = "f"
cell = 0.01
outline = [[0, 0], [0.1, 0], [0.1, 0.1], [0, 0.1]]
[[pin]]
name = "corner"
piece = "sheet"
at = [[0, 0]]
[[probe]]
name = "far"
piece = "sheet"
at = [0.1, 0.1]
)";

struct Heard {
  std::vector<std::string> errors;
};
void hear(void* user, drape_log_kind kind, const char* message) {
  if (kind == DRAPE_LOG_ERROR) static_cast<Heard*>(user)->errors.push_back(message);
}

struct Close {
  void operator()(drape_cloth* c) const { drape_close(c); }
};
using Cloth = std::unique_ptr<drape_cloth, Close>;

class ClothTest : public testing::Test {
 protected:
  Heard heard;
  Cloth open(const std::string& scene_keys = "") {
    const auto file = std::filesystem::path(testing::TempDir()) /
                      ("drape_cloth_test_" +
                       std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".toml");
    std::string text = kScene;
    text.replace(text.find("%s"), 2, scene_keys);
    std::ofstream(file) << text;
    Cloth cloth(drape_open(file.c_str(), hear, &heard));
    std::filesystem::remove(file);
    return cloth;
  }
};

TEST(Header, IsC) { EXPECT_EQ(header_is_c(), 0); }

TEST_F(ClothTest, AWholeRun) {
  const Cloth c = open();
  ASSERT_TRUE(c);
  const double weight = 0.15 * 0.01 * 9.81;
  // At first the pin carries its own node only: the cloth around it starts to fall.
  EXPECT_NEAR(drape_outputs_at(c.get(), 0)->pin[0].force[2], -weight / 400, 1e-15);
  for (int k = 0; k < 20; ++k) ASSERT_EQ(drape_advance(c.get(), 0.01), DRAPE_OK);
  EXPECT_NEAR(drape_time(c.get()), 0.2, 1e-15);
  const drape_outputs* o = drape_outputs_at(c.get(), 1);
  EXPECT_EQ(o->node_count, 121);
  EXPECT_LT(o->probe[0].position[2], -0.05);
  EXPECT_EQ(o->probe[0].position[2], o->node_position[3 * 120 + 2]);
  EXPECT_EQ(o->node_position[2], 0.0);
  EXPECT_GT(o->strain_warp.max, 0);
  EXPECT_GT(o->step_count, 100);
  EXPECT_LT(o->step_stability, 0.9);
  // Undamped: the potential energy of gravity has become motion and strain, to the order of the step.
  const drape_energy& e = o->energy;
  EXPECT_NEAR(e.kinetic + e.stretch + e.shear + e.bending + e.gravity, 0, 0.01 * e.kinetic);
}

TEST_F(ClothTest, RefusesAStepAboveTheLimitAndNamesWhatSetsIt) {
  EXPECT_FALSE(open("step = 1e-3"));
  ASSERT_EQ(heard.errors.size(), 1u);
  EXPECT_NE(heard.errors[0].find("scene.step = 0.001 s; allowed: above 0, at most the step limit"),
            std::string::npos)
      << heard.errors[0];
  EXPECT_NE(heard.errors[0].find("of piece 'sheet'"), std::string::npos);
}

TEST_F(ClothTest, DiscardsLengthsThatAreNoTimeStep) {
  const Cloth c = open();
  for (double length : {0.0, -0.001, std::nan(""), double(INFINITY)})
    EXPECT_EQ(drape_advance(c.get(), length), DRAPE_DISCARD);
  EXPECT_EQ(heard.errors.size(), 4u);
  EXPECT_EQ(drape_time(c.get()), 0);
}

TEST_F(ClothTest, KeepsItsValuesWhenACommitIsRefused) {
  const Cloth c = open();
  drape_fabric& f = drape_parameters_of(c.get())->fabric[0];
  f.areal_density = -1;
  f.warp.force[1] = 0.5;  // below the force before it
  f.poisson = std::nan("");
  EXPECT_EQ(drape_commit(c.get()), DRAPE_DISCARD);
  EXPECT_EQ(heard.errors.size(), 3u);
  EXPECT_EQ(f.areal_density, 0.15);
  EXPECT_EQ(f.warp.force[1], 9);
  EXPECT_EQ(drape_commit(c.get()), DRAPE_OK);
}

// Twice the gravity pulls twice as far in the first moment; twice the density falls the same.
TEST_F(ClothTest, TakesTunedValuesIntoTheMotion) {
  const auto fall = [&](double gravity, double density) {
    const Cloth c = open();
    drape_parameters_of(c.get())->gravity[2] = gravity;
    drape_parameters_of(c.get())->fabric[0].areal_density = density;
    EXPECT_EQ(drape_advance(c.get(), 0.002), DRAPE_OK);
    return drape_outputs_at(c.get(), 0)->probe[0].position[2];
  };
  EXPECT_NEAR(fall(-9.81, 0.15), -9.81 * 2e-6, 1e-12);
  EXPECT_NEAR(fall(-19.62, 0.15), -19.62 * 2e-6, 1e-12);
  EXPECT_NEAR(fall(-9.81, 0.3), -9.81 * 2e-6, 1e-12);
}

// A load that no diagram can carry: the cloth is thrown apart, the error names the place, the state is the
// last good one.
TEST_F(ClothTest, EndsARunThatLeavesTheFiniteNumbersAtItsLastGoodState) {
  const Cloth c = open();
  ASSERT_EQ(drape_advance(c.get(), 0.01), DRAPE_OK);
  const double before = drape_outputs_at(c.get(), 0)->probe[0].position[2];
  drape_parameters_of(c.get())->gravity[2] = -1e300;
  EXPECT_EQ(drape_advance(c.get(), 0.01), DRAPE_ERROR);
  ASSERT_EQ(heard.errors.size(), 1u);
  EXPECT_NE(heard.errors[0].find("left the finite numbers"), std::string::npos) << heard.errors[0];
  EXPECT_EQ(drape_time(c.get()), 0.01);
  EXPECT_EQ(drape_outputs_at(c.get(), 0)->probe[0].position[2], before);
  drape_parameters_of(c.get())->gravity[2] = -9.81;
  EXPECT_EQ(drape_advance(c.get(), 0.01), DRAPE_OK);
}

// A given step that becomes too large is refused, with the state kept.
TEST_F(ClothTest, DiscardsWhenTheLimitFallsBelowAGivenStep) {
  const Cloth probe = open();
  const double limit = drape_step_limit(probe.get(), nullptr);
  const Cloth c = open("step = " + std::to_string(0.9 * limit));
  ASSERT_TRUE(c);
  drape_parameters_of(c.get())->fabric[0].areal_density = 0.05;
  EXPECT_EQ(drape_advance(c.get(), 0.01), DRAPE_DISCARD);
  ASSERT_EQ(heard.errors.size(), 1u);
  EXPECT_NE(heard.errors[0].find("is above the step limit"), std::string::npos) << heard.errors[0];
  EXPECT_EQ(drape_time(c.get()), 0);
}

TEST_F(ClothTest, ASnapshotIsTheWholeTruth) {
  const Cloth c = open();
  ASSERT_EQ(drape_advance(c.get(), 0.01), DRAPE_OK);
  drape_parameters_of(c.get())->damping = 2;
  ASSERT_EQ(drape_advance(c.get(), 0.01), DRAPE_OK);
  drape_snapshot* saved = drape_save(c.get(), nullptr);
  const auto go_on = [&] {
    EXPECT_EQ(drape_advance(c.get(), 0.0213), DRAPE_OK);
    const drape_outputs* o = drape_outputs_at(c.get(), 1);
    return std::vector<double>(o->node_position, o->node_position + 3 * o->node_count);
  };
  const auto first = go_on();
  drape_parameters_of(c.get())->damping = 5;
  ASSERT_EQ(drape_advance(c.get(), 0.01), DRAPE_OK);
  drape_restore(c.get(), saved);
  EXPECT_EQ(drape_parameters_of(c.get())->damping, 2);
  EXPECT_EQ(go_on(), first);
  drape_snapshot_free(saved);
}

}  // namespace
