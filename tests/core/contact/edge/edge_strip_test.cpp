// A strip pulled over the sharp edge of a roof: where it rests, and how friction raises its tension.
#include "contact/edge/edge_contact.h"

#include <gtest/gtest.h>

#include "body_fixture.h"
#include "math/vector3.h"

namespace drape::contact {

using namespace tests;
namespace {

using namespace math::vector3;

constexpr double kPi = std::numbers::pi;

// A strip of `links` links along x over the roof, one cell wide, whose ends are pulled down by pins.
struct Strip {
  Assembled a;
  double cell;
  Vec3 node(int i) const {  // mean of both sides
    Vec3 sum{0, 0, 0};
    for (int j = 0; j < 2; ++j) {
      const std::size_t n = a.system.lattices[0].node(i, j);
      sum += 0.5 * Vec3{a.state.x[n], a.state.y[n], a.state.z[n]};
    }
    return sum;
  }
  Vec3 along(int i) const {  // of link i
    const Vec3 e = node(i + 1) - node(i);
    return (1 / norm(e)) * e;
  }
  double strain(int i) const { return norm(node(i + 1) - node(i)) / cell - 1; }
  // The link over x = 0, and how far it is from the ridge there.
  int over() const {
    int i = 0;
    while (node(i + 1)[0] < 0) ++i;
    return i;
  }
  double distance() const {
    const int i = over();
    const Vec3 e = along(i), p = node(i);
    return p[2] * e[0] - p[0] * e[2];  // across the link
  }
};

constexpr double kSlope = 2000;  // N/m per width

Strip strip_over_roof(const SceneFolder& folder, int links, double cell, double shift, double mu, bool fit) {
  scene::FabricSpec fabric = linen();
  fabric.bias = {};
  fabric.bending_warp = fabric.bending_weft = 0;
  fabric.friction = {mu, mu};
  Scene scene = reference::rectangle(fabric, links * cell, cell, cell);
  scene.gravity = {0, 0, 0};
  scene.damping = fit ? 0 : 200;
  if (fit) scene.mode = scene::Mode::kFit;
  scene.bias_model = scene::BiasModel::kOdd;
  scene.pieces[0].place.origin = {-links * cell / 2 + shift, -0.0437 * cell, 0.0008};
  scene.pins = {reference::pin_edges("left", {3}), reference::pin_edges("right", {1})};
  for (scene::PinSpec& pin : scene.pins) pin.drive = scene::Drive::kPosition;
  body_add(scene, folder, "roof", roof(kPi / 4));
  return {assemble(scene), cell};
}

// Pulls the ends to angles below the horizontal, at `stretch` times the length from the ridge.
void strip_pull(Strip& s, double left, double right, double stretch, double time) {
  dynamics::Inputs& to = s.a.motion.inputs;
  const double was[2] = {norm(Vec3{to.pin[0].position[0], 0, 0}), norm(Vec3{to.pin[1].position[0], 0, 0})};
  to.pin[0].position[0] = -stretch * was[0] * std::cos(left);
  to.pin[0].position[2] = -stretch * was[0] * std::sin(left);
  to.pin[1].position[0] = stretch * was[1] * std::cos(right);
  to.pin[1].position[2] = -stretch * was[1] * std::sin(right);
  advance(s.a, time);
}

// A taut frictionless strip rests on the ridge by one link. What the body carries is what the links beside it
// pull, and is at right angles to the link; of both, up to the forces that a fit leaves: 1e-5 of the pins'.
TEST(EdgeContactStrip, ATautStripRestsOnItByALink) {
  const SceneFolder folder;
  for (const double shift : {0.0, 0.0021}) {
    Strip s = strip_over_roof(folder, 9, 0.01, shift, 0, true);
    strip_pull(s, 0.5, 0.35, 1.01, 0.2);
    for (double t = 0; t < 20 && !s.a.state.relaxation.at_rest; t += 0.1) advance(s.a, 0.1);
    ASSERT_TRUE(s.a.state.relaxation.at_rest) << "residual " << s.a.state.relaxation.residual;
    const int i = s.over();
    const double contact_distance = s.a.system.lattices[0].contact_law.distance, width = 0.01;
    const Vec3 force = body_force(s.a), e = s.along(i);
    const double left = kSlope * width * s.strain(i - 1), right = kSlope * width * s.strain(i + 1);
    const Vec3 pulled = right * s.along(i + 1) - left * s.along(i - 1);
    const double left_over = 1e-5 * s.a.state.relaxation.load;
    EXPECT_GT(left, 0.05);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(force[k], pulled[k], left_over) << k;
    EXPECT_LT(std::abs(dot(force, e)), left_over);
    EXPECT_GE(s.distance(), (1 - kContactDeepest) * contact_distance * (1 - 1e-6)) << "shift " << shift;
    EXPECT_LE(s.distance(), contact_distance);
    if (shift == 0)
      std::printf("rests at %.4f layers, T = %.3f and %.3f N\n", s.distance() / contact_distance, left,
                  right);
  }
}

// A strip that is pulled over the ridge by one link, with friction: with the angles a, c of the links beside
// it from the straddling one, which the body pushes by P across and mu P along,
//
//   T2 cos c - T1 cos a = mu P,  P = T1 sin a + T2 sin c:   T2/T1 = (cos a + mu sin a)/(cos c - mu sin c),
//
// which is (1 + mu tan(D/2))/(1 - mu tan(D/2)) for a = c = D/2. The strip sings as it slides: means over the
// last half.
TEST(EdgeContactStrip, TensionGrowsOverItAsRoundACapstan) {
  const SceneFolder folder;
  for (const double mu : {0.0, 0.3}) {
    Strip s = strip_over_roof(folder, 9, 0.01, -0.003, mu, false);
    strip_pull(s, 0.5, 0.5, 1.005, 0.2);
    advance(s.a, 0.2);
    const int i = s.over(), advances = 900, measured = 300;
    const Vec3 start[2] = {s.a.state.pin_motion[0].position, s.a.state.pin_motion[1].position};
    const Vec3 way[2] = {s.along(0), s.along(8)};
    double strain[2] = {0, 0}, angle[2] = {0, 0};
    for (int k = 1; k <= advances; ++k) {
      for (std::size_t p = 0; p < 2; ++p)
        s.a.motion.inputs.pin[p].position = start[p] + 0.003 * k / advances * way[p];
      advance(s.a, 1e-3);
      ASSERT_EQ(s.over(), i);
      if (k <= advances - measured) continue;
      strain[0] += s.strain(i - 1), strain[1] += s.strain(i + 1);
      angle[0] += std::acos(dot(s.along(i - 1), s.along(i))) / measured;
      angle[1] += std::acos(dot(s.along(i), s.along(i + 1))) / measured;
    }
    const double expected =
        (std::cos(angle[0]) + mu * std::sin(angle[0])) / (std::cos(angle[1]) - mu * std::sin(angle[1]));
    EXPECT_NEAR(strain[1] / strain[0], expected, 1e-3) << "mu " << mu;
    std::printf("mu = %.1f: T2/T1 = %.5f, wanted %.5f, D = %.4f\n", mu, strain[1] / strain[0], expected,
                angle[0] + angle[1]);
  }
}

}  // namespace
}  // namespace drape::contact
