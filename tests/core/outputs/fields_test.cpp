// Fields of particles and elongations of pieces, against the summaries of the whole cloth.
#include "outputs/fields.h"

#include <gtest/gtest.h>

#include "contact/body_fixture.h"
#include "motion/touch.h"
#include "outputs/strain.h"

namespace drape {
namespace {

// A cloth that has fallen onto a ball, which moves.
Assembled on_ball(const SceneFolder& folder) {
  Scene scene = reference::rectangle(linen(), 0.2, 0.2, 0.01);
  scene.pieces[0].place.origin = {-0.07, -0.1, 0.0507};
  body_add(scene, folder, "ball", ball(0.05, 40)).moves = true;
  Assembled a = assemble(scene);
  a.motion.inputs.body[0].position = {0.001, 0, 0.002};
  advance(a, 0.05);
  return a;
}

// The field and the summary tell the same: count, largest pressure.
TEST(Fields, PressureIsThatOfTheSummary) {
  const SceneFolder folder;
  const Assembled a = on_ball(folder);
  Fields fields;
  fields_fill(fields, a.system, a.state);
  const ContactSummary sum = touch_summary(a.system, a.state);
  std::size_t count = 0;
  double most = 0, weight = 0;
  for (const double p : fields.pressure) count += p > 0, most = std::max(most, p);
  for (const double area : fields.area) weight += area;
  ASSERT_GE(sum.count, 4u);
  EXPECT_EQ(count, sum.count);
  EXPECT_NEAR(most / sum.pressure, 1, 1e-12);
  EXPECT_NEAR(weight, 0.04, 1e-12);
}

// Of one piece, the elongations are the strains of the cloth; means of particles lie between them.
TEST(Fields, ElongationIsThatOfTheSummary) {
  const SceneFolder folder;
  const Assembled a = on_ball(folder);
  const StrainSummary sum = strain_summary(a.system, a.state);
  Fields fields;
  fields_fill(fields, a.system, a.state);
  const drape_strain of[] = {sum.warp, sum.weft, sum.bias};
  double tension = 0;
  for (const Thread along : {Thread::kWarp, Thread::kWeft, Thread::kBias}) {
    const drape_strain& all = of[std::size_t(along)];
    const double middle = (all.min + all.max) / 2;
    const Elongation e = elongation_of(a.system, a.state, a.system.lattices[0], along, middle);
    EXPECT_EQ(e.min, all.min);
    EXPECT_EQ(e.max, all.max);
    EXPECT_NEAR(e.mean, all.mean, 1e-15);
    EXPECT_GT(e.beyond, 0);
    EXPECT_LT(e.beyond, 1);
    tension = std::max(tension, e.tension_max);
    for (std::size_t k = std::size_t(along); k < fields.strain.size(); k += 3) {
      EXPECT_GE(fields.strain[k], all.min);
      EXPECT_LE(fields.strain[k], all.max);
    }
  }
  EXPECT_EQ(tension, sum.tension_max);
}

}  // namespace
}  // namespace drape
