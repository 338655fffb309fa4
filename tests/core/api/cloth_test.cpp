// The C interface, from a scene file to outputs, and every way in which a run can fail.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "api/logged_cloth.h"

extern "C" int header_is_c(void);

namespace {

using namespace drape::tests;

const char* kScene = R"(
[scene]
name = "cloth"
energy = true
%scene
[fabric.f]
areal_density = 0.15
thickness = 0.0005
warp = { elongation_percent = %warp }
weft = { elongation_percent = [0, 2, 6], force = [0, 1, 6] }
bias = { elongation_percent = [0, 2, 6], force = [0, 0.3, 2] }
bending = { rigidity_uN_cm2 = [1370, 900] }
[[piece]]
name = "sheet"
fabric = "f"
cell = %cell
outline = [[0, 0], [%side, 0], [%side, %side], [0, %side]]
[[pin]]
name = "corner"
piece = "sheet"
at = [[0, 0]]
[[probe]]
name = "far"
piece = "sheet"
at = [%side, %side]
)";

class ClothTest : public testing::Test {
 protected:
  Logged logged;
  Cloth open(const std::string& scene_keys = "", const std::string& warp = "[0, 1, 3], force = [0, 1, 9]",
             const std::string& cell = "0.01", const std::string& side = "0.1") {
    const auto file = std::filesystem::path(testing::TempDir()) /
                      ("drape_cloth_test_" +
                       std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".toml");
    std::string text = kScene;
    const std::pair<std::string, std::string> edits[] = {
        {"%scene", scene_keys}, {"%warp", warp}, {"%cell", cell}, {"%side", side}};
    for (const auto& [from, to] : edits)
      for (std::size_t at; (at = text.find(from)) != std::string::npos;) text.replace(at, from.size(), to);
    std::ofstream(file) << text;
    Cloth cloth(drape_open(file.c_str(), on_message, &logged));
    std::filesystem::remove(file);
    return cloth;
  }
};

TEST(Header, IsC) { EXPECT_EQ(header_is_c(), 0); }

TEST_F(ClothTest, AWholeRun) {
  const Cloth c = open();
  ASSERT_TRUE(c);
  const double weight = 0.15 * 0.01 * 9.81;
  // At first the pin bears its own node only: the cloth around it starts to fall.
  EXPECT_NEAR(drape_get_outputs(c.get(), DRAPE_OUT_SCALARS)->pin[0].force[2], -weight / 400, 1e-15);
  for (int k = 0; k < 20; ++k) ASSERT_EQ(drape_advance(c.get(), 0.01), DRAPE_OK);
  EXPECT_NEAR(drape_time(c.get()), 0.2, 1e-15);
  const drape_outputs* o = drape_get_outputs(c.get(), DRAPE_OUT_ALL);
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
  ASSERT_EQ(logged.errors.size(), 1u);
  EXPECT_NE(logged.errors[0].find("scene.step = 0.001 s; allowed: above 0, at most the step limit"),
            std::string::npos)
      << logged.errors[0];
  EXPECT_NE(logged.errors[0].find("of piece 'sheet'"), std::string::npos);
}

TEST_F(ClothTest, DiscardsLengthsThatAreNoTimeStep) {
  const Cloth c = open();
  for (double length : {0.0, -0.001, std::nan(""), double(INFINITY)})
    EXPECT_EQ(drape_advance(c.get(), length), DRAPE_DISCARD);
  EXPECT_EQ(logged.errors.size(), 4u);
  // At most 1e9 intervals of 1 ms: the clock counts intervals in an integer.
  EXPECT_EQ(drape_advance(c.get(), 1e20), DRAPE_DISCARD);
  EXPECT_EQ(drape_advance(c.get(), 1.001e6), DRAPE_DISCARD);
  EXPECT_EQ(
      logged.errors.back(),
      "the length of an advance is 1.001e+06 s; allowed: at most 1e+06 s, 1e+09 communication intervals");
  EXPECT_EQ(drape_time(c.get()), 0);
}

