// The forces of contact stops on moving bodies. core/README.md, section 9.
#include <gtest/gtest.h>

#include "body_fixture.h"
#include "contact/particle/contact.h"

namespace drape::dynamics {

using namespace tests;
namespace {

// A square cell of cloth, `height` contact distances above a roof's edge, or lying on a plate.
Assembled held_up(const SceneFolder& folder, bool over_edge, double height) {
  scene::FabricSpec fabric = linen(0.01);
  fabric.friction = {0.3, 0.3};
  Scene scene = reference::rectangle(fabric, 0.01, 0.01, 0.01);
  scene.pieces[0].place.origin = {-0.004, 0, 0.1};
  const Mesh mesh = over_edge ? roof(1.3) : box(1, 1, 0.1);
  scene::BodySpec& body = body_add(scene, folder, over_edge ? "roof" : "plate", mesh);
  body.moves = true;
  if (!over_edge) body.position = {0, 0, -0.05};
  Assembled a = assemble(scene);
  for (std::size_t n : a.system.particle) a.state.z[n] = height * a.system.lattices[0].contact_law.distance;
  contact::begin(a.system, a.motion.kernel->contact, a.motion.contact, a.state);
  return a;
}

// The sum of the stop forces against particles whose free acceleration is `a` along z.
double held(const Assembled& of, double a) {
  std::vector<contact::EdgeContactPair> pairs;
  contact::edge_narrow_phase(of.system, of.state, pairs);
  Array x(of.system.nodes, 0.0), y = x, z(of.system.nodes, a);
  const model::Field field{x.data(), y.data(), z.data()};
  contact::EdgeScratch scratch = contact::edge_scratch_make();
  const contact::ContactStops stops = contact::stop_forces(of.system, scratch, of.state, pairs, field);
  double sum = 0;
  for (double s : stops.particle) sum += s;
  for (double s : stops.pair) sum += s;
  return sum;
}

// The stop forces are the same at rest and at any velocity. On a body that accelerates upwards they are
// those of a larger gravity.
TEST(ContactStops, HoldInTheFrameOfTheBody) {
  const SceneFolder folder;
  for (const bool over_edge : {false, true}) {
    Assembled a = held_up(folder, over_edge, over_edge ? 0.06 : 0.0999);
    const double at_rest = held(a, -1e6), heavier = held(a, -1e6 - 2e5);
    EXPECT_GT(at_rest, 0) << over_edge;
    EXPECT_GT(heavier, 1.01 * at_rest);
    math::RigidMotion& frame = a.state.body[0].motion;
    frame.velocity = {0, 0, 3e5};
    EXPECT_NEAR(held(a, -1e6), at_rest, 1e-12 * at_rest) << over_edge;
    frame.acceleration = {0, 0, 2e5};
    EXPECT_NEAR(held(a, -1e6), heavier, 1e-12 * heavier) << over_edge;
  }
}

}  // namespace
}  // namespace drape::dynamics
