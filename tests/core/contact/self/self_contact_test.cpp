// Cloth against cloth in motion: cases with known answers, momentum, and what must never happen.
#include <gtest/gtest.h>

#include "contact/self/search.h"
#include "contact/self/self_contact.h"
#include "contact/self/self_fixture.h"
#include "dynamics/potential_energy.h"
#include "dynamics/seam_welding.h"
#include "math/smooth_ramp.h"
#include "math/vector3.h"
#include "outputs/outputs.h"

namespace drape::contact {

using namespace tests;
namespace {

using namespace math::vector3;

// A held sheet, and at the height z a smaller one above it whose nodes lie over no nodes.
Scene on_a_sheet(double z, double mu = 0.3) {
  Scene scene = reference::rectangle(linen(), 0.2, 0.1, 0.01);
  scene.self_contact = true;
  scene.fabrics[0].friction = {mu, mu};
  scene.pins = {hold_all(0.2, 0.1)};
  sheet_add(scene, "upper", 0.05, 0.05, 0.01, {0.0237, 0.0221, z});
  return scene;
}

// Nodes of a piece.
std::vector<std::size_t> nodes_of(const System& system, int piece) {
  const model::Lattice& l = system.lattices[std::size_t(piece)];
  std::vector<std::size_t> nodes;
  for (std::size_t n : system.particle)
    if (l.owns(n)) nodes.push_back(n);
  return nodes;
}

double mass_of(const System& system, int piece) {
  double sum = 0;
  for (std::size_t n : nodes_of(system, piece)) sum += system.mass[n];
  return sum;
}

// At rest the middle surfaces are the thickness apart, less the depth that supports the weight. A particle
// that bore its own weight alone, k = W^2 m/8, would be pressed in by e with W^2 phi(e) = 8 g; the particles
// of the lower sheet share the load. The pin bears both sheets.
TEST(SelfContact, RestsAtTheThickness) {
  Scene scene = on_a_sheet(1.2e-3);
  scene.damping = 30;
  Assembled a = assemble(scene);
  advance(a, 1);
  const model::ContactLaw& law = a.system.lattices[1].contact_law;
  const double contact_distance = scene.fabrics[0].thickness;
  double deepest = 0;
  while (law.omega2 * math::smooth_ramp(kSelfBlend * contact_distance, deepest) < 8 * 9.81) deepest += 1e-8;
  double mean = 0;
  for (std::size_t n : nodes_of(a.system, 1)) mean += a.state.z[n] / double(nodes_of(a.system, 1).size());
  EXPECT_LT(mean, contact_distance);
  EXPECT_GT(mean, contact_distance - deepest);
  advance(a, 0.05);
  outputs::Outputs outputs;
  outputs::outputs_make(outputs, a.scene, a.system);
  outputs::outputs_fill(outputs, a.system, a.motion, a.state, DRAPE_OUT_VELOCITY | DRAPE_OUT_STRAIN);
  const double weight = 9.81 * (mass_of(a.system, 0) + mass_of(a.system, 1));
  EXPECT_NEAR(outputs.pins[0].force[2], -weight, 1e-6 * weight);
  EXPECT_GE(outputs.c_view.contact_count, 36);
  EXPECT_LT(outputs.c_view.contact_penetration, 2 * deepest);
}

struct Momenta {
  Vec3 linear{0, 0, 0}, angular{0, 0, 0};
  double scale = 0, scale_angular = 0;
};
Momenta momenta(const Assembled& a) {
  Momenta m;
  for (std::size_t n : a.system.particle) {
    const Vec3 p = a.system.mass[n] * Vec3{a.state.vx[n], a.state.vy[n], a.state.vz[n]},
               r = at_node(a.state, n);
    m.linear += p;
    m.angular += cross(r, p);
    m.scale += norm(p);
    m.scale_angular += norm(r) * norm(p);
  }
  return m;
}

// Two free sheets collide obliquely, with friction. Both momenta are constant in every step.
TEST(SelfContact, KeepsMomentumAndAngularMomentum) {
  Scene scene = reference::rectangle(linen(), 0.1, 0.1, 0.01);
  scene.self_contact = true;
  scene.gravity = {0, 0, 0};
  scene.fabrics[0].friction = {0.5, 0.4};
  scene::PieceSpec& upper = sheet_add(scene, "upper", 0.08, 0.08, 0.008, {0.04, 0.031, 0.012});
  upper.place.axis_x = {std::cos(0.1), 0, std::sin(0.1)};
  upper.velocity = {-0.3, 0.2, -1};
  Assembled a = assemble(scene);
  std::size_t largest = 0;
  for (int k = 0; k < 60; ++k) {
    const Momenta before = momenta(a);
    advance(a, 1e-3);
    const Momenta after = momenta(a);
    EXPECT_LT(norm(after.linear - before.linear), 1e-12 * after.scale);
    EXPECT_LT(norm(after.angular - before.angular), 1e-12 * after.scale_angular);
    largest = std::max(largest, self_summary(a.system, a.state).count);
  }
  EXPECT_GT(largest, 20u);
  EXPECT_EQ(crossings(a), 0);
}

// A sheet on a held one, with gravity inclined by the angle once it has come to rest.
Assembled leaning(double mu, double angle) {
  Scene scene = on_a_sheet(1e-3, mu);
  Assembled a = assemble(scene);
  a.system.damping = 200;
  advance(a, 0.2);
  dynamics::leapfrog_complete(a.system, a.motion, a.state);
  a.system.damping = 0;
  for (std::size_t n : a.system.particle) a.state.vx[n] = a.state.vy[n] = a.state.vz[n] = 0;
  a.system.gravity = {9.81 * std::sin(angle), 0, -9.81 * std::cos(angle)};
  return a;
}

double mean_x(const Assembled& a) {
  double sum = 0, mass = 0;
  for (std::size_t n : nodes_of(a.system, 1))
    sum += a.system.mass[n] * a.state.x[n], mass += a.system.mass[n];
  return sum / mass;
}

// F = mu N: it sticks iff tan a <= mu, and does not creep ...
TEST(SelfContact, SticksUpToTheCoefficient) {
  const double mu = 0.4;
  Assembled below = leaning(mu, std::atan(0.999 * mu)), above = leaning(mu, std::atan(1.001 * mu));
  const double x = mean_x(below);
  advance(below, 0.2);
  const double at_rest = mean_x(below);
  advance(below, 0.8);
  EXPECT_LT(std::abs(at_rest - x), 1e-5);  // the sudden inclination of gravity shakes it
  EXPECT_LT(std::abs(mean_x(below) - at_rest), 1e-8);
  advance(above, 0.2);
  const double angle = std::atan(1.001 * mu), way = 9.81 * (std::sin(angle) - mu * std::cos(angle)) * 0.02;
  EXPECT_GT(mean_x(above) - x, 0.5 * way);
}

// ... and slides by g (sin a - mu cos a) t^2/2.
TEST(SelfContact, SlidesAgainstTheCoefficient) {
  const double mu = 0.4, angle = 0.6, t = 0.2;
  Assembled a = leaning(mu, angle);
  const double x = mean_x(a), way = 9.81 * (std::sin(angle) - mu * std::cos(angle)) * t * t / 2;
  advance(a, t);
  EXPECT_NEAR(mean_x(a) - x, way, 1e-3 * way);
}

// A loop that collapses under its weight onto a held sheet. Its sides stay apart.
Scene loop() {
  Scene scene = reference::rectangle(linen(0.5e-3), 0.14, 0.06, 0.02);
  scene.self_contact = true;
  scene.damping = 5;
  scene.fabrics[0].bending_warp = scene.fabrics[0].bending_weft = 5e-7;
  scene.pins = {hold_all(0.14, 0.06)};
  scene::PlaceSpec& place = sheet_add(scene, "loop", 0.12, 0.03, 0.005, {0.009, 0.0131, 0.7e-3}).place;
  place.axis_point = {0.069, 0.0131, 0.0217};
  place.axis = {0, 1, 0};
  place.radius = {0.021, 0.021};
  return scene;
}

double min_distance(const Assembled& a) {
  double smallest = INFINITY;
  const model::SelfPairs pairs = self_search(a.system, a.system.self, a.state, 1e-3);
  for (const model::SelfPoint& p : pairs.point) {
    const auto at = [&](int k) { return at_node(a.state, p.node[k]); };
    const Vec3 e = at(2) - at(1), f = at(3) - at(1), q = at(0) - at(1), n = cross(e, f);
    const double inside = dot(cross(q, f), n), beside = dot(cross(e, q), n), all = dot(n, n);
    if (inside >= 0 && beside >= 0 && inside + beside <= all)
      smallest = std::min(smallest, std::abs(dot(q, n)) / std::sqrt(all));
  }
  return smallest;
}

TEST(SelfContact, AFoldStaysApart) {
  Assembled a = assemble(loop());
  double smallest = INFINITY;
  std::size_t largest = 0;
  for (int k = 0; k < 40; ++k) {
    advance(a, 0.01);
    smallest = std::min(smallest, min_distance(a));
    largest = std::max(largest, self_summary(a.system, a.state).count);
    ASSERT_EQ(crossings(a), 0) << k;
  }
  EXPECT_GT(largest, 10u);
  EXPECT_GT(smallest, 0.1 * 0.5e-3);
}

// The same bits for every kernel and grouping of advances.
TEST(SelfContact, BitsAreThoseOfEveryKernelAndGrouping) {
  const Scene scene = loop();
  const auto run = [&](const char* kernel, int advances) {
    Assembled a = assemble(scene);
    a.motion.kernel = dynamics::kernel_named(kernel);
    if (!a.motion.kernel) return Eigen::VectorXd();
    for (int k = 0; k < advances; ++k) advance(a, 0.12 / advances);
    if (advances == 1) {
      EXPECT_GT(self_summary(a.system, a.state).count, 0u);
    }
    return positions(a);
  };
  const Eigen::VectorXd whole = run("scalar", 1);
  if (whole.size() == 0) GTEST_SKIP() << "no kernel with fused arithmetic";
  for (const char* kernel : {"avx2", "avx512"}) {
    const Eigen::VectorXd other = run(kernel, 6);
    if (other.size() == 0) continue;  // not on this processor
    EXPECT_EQ((other - whole).cwiseAbs().maxCoeff(), 0.0) << kernel;
  }
}

// A restored state continues with the same bits.
TEST(SelfContact, StateGoesOnAsItWas) {
  Assembled a = assemble(loop());
  advance(a, 0.1);
  expect_goes_on(a, 0.03);
}

// A small sheet that falls onto a held one, slides and crumples.
Scene crumpled_drop() {
  Scene scene = reference::rectangle(linen(0.8e-3), 0.3, 0.3, 0.02);
  scene.self_contact = true;
  scene.damping = 2;
  scene.fabrics[0].bending_warp = scene.fabrics[0].bending_weft = 2e-7;
  scene.pins = {hold_all(0.3, 0.3)};
  scene::PieceSpec& upper = sheet_add(scene, "upper", 0.12, 0.12, 0.01, {0.09, 0.14, 0.002});
  upper.place.axis_x = {std::cos(0.3), std::sin(0.3), 0};
  upper.place.axis_y = {-0.1 * std::sin(0.3), 0.1 * std::cos(0.3), std::sqrt(0.99)};
  upper.velocity = {0, 0, -2};
  scene.imperfection_amplitude = 1e-3;
  return scene;
}

// The contacts depend neither on the time of the search nor on when pairs and edges are looked at again.
TEST(SelfContact, SearchChangesNothing) {
  for (const Scene& scene : {loop(), crumpled_drop()}) {
    Assembled a = assemble(scene), b = assemble(scene);
    for (int k = 0; k < 250; ++k) {
      advance(a, 1e-3);
      b.state.self.margin = 0;  // forces a new search
      advance(b, 1e-3);
    }
    EXPECT_GT(self_summary(a.system, a.state).count, 0u);
    EXPECT_EQ((positions(a) - positions(b)).cwiseAbs().maxCoeff(), 0.0);
  }
}

// The balance counts friction, damping and the penalty: it closes.
TEST(SelfContact, EnergyIsBalanced) {
  Scene scene = on_a_sheet(1e-3);
  scene.energy = true;
  scene.pieces[1].velocity = {1, 0, 0};
  Assembled a = assemble(scene);
  const drape_energy e = energies_after(a, 0.1);
  const double kinetic = 0.5 * 0.2 * 0.0025;  // of 1 m/s
  EXPECT_GT(e.dissipated, 0.4 * kinetic);
  EXPECT_LT(std::abs(e.balance_error), 2e-3 * kinetic);
}

// A fit comes to rest where the motion does.
TEST(SelfContact, AFitRestsOnTheSheetBelow) {
  Scene scene = on_a_sheet(1.2e-3);
  scene.mode = scene::Mode::kFit;
  Assembled a = assemble(scene);
  for (int k = 0; k < 2000 && !a.state.relaxation.at_rest; ++k) advance(a, 1e-3);
  EXPECT_TRUE(a.state.relaxation.at_rest) << a.state.relaxation.residual;
  const double contact_distance = scene.fabrics[0].thickness;
  for (std::size_t n : nodes_of(a.system, 1)) {
    EXPECT_LT(a.state.z[n], contact_distance);
    EXPECT_GT(a.state.z[n], 0.9 * contact_distance);
  }
}

// Layers that start nearer than their thickness part within 0.1 s. Two free sheets push each other: their
// momentum stays 0. Of what the growing distance brings in, a quarter is missing from the balance.
TEST(SelfContact, LayersThatStartTooNearPart) {
  for (const double gap : {1e-4, 5e-4}) {
    Scene scene = on_a_sheet(gap);
    scene.gravity = {0, 0, 0};
    scene.damping = 20;
    scene.energy = true;
    scene.pins.clear();
    Assembled a = assemble(scene);
    const drape_energy e = energies_after(a, 0.3);
    double momentum = 0;
    for (std::size_t n : a.system.particle) momentum += a.system.mass[n] * a.state.vz[n];
    EXPECT_NEAR(momentum, 0, 1e-12);
    const model::ContactSummary summary = self_summary(a.system, a.state);
    EXPECT_LT(summary.penetration, 0.05 * scene.fabrics[0].thickness) << gap;
    EXPECT_GT(e.input, 0);
    EXPECT_LT(std::abs(e.balance_error), 0.3 * e.input);
  }
}

// Cloth in the very place of other cloth has no side to part to. Pieces side by side in one plane may touch.
TEST(SelfContact, LayersInOnePlaceAreRefused) {
  for (const bool beside : {false, true}) {
    Scene scene = on_a_sheet(0);
    if (beside) scene.pieces[1].place.origin = {0.2, 0, 0};
    const Assembled a = assemble(scene);
    std::vector<Problem> problems;
    self_check_start(a.system, a.scene, a.state, problems);
    if (beside) {
      EXPECT_TRUE(problems.empty()) << scene::problem_text(problems[0]);
      continue;
    }
    ASSERT_FALSE(problems.empty());
    EXPECT_NE(scene::problem_text(problems[0]).find("its particles lie in cells of it"), std::string::npos)
        << scene::problem_text(problems[0]);
  }
}

// Without self-contact, nothing of it is allocated or computed.
TEST(SelfContact, OffCostsNothing) {
  Scene scene = on_a_sheet(1e-3);
  scene.self_contact = false;
  Assembled a = assemble(scene);
  advance(a, 0.01);
  EXPECT_TRUE(a.system.self.cell.empty() && a.system.self.lattice_of.empty());
  EXPECT_FALSE(a.state.self.pairs);
  EXPECT_TRUE(a.motion.self.groups.index.empty());
}

// A rolled sheet is sewn into a tube: its edges come together although they are cloth, and the seam closes.
TEST(SelfContact, SeamsCloseThroughIt) {
  Scene scene = loop();
  scene.gravity = {0, 0, 0};
  scene::SeamSpec seam;
  seam.name = "side";
  seam.side[0] = {1, {3}, false};
  seam.side[1] = {1, {1}, true};
  scene.seams = {seam};
  Assembled a = assemble(scene);
  for (int k = 0; k < 300; ++k) {
    if (dynamics::seams_pull_begin(a.system, a.state))
      dynamics::leapfrog_retuned(a.system, a.motion, a.state);
    if (const auto within = dynamics::seams_within_tolerance(a.system, a.state); !within.empty()) {
      dynamics::seams_weld(a.system, a.motion, a.state, within);
      dynamics::leapfrog_retuned(a.system, a.motion, a.state);
    }
    advance(a, 1e-3);
  }
  for (model::Sewn s : a.state.sewn) EXPECT_EQ(s, model::Sewn::kWelded);
}

// A hanging sheet dropped on a held one crumples there: no edge of it passes through cloth. In some of these
// seeds a particle comes upon an edge two cells away along the cloth, about a fold between them; others need
// many sweeps.
TEST(SelfContact, ACrumpledDropDoesNotTunnel) {
  Scene scene = crumpled_drop();
  std::size_t largest = 0;
  for (const int seed : {1, 5, 8, 9, 11, 12}) {
    scene.imperfection_seed = seed;
    Assembled a = assemble(scene);
    int now = 0;
    for (int k = 0; k < 100 && now == 0; ++k) {
      advance(a, 5e-3);
      now = crossings(a);
      largest = std::max(largest, self_summary(a.system, a.state).count);
    }
    EXPECT_EQ(now, 0) << "seed " << seed;
  }
  EXPECT_GT(largest, 100u);
}

}  // namespace
}  // namespace drape::contact
