// Bodies that a master moves: by positions alone, by velocities alone, by both.
#include <gtest/gtest.h>

#include <cmath>

#include "api/logged_cloth.h"
#include "scene_file.h"

namespace drape::api {

using namespace tests;
namespace {

constexpr double kSpeed = 0.5, kTime = 0.2;  // m/s, reached within this time, s

// The belt speeds up evenly and then keeps its speed.
double place_at(double t) { return t < kTime ? kSpeed * t * t / (2 * kTime) : kSpeed * (t - kTime / 2); }
double speed_at(double t) { return t < kTime ? kSpeed * t / kTime : kSpeed; }

// Cloth of 0.1 m x 0.1 m lies on a belt with a coefficient of friction of 0.8; body_keys are the belt's.
Cloth open_ride(const SceneFolder& folder, Logged& told, const std::string& body_keys,
                const std::string& scene_keys = "") {
  std::string mesh;
  for (const char* p : {"-0.2 -0.2 -0.05", "0.6 -0.2 -0.05", "0.6 0.2 -0.05", "-0.2 0.2 -0.05", "-0.2 -0.2 0",
                        "0.6 -0.2 0", "0.6 0.2 0", "-0.2 0.2 0"})
    mesh += "v " + std::string(p) + "\n";
  mesh += "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  folder.write("belt.obj", mesh);
  return Cloth(drape_open(folder
                              .write("scene.toml", R"(
[scene]
name = "ride"
)" + scene_keys + R"(
[fabric.f]
areal_density = 0.2
thickness = 0.0005
friction = 0.8
warp = { elongation_percent = [0, 10], force = [0, 100] }
weft = { elongation_percent = [0, 10], force = [0, 100] }
bias = { elongation_percent = [0, 10], force = [0, 10] }
[[piece]]
name = "p"
fabric = "f"
cell = 0.02
outline = [[0, 0], [0.1, 0], [0.1, 0.1], [0, 0.1]]
place = { origin = [0, 0, 0.00025], axis_x = [1, 0, 0], axis_y = [0, 1, 0] }
[[probe]]
name = "m"
piece = "p"
at = [0.05, 0.05]
[[body]]
name = "belt"
mesh = "belt.obj"
moves = true
)" + body_keys)
                              .c_str(),
                          on_message, &told));
}

// How far the cloth has slid on the belt after 0.4 s, m.
double slid(const Cloth& c, double step, bool by_position, bool by_velocity) {
  drape_pin_input& in = drape_inputs_of(c.get())->body[0];
  double t = 0;
  for (int k = 1; t < 0.4 - step / 2; ++k) {
    t = k * step;
    if (by_position) in.position[0] = place_at(t);
    if (by_velocity) in.velocity[0] = speed_at(t);
    EXPECT_EQ(drape_advance(c.get(), step), DRAPE_OK);
  }
  return drape_get_outputs(c.get(), DRAPE_OUT_SCALARS)->probe[0].position[0] - 0.05 - place_at(t);
}

TEST(BodyDrive, ClothRidesWhateverTheBodyIsMovedBy) {
  const SceneFolder folder;
  struct {
    const char* keys;
    bool by_position, by_velocity;
  } const cases[] = {{"", true, false},
                     {"", true, true},
                     {"drive = \"position\"\n", true, false},
                     {"drive = \"velocity\"\n", false, true},
                     {"drive = \"both\"\n", true, true}};
  for (const auto& of : cases) {
    Logged told;
    const Cloth c = open_ride(folder, told, of.keys);
    ASSERT_TRUE(c) << told.errors[0];
    const int bits = drape_inputs_of(c.get())->body[0].drive;
    EXPECT_EQ((bits & DRAPE_DRIVE_POSITION) != 0, of.by_position || !*of.keys) << of.keys;
    EXPECT_EQ((bits & DRAPE_DRIVE_VELOCITY) != 0, of.by_velocity || !*of.keys) << of.keys;
    EXPECT_LE(std::abs(slid(c, 0.001, of.by_position, of.by_velocity)), 5e-4) << of.keys;
    EXPECT_TRUE(told.errors.empty() && told.warnings.empty()) << of.keys;
  }
}

// Positions every 10 ms: the belt's speed changes by 2.5 % of its last at each of them.
TEST(BodyDrive, ClothRidesOnPositionsFarApart) {
  const SceneFolder folder;
  Logged told;
  const Cloth c = open_ride(folder, told, "");
  EXPECT_LE(std::abs(slid(c, 0.01, true, false)), 2e-3);
}

TEST(BodyDrive, ReportsOnceThatPositionsAndVelocitiesContradictEachOther) {
  const SceneFolder folder;
  Logged told;
  const Cloth c = open_ride(folder, told, "drive = \"both\"\n");
  slid(c, 0.01, true, false);
  ASSERT_EQ(told.warnings.size(), 1u);
  EXPECT_NE(told.warnings[0].find("body.belt: its positions move it at"), std::string::npos);
  EXPECT_NE(told.warnings[0].find("its velocities at 0 m/s"), std::string::npos) << told.warnings[0];
}

// At 10 km/s a step of a second's millionth is too long; the error names what it is for.
TEST(BodyDrive, ThatNoStepCanFollowIsNamed) {
  const SceneFolder folder;
  Logged told;
  const Cloth c = open_ride(folder, told, "drive = \"velocity\"\n", "communication = 1");
  drape_inputs_of(c.get())->body[0].velocity[0] = 1e4;
  EXPECT_EQ(drape_advance(c.get(), 1), DRAPE_ERROR);
  ASSERT_EQ(told.errors.size(), 1u);
  EXPECT_NE(told.errors[0].find("steps in a communication interval, set by the node of piece 'p', column "),
            std::string::npos)
      << told.errors[0];
  EXPECT_NE(told.errors[0].find(", which body 'belt' approaches at up to "), std::string::npos)
      << told.errors[0];
}

// The belt turns about z by 0.02 rad in 10 ms: at 2 rad/s.
std::size_t belt_turn(Logged& told, double angular_velocity) {
  const SceneFolder folder;
  const Cloth c = open_ride(folder, told, "drive = \"both\"\n");
  drape_pin_input& in = drape_inputs_of(c.get())->body[0];
  for (int k = 1; k <= 3; ++k) {
    in.orientation[0] = std::cos(0.01 * k);
    in.orientation[3] = std::sin(0.01 * k);
    in.angular_velocity[2] = angular_velocity;
    EXPECT_EQ(drape_advance(c.get(), 0.01), DRAPE_OK);
  }
  return told.warnings.size();
}

TEST(BodyDrive, ReportsOnceThatOrientationsAndAngularVelocitiesContradictEachOther) {
  Logged still, other, same;
  ASSERT_EQ(belt_turn(still, 0), 1u);
  EXPECT_NE(
      still.warnings[0].find("body.belt: its orientations turn it at 2 rad/s, its angular velocities at "
                             "0 rad/s"),
      std::string::npos)
      << still.warnings[0];
  EXPECT_EQ(belt_turn(other, -2), 1u);  // the other way round
  EXPECT_EQ(belt_turn(same, 2), 0u);
}

TEST(BodyDrive, IsOfBodiesThatMove) {
  const SceneFolder folder;
  Logged told;
  EXPECT_FALSE(open_ride(folder, told,
                         "drive = \"both\"\n[[body]]\nname = \"table\"\nmesh = \"belt.obj\"\n"
                         "position = [0, 0, -1]\ndrive = \"position\"\n"));
  ASSERT_EQ(told.errors.size(), 1u);
  EXPECT_NE(told.errors[0].find("drive is of a body that moves"), std::string::npos) << told.errors[0];
}

// A clamp along an edge, driven by both.
TEST(PinDrive, ReportsOnceOfEachKindThatTheInputsContradictEachOther) {
  const SceneFolder folder;
  Logged told;
  const Cloth c(drape_open(folder
                               .write("scene.toml", R"(
[scene]
name = "pole"
[fabric.f]
areal_density = 0.2
thickness = 0.0005
warp = { elongation_percent = [0, 10], force = [0, 100] }
weft = { elongation_percent = [0, 10], force = [0, 100] }
bias = { elongation_percent = [0, 10], force = [0, 10] }
bending = { rigidity_uN_cm2 = [900, 900] }
[[piece]]
name = "p"
fabric = "f"
cell = 0.02
outline = [[0, 0], [0.1, 0], [0.1, 0.1], [0, 0.1]]
[[pin]]
name = "pole"
piece = "p"
edges = [3]
hold = "clamp"
drive = "both"
)")
                               .c_str(),
                           on_message, &told));
  ASSERT_TRUE(c) << told.errors[0];
  drape_pin_input& in = drape_inputs_of(c.get())->pin[0];
  const double start = in.position[0];
  const auto step = [&](int k, double velocity, double angular_velocity) {
    in.position[0] = start + 1e-4 * k;  // at 0.1 m/s
    in.velocity[0] = velocity;
    in.orientation[0] = std::cos(5e-4 * k);  // at 1 rad/s
    in.orientation[2] = std::sin(5e-4 * k);
    in.angular_velocity[1] = angular_velocity;
    EXPECT_EQ(drape_advance(c.get(), 0.001), DRAPE_OK);
  };
  for (int k = 1; k <= 3; ++k) step(k, 0.1, 1);
  EXPECT_TRUE(told.warnings.empty()) << told.warnings[0];
  for (int k = 4; k <= 9; ++k) step(k, 0.1, -1);
  ASSERT_EQ(told.warnings.size(), 1u);
  EXPECT_NE(told.warnings[0].find("pin.pole: its orientations turn it at"), std::string::npos);
  for (int k = 10; k <= 19; ++k) step(k, 0, -1);
  ASSERT_EQ(told.warnings.size(), 2u);
  EXPECT_NE(told.warnings[1].find("pin.pole: its positions move it at 0.1 m/s"), std::string::npos)
      << told.warnings[1];
}

}  // namespace
}  // namespace drape::api