// A step that the clock cannot count leaves everything as it was.
TEST_F(ClothTest, DiscardsLengthsBelowTheLastBitOfTheClock) {
  for (const auto& [start, length, shortest] :
       {std::tuple{0.0, 1e-18, "1e-12"}, {0.0, 0.9e-12, "1e-12"}, {1e6, 1e-10, "1.16415e-10"}}) {
    const Cloth c = open(), untouched = open();
    ASSERT_EQ(drape_start(c.get(), start), DRAPE_OK);
    ASSERT_EQ(drape_start(untouched.get(), start), DRAPE_OK);
    EXPECT_EQ(drape_advance(c.get(), length), DRAPE_DISCARD);
    EXPECT_NE(logged.errors.back().find(std::string("allowed: at least ") + shortest + " s at this time"),
              std::string::npos)
        << logged.errors.back();
    for (const Cloth* of : {&c, &untouched}) ASSERT_EQ(drape_advance(of->get(), 0.01), DRAPE_OK);
    EXPECT_EQ(drape_get_outputs(c.get(), DRAPE_OUT_SCALARS)->probe[0].position[1],
              drape_get_outputs(untouched.get(), DRAPE_OUT_SCALARS)->probe[0].position[1]);
    EXPECT_EQ(drape_get_outputs(c.get(), DRAPE_OUT_SCALARS)->step_count,
              drape_get_outputs(untouched.get(), DRAPE_OUT_SCALARS)->step_count);
  }
}

TEST_F(ClothTest, RefusesStartTimesBeyondABillionSeconds) {
  const Cloth c = open();
  for (double start : {1.1e9, -1.1e9, std::nan(""), double(INFINITY)})
    EXPECT_EQ(drape_start(c.get(), start), DRAPE_DISCARD);
  EXPECT_EQ(logged.errors.front(), "the start time is 1.1e+09 s; allowed: from -1e+09 to 1e+09 s");
  EXPECT_EQ(drape_start(c.get(), -1e9), DRAPE_OK);
}

// Each fault is reported and its value restored; a diagram that falls is restored as a whole. All other
// values are in force.
TEST_F(ClothTest, PutsBackOnlyWhatIsAtFault) {
  const Cloth c = open();
  drape_parameters& p = *drape_parameters_of(c.get());
  drape_fabric& f = p.fabric[0];
  p.damping = 3;
  p.gravity[0] = INFINITY;
  f.areal_density = 0.3;
  f.warp.force[0] = 8;
  f.warp.force[1] = 7;  // below the force before it
  f.weft.force[1] = 12;
  f.poisson = std::nan("");
  f.bending_warp = -1;
  EXPECT_EQ(drape_commit(c.get()), DRAPE_DISCARD);
  EXPECT_EQ(logged.errors,
            (std::vector<std::string>{"gravity[1] = inf m/s2; allowed: from -10000 to 10000 m/s2",
                                      "fabric.f.bending.warp = -1 N.m; allowed: from 0 to 1000 N.m",
                                      "fabric.f.poisson = nan; allowed: from 0 to 0.999",
                                      "fabric.f.warp.force[2] = 7 N; allowed: at least the force before it, "
                                      "8 N: a diagram does not fall"}));
  EXPECT_EQ(p.gravity[0], 0);
  EXPECT_EQ(f.warp.force[0], 1);
  EXPECT_EQ(f.warp.force[1], 9);
  EXPECT_EQ(f.poisson, 0);
  EXPECT_EQ(f.bending_warp, 1370e-10 / 0.03);
  EXPECT_EQ(p.damping, 3);
  EXPECT_EQ(f.areal_density, 0.3);
  EXPECT_EQ(f.weft.force[1], 12);
  EXPECT_EQ(drape_commit(c.get()), DRAPE_OK);
  // The other values are in force: the motion is that of a cloth in which only they were set.
  const Cloth same = open();
  drape_parameters_of(same.get())->damping = 3;
  drape_parameters_of(same.get())->fabric[0].areal_density = 0.3;
  drape_parameters_of(same.get())->fabric[0].weft.force[1] = 12;
  for (drape_cloth* cloth : {c.get(), same.get()}) ASSERT_EQ(drape_advance(cloth, 0.02), DRAPE_OK);
  for (int k = 0; k < 3; ++k)
    EXPECT_EQ(drape_get_outputs(c.get(), DRAPE_OUT_SCALARS)->probe[0].position[k],
              drape_get_outputs(same.get(), DRAPE_OUT_SCALARS)->probe[0].position[k]);
}

