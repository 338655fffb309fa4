// The axes of a panel after its rotation.
#include "command/garmentcode/panel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace drape::command {
namespace {

// (x, y) of a panel is at Rz Ry Rx (x, y, 0): each rotation as a matrix of its own.
TEST(ImportPanel, TurnsAboutXThenYThenZ) {
  const std::vector<double> degrees{20, -35, 130};
  Vec3 made[2];
  panel_axes(degrees, made[0], made[1]);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    Vec3 v{0, 0, 0};
    v[axis] = 1;
    for (std::size_t k = 0; k < 3; ++k) {  // about axis k, from axis i to axis j
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      const double a = degrees[k] * std::numbers::pi / 180, vi = v[i], vj = v[j];
      v[i] = std::cos(a) * vi - std::sin(a) * vj;
      v[j] = std::sin(a) * vi + std::cos(a) * vj;
    }
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(made[axis][k], v[k], 1e-15);
  }
}

}  // namespace
}  // namespace drape::command
