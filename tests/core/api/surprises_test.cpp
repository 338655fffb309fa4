// Legal values that surprise: they are taken, with a warning.
#include <gtest/gtest.h>

#include "api/tuning_fixture.h"

namespace drape::tests {
namespace {

Cloth open_scene(Logged& warned, const std::string& keys = "") {
  const SceneFolder folder;
  return Cloth(drape_open(folder
                              .write("scene.toml", R"([scene]
name = "sheet"
)" + keys + R"([fabric.f]
areal_density = 0.15
thickness = 0.0005
warp = { elongation_percent = [0, 1, 3], force = [0, 1, 9] }
weft = { elongation_percent = [0, 2, 6], force = [0, 1, 6] }
[[piece]]
name = "sheet"
fabric = "f"
cell = 0.01
outline = [[0, 0], [0.05, 0], [0.05, 0.05], [0, 0.05]]
[[pin]]
name = "edge"
piece = "sheet"
edges = [3]
hold = "clamp"
drive = "position"
)")
                              .c_str(),
                          on_message, &warned));
}

TEST(Surprises, ADampingThatCutsTheStepIsTold) {
  Logged warned;
  const Cloth c = open_scene(warned);
  ASSERT_EQ(drape_advance(c.get(), 0.001), DRAPE_OK);
  EXPECT_FALSE(drape_surprised(c.get()));
  drape_parameters_of(c.get())->fabric[0].damping = 0.005;
  ASSERT_EQ(drape_commit(c.get()), DRAPE_OK);
  EXPECT_TRUE(drape_surprised(c.get()));
  ASSERT_EQ(warned.warnings.size(), 1u);
  for (const char* part :
       {"with fabric.f.damping = 0.005 s the time step falls from about ", " times as long; ", "set by the "})
    EXPECT_NE(warned.warnings[0].find(part), std::string::npos) << warned.warnings[0];
  ASSERT_EQ(drape_commit(c.get()), DRAPE_OK);
  EXPECT_FALSE(drape_surprised(c.get())) << "told once";
  EXPECT_EQ(drape_parameters_of(c.get())->fabric[0].damping, 0.005) << "and taken";
}

TEST(Surprises, WhatCutsTheStepLessIsNot) {
  Logged warned;
  const Cloth c = open_scene(warned);
  drape_parameters& p = *drape_parameters_of(c.get());
  p.fabric[0].areal_density /= 50;  // steps 7 times shorter
  p.step_max = 1e-8;                // asked for in so many words
  ASSERT_EQ(drape_commit(c.get()), DRAPE_OK);
  EXPECT_FALSE(drape_surprised(c.get()));
  EXPECT_TRUE(warned.warnings.empty());
}

TEST(Surprises, FourZerosKeepTheOrientation) {
  Logged warned;
  const Cloth c = open_scene(warned), turned = open_scene(warned);
  for (int k = 0; k < 3; ++k) {
    double* q = drape_inputs_of(c.get())->pin[0].orientation;
    drape_inputs_of(c.get())->pin[0].position[2] = 0.001 * k;
    drape_inputs_of(turned.get())->pin[0].position[2] = 0.001 * k;
    q[0] = q[1] = q[2] = q[3] = 0;  // as a master does to what is not connected
    ASSERT_EQ(drape_advance(c.get(), 0.001), DRAPE_OK);
    ASSERT_EQ(drape_advance(turned.get(), 0.001), DRAPE_OK);
    EXPECT_EQ(drape_surprised(c.get()), k == 0);
    EXPECT_EQ(nodes(c), nodes(turned));
    EXPECT_EQ(q[0], 1);
  }
  ASSERT_EQ(warned.warnings.size(), 1u);
  EXPECT_EQ(warned.warnings[0],
            "pin.edge.orientation is four zeros, and no rotation: the orientation stays as it is");
  EXPECT_TRUE(warned.errors.empty());
}

TEST(Surprises, AnotherModeIsRefused) {
  Logged warned;
  const Cloth c = open_scene(warned), fit = open_scene(warned, "mode = \"fit\"\n");
  EXPECT_EQ(drape_parameters_of(c.get())->mode, DRAPE_MODE_DYNAMIC);
  EXPECT_EQ(drape_parameters_of(fit.get())->mode, DRAPE_MODE_FIT);
  for (const double mode : {2.0, 0.0, 1.5, std::nan("")}) {
    drape_parameters_of(c.get())->mode = mode;
    EXPECT_EQ(drape_commit(c.get()), DRAPE_DISCARD);
    EXPECT_NE(warned.errors.back().find("; allowed: 1 (dynamic), the mode of the scene"), std::string::npos);
    EXPECT_EQ(drape_parameters_of(c.get())->mode, DRAPE_MODE_DYNAMIC);
  }
}

}  // namespace
}  // namespace drape::tests