// A commit allows exactly what the scene's ranges allow.
TEST_F(ClothTest, TakesTheEndsOfEveryRange) {
  const Cloth c = open();
  drape_parameters& p = *drape_parameters_of(c.get());
  const auto expect_range = [&](double& value, double low, double high) {
    const double before = value;
    for (const double end : {low, high}) {
      value = end;
      EXPECT_EQ(drape_commit(c.get()), DRAPE_OK) << logged.errors.back();
      EXPECT_EQ(value, end);
      const double beyond = end == low ? std::nextafter(low, -1e30) : std::nextafter(high, 1e30);
      value = beyond;
      EXPECT_EQ(drape_commit(c.get()), DRAPE_DISCARD) << beyond;
      EXPECT_EQ(value, end);
    }
    value = before;
    EXPECT_EQ(drape_commit(c.get()), DRAPE_OK);
  };
  expect_range(p.damping, 0, 1e6);
  for (double& g : p.gravity) expect_range(g, -1e4, 1e4);
  expect_range(p.step_max, 1e-9, 1e3);
  expect_range(p.threads, 1, 64);
  expect_range(p.fabric[0].areal_density, 1e-4, 100);
  expect_range(p.fabric[0].bending_warp, 0, 1000);
  expect_range(p.fabric[0].bending_weft, 0, 1000);
  expect_range(p.fabric[0].poisson, 0, 0.999);
  expect_range(p.fabric[0].compression, 0, 1);
  expect_range(p.fabric[0].warp.force[1], 1, 1e6);  // the force before it is 1 N
}

// Twice the gravity moves the cloth twice as far in the first moment. Twice the density falls the same.
TEST_F(ClothTest, AppliesTunedValuesToTheMotion) {
  const auto fall = [&](double gravity, double density) {
    const Cloth c = open();
    drape_parameters_of(c.get())->gravity[2] = gravity;
    drape_parameters_of(c.get())->fabric[0].areal_density = density;
    EXPECT_EQ(drape_advance(c.get(), 0.002), DRAPE_OK);
    return drape_get_outputs(c.get(), DRAPE_OUT_SCALARS)->probe[0].position[2];
  };
  EXPECT_NEAR(fall(-9.81, 0.15), -9.81 * 2e-6, 1e-12);
  EXPECT_NEAR(fall(-19.62, 0.15), -19.62 * 2e-6, 1e-12);
  EXPECT_NEAR(fall(-9.81, 0.3), -9.81 * 2e-6, 1e-12);
}

