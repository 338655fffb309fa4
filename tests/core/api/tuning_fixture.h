// A sheet behind the C interface, whose parameters tests change while it moves.
#pragma once
#include <gtest/gtest.h>

#include <cmath>

#include "api/logged_cloth.h"
#include "scene_file.h"

namespace drape::tests {

constexpr double kG = 9.81, kQ = 1.0 / 1024;
constexpr int kSteps = 32;  // in an interval

// A sheet of 0.05 m x 0.05 m with its lowest point 1 m above the origin. It is free, or held at a corner.
inline Cloth open_sheet(Logged& logged, bool held, const std::string& step = "0.000030517578125",
                        const std::string& pin_keys = "", int order = 2) {
  const SceneFolder folder;
  const std::string scene = R"(
[scene]
name = "sheet"
energy = true
communication = 0.0009765625
step = )" + step +
                            "\norder = " + std::to_string(order) + R"(
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
outline = [[0, 0], [0.05, 0], [0.05, 0.05], [0, 0.05]]
place = { origin = [0, 0, 1], axis_x = [1, 0, 0], axis_y = [0, 0, 1] }
[[probe]]
name = "low"
piece = "sheet"
at = [0.03, 0]
)" + std::string(held ? "[[pin]]\nname = \"corner\"\npiece = \"sheet\"\nat = [[0, 0.05]]\n" + pin_keys : "");
  return Cloth(drape_open(folder.write("scene.toml", scene).c_str(), on_message, &logged));
}

inline void run(const Cloth& c, int intervals, int calls = 1) {
  const int in_call = intervals / calls;
  for (int k = 0; k < calls; ++k) ASSERT_EQ(drape_advance(c.get(), in_call * kQ), DRAPE_OK);
}

inline std::vector<double> nodes(const Cloth& c) {
  const drape_outputs* o = drape_get_outputs(c.get(), DRAPE_OUT_ALL);
  std::vector<double> values(o->node_position, o->node_position + 3 * o->node_count);
  values.insert(values.end(), o->node_velocity, o->node_velocity + 3 * o->node_count);
  return values;
}

inline double height(const Cloth& c) {
  return drape_get_outputs(c.get(), DRAPE_OUT_SCALARS)->probe[0].position[2];
}

inline void tune_everything(const Cloth& c) {
  drape_parameters& p = *drape_parameters_of(c.get());
  p.ramp = 7.5 * kQ;
  p.damping = 3;
  p.gravity[0] = 2;
  p.fabric[0].areal_density *= 1.5;
  p.fabric[0].warp.force[0] *= 2;
  p.fabric[0].warp.force[1] *= 2;
  p.fabric[0].bending_weft *= 3;
  p.fabric[0].poisson = 0.25;
  p.fabric[0].compression = 0.5;
}

inline drape_energy energy(const Cloth& c) { return drape_get_outputs(c.get(), DRAPE_OUT_SCALARS)->energy; }

inline double pin_force(const Cloth& c) {
  return drape_get_outputs(c.get(), DRAPE_OUT_SCALARS)->pin[0].force[2];
}

}  // namespace drape::tests
