// The laws that a fabric's diagrams are made into.
#include "fabric/material_law.h"

#include <gtest/gtest.h>

#include <cmath>

namespace drape::fabric {
namespace {

// Diagrams up to 15 % that rise almost evenly, as laboratories state them. With a half of the residual as its
// share the iteration does not come to rest for the second and third, as each point of the law depends on the
// points beyond it. Where noise would make the law fall it stays constant, and gives more than the diagram.
TEST(MaterialLaw, OddHoldsAtEveryPointOfTheDiagram) {
  const struct {
    double spacing;  // percent
    std::vector<double> force;
  } diagrams[] = {
      {4, {0, 1, 2.2, 3.6}},
      {1.2, {0, 0.038, 0.087, 0.139, 0.203, 0.248, 0.309, 0.371, 0.441, 0.511, 0.596, 0.681, 0.860}},
      {0.52, {0,     0.038, 0.098, 0.151, 0.210, 0.267, 0.339, 0.406, 0.479, 0.531, 0.605, 0.681, 0.749,
              0.806, 0.899, 0.992, 1.087, 1.217, 1.314, 1.459, 1.566, 1.685, 1.813, 1.922, 2.098}},
  };
  for (const auto& d : diagrams) {
    scene::FabricSpec f;
    f.strip_width = 0.05;
    f.strip_gauge = 0.2;
    f.areal_density = 0.2;
    for (std::size_t k = 0; k < d.force.size(); ++k) {
      f.bias.elongation.push_back(0.01 * d.spacing * double(k));
      f.bias.force.push_back(d.force[k]);
    }
    f.bias.jaws = false;
    f.warp = f.weft = f.bias;
    std::vector<scene::Problem> problems;
    const Law law = law_make(f, {}, 0.01, "fabric.f", problems);
    ASSERT_TRUE(problems.empty()) << scene::problem_text(problems[0]);
    const double last = d.force.back() / f.strip_width;
    for (std::size_t k = 1; k < d.force.size(); ++k) {
      const double l1 = 1 + f.bias.elongation[k], l2 = std::sqrt(2 - l1 * l1),
                   g = math::curve_value(law.bias, l1 - 1);
      const bool rises = g > math::curve_value(law.bias, f.bias.elongation[k - 1]) + 1e-9 * last;
      const double more = g + math::curve_value(law.bias, 1 - l2) * l1 / l2 - d.force[k] / f.strip_width;
      EXPECT_GE(more, -1e-9 * last) << k;
      EXPECT_LE(more, (rises ? 1e-9 : 0.03) * last) << k;
    }
  }
}

}  // namespace
}  // namespace drape::fabric