// A warp that yields up to 1 % and then hardly at all, at 1 N within a strain of 1e-6. Once the cloth has
// fallen that far, no step is short enough. The error names the place, and the state is the last good one.
TEST_F(ClothTest, EndsARunThatNoStepCanFollowAtItsLastGoodState) {
  const Cloth c = open("", "[0, 1, 1.0001], force = [0, 1e-6, 1e6]");
  drape_parameters_of(c.get())->gravity[2] = 0;
  ASSERT_EQ(drape_advance(c.get(), 0.01), DRAPE_OK);
  const double before = drape_get_outputs(c.get(), DRAPE_OUT_SCALARS)->probe[0].position[1];
  drape_parameters_of(c.get())->gravity[1] = 1000;
  EXPECT_EQ(drape_advance(c.get(), 0.01), DRAPE_ERROR);
  ASSERT_EQ(logged.errors.size(), 1u);
  EXPECT_NE(logged.errors[0].find(
                "more than 1e+06 steps in a communication interval, set by the warp link of piece "
                "'sheet'"),
            std::string::npos)
      << logged.errors[0];
  EXPECT_EQ(logged.errors[0].find('%'), std::string::npos);
  EXPECT_EQ(drape_time(c.get()), 0.01);
  EXPECT_EQ(drape_get_outputs(c.get(), DRAPE_OUT_SCALARS)->probe[0].position[1], before);
  EXPECT_FALSE(drape_step_above_limit(c.get()));
  drape_parameters_of(c.get())->gravity[1] = 0;
  EXPECT_EQ(drape_advance(c.get(), 0.01), DRAPE_OK);
}

// More than a million steps in an interval of 1 ms are refused, when the scene is opened and when values are
// set.
TEST_F(ClothTest, RefusesMoreThanAMillionStepsAnInterval) {
  EXPECT_FALSE(open("", "[0, 1e-6, 3], force = [0, 1e6, 1e6]"));
  EXPECT_FALSE(open("step = 0.999e-9"));
  EXPECT_TRUE(open("step = 1.001e-9"));
  ASSERT_EQ(logged.errors.size(), 2u);
  EXPECT_NE(logged.errors[0].find("scene.communication = 0.001 s takes "), std::string::npos)
      << logged.errors[0];
  EXPECT_NE(logged.errors[0].find(" steps; allowed: at most 1e+06, but the step limit is "),
            std::string::npos);
  EXPECT_NE(logged.errors[0].find(" s, set by the warp link of piece 'sheet', column 1, row "),
            std::string::npos);
  EXPECT_NE(logged.errors[1].find(
                "scene.step = 9.99e-10 s takes 1.001e+06 steps in a communication interval of 0.001 s; "
                "allowed: at most 1e+06, 1e-09 s or more each"),
            std::string::npos)
      << logged.errors[1];

  const Cloth c = open("communication = 10");
  drape_parameters_of(c.get())->step_max = 1e-6;
  drape_parameters_of(c.get())->damping = 2;
  EXPECT_EQ(drape_commit(c.get()), DRAPE_DISCARD);
  EXPECT_EQ(logged.errors.back(),
            "step.max = 1e-06 s takes 1e+07 steps in a communication interval of 10 s; allowed: at most "
            "1e+06, 1e-05 s "
            "or more each");
  EXPECT_EQ(drape_parameters_of(c.get())->step_max, 10);
  EXPECT_EQ(drape_parameters_of(c.get())->damping, 2);
}

// Lengths whose squares underflow would give no masses: the points coincide.
TEST_F(ClothTest, RefusesAPieceWithoutExtent) {
  EXPECT_FALSE(open("", "[0, 1, 3], force = [0, 1, 9]", "1e-170", "1e-169"));
  ASSERT_EQ(logged.errors.size(), 4u);
  EXPECT_NE(logged.errors[0].find("outline[1] = [1e-169, 0] m repeats point 0"), std::string::npos)
      << logged.errors[0];
}

// Without laws there is no limit: the step is the communication interval.
TEST_F(ClothTest, NeedsNoStepLimitWhereNoLawActs) {
  const Cloth c = open("", "[0, 1], force = [0, 0]");
  ASSERT_TRUE(c);
  drape_fabric& f = drape_parameters_of(c.get())->fabric[0];
  f.bending_warp = f.bending_weft = 0;
  for (double* force : {f.weft.force, f.bias.force}) force[0] = force[1] = 0;
  ASSERT_EQ(drape_commit(c.get()), DRAPE_OK) << logged.errors[0];
  EXPECT_EQ(drape_step_limit(c.get(), nullptr), INFINITY);
  EXPECT_EQ(drape_advance(c.get(), 0.01), DRAPE_OK);
  EXPECT_EQ(drape_get_outputs(c.get(), DRAPE_OUT_SCALARS)->step_count, 10);
}

// Values that would bring the limit below a given step are refused when they are committed. The fabric keeps
// its old values, all other values are applied, and the run continues.
TEST_F(ClothTest, RefusesAFabricThatAGivenStepCannotFollow) {
  const Cloth probe = open();
  const double limit = drape_step_limit(probe.get(), nullptr);
  const Cloth c = open("step = " + std::to_string(0.9 * limit));
  ASSERT_TRUE(c);
  ASSERT_EQ(drape_advance(c.get(), 0.01), DRAPE_OK);
  drape_parameters& p = *drape_parameters_of(c.get());
  p.fabric[0].areal_density = 0.05;
  p.fabric[0].compression = 0.5;
  p.damping = 2;
  EXPECT_EQ(drape_advance(c.get(), 0.01), DRAPE_DISCARD);
  ASSERT_EQ(logged.errors.size(), 1u);
  EXPECT_EQ(logged.errors[0].find("fabric.f keeps its values: with those set, scene.step = "), 0u)
      << logged.errors[0];
  EXPECT_NE(logged.errors[0].find(" s; allowed: above 0, at most the step limit "), std::string::npos);
  EXPECT_NE(logged.errors[0].find(" of piece 'sheet', column "), std::string::npos);
  EXPECT_EQ(drape_time(c.get()), 0.01);
  EXPECT_FALSE(drape_step_above_limit(c.get()));
  EXPECT_EQ(p.fabric[0].areal_density, 0.15);
  EXPECT_EQ(p.fabric[0].compression, 1);
  EXPECT_EQ(p.damping, 2);
  EXPECT_EQ(drape_advance(c.get(), 0.01), DRAPE_OK);
}

// The motion itself stretches the cloth until a given step is too large: every further advance is refused,
// unless something changes.
TEST_F(ClothTest, StopsWhereTheLimitFallsBelowAGivenStep) {
  const std::string stiffening = "[0, 1, 3], force = [0, 0.1, 1000]";
  const Cloth probe = open("", stiffening);
  const double limit = drape_step_limit(probe.get(), nullptr);
  const Cloth c = open("step = " + std::to_string(0.9 * limit), stiffening);
  ASSERT_TRUE(c);
  drape_parameters& p = *drape_parameters_of(c.get());
  p.gravity[1] = 300;
  drape_status status = DRAPE_OK;
  for (int k = 0; k < 1000 && status == DRAPE_OK; ++k) status = drape_advance(c.get(), 0.001);
  ASSERT_EQ(status, DRAPE_DISCARD);
  EXPECT_NE(logged.errors[0].find("is above the step limit, which fell to"), std::string::npos)
      << logged.errors[0];
  EXPECT_TRUE(drape_step_above_limit(c.get()));
  EXPECT_EQ(drape_advance(c.get(), 0.001), DRAPE_DISCARD);
  EXPECT_TRUE(drape_step_above_limit(c.get()));
  p.fabric[0].warp.force[1] = 0.3;  // softer again
  EXPECT_EQ(drape_advance(c.get(), 0.001), DRAPE_OK) << logged.errors.back();
  EXPECT_FALSE(drape_step_above_limit(c.get()));
}

TEST_F(ClothTest, ASnapshotIsTheWholeTruth) {
  const Cloth c = open();
  ASSERT_EQ(drape_advance(c.get(), 0.01), DRAPE_OK);
  drape_parameters_of(c.get())->damping = 2;
  ASSERT_EQ(drape_advance(c.get(), 0.01), DRAPE_OK);
  drape_snapshot* saved = drape_save(c.get(), nullptr);
  const auto go_on = [&] {
    EXPECT_EQ(drape_advance(c.get(), 0.0213), DRAPE_OK);
    const drape_outputs* o = drape_get_outputs(c.get(), DRAPE_OUT_ALL);
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
