// The energy of rows in lanes against that of each link and hinge.
#include "dynamics/potential_energy.h"

#include <gtest/gtest.h>

#include "cloth_fixture.h"
#include "cut_pieces.h"
#include "forces/hinge_energy.h"
#include "forces/irregular_elements.h"
#include "model/elements.h"

namespace drape::dynamics {

using namespace tests;
namespace {

Vec3 edge(const State& s, std::size_t from, std::size_t to) {
  return {s.x[to] - s.x[from], s.y[to] - s.y[from], s.z[to] - s.z[from]};
}

// Link by link and hinge by hinge.
drape_energy energy_by_elements(const System& system, const State& s) {
  drape_energy e{};
  const model::Lattice& l = system.lattices[0];
  model::links_visit(system, l, [&](const model::Link& link) {
    (link.along == model::YarnDirection::kBias ? e.shear : e.stretch) +=
        link.width * link.rest *
        math::curve_energy(model::law_curve(l.law, link.along), model::link_strain(s, link));
  });
  model::hinges_visit(system, l,
                      [&](std::size_t n0, std::size_t n1, std::size_t n2, bool warp, double share) {
                        e.bending += model::law_bending(l.law, warp) * share *
                                     forces::hinge_energy_between(edge(s, n0, n1), edge(s, n1, n2));
                      });
  return e;
}

// Crumpled by up to 8 mm on cells of 10 mm, some hinges fold by more than 120 degrees.
TEST(PotentialEnergy, OfARowIsTheSumOverItsElements) {
  for (const Shape shape : {Shape::kRectangle, Shape::kTriangle, Shape::kDiscWithHole, Shape::kSlits})
    for (const double amplitude : {1e-5, 2e-3, 8e-3}) {
      Assembled a = assemble(cut_piece(reference::curved_fabric(), shape));
      crumple(a, amplitude, 3);
      const drape_energy expected = energy_by_elements(a.system, a.state);
      for (const char* name : {"portable", "scalar", "avx2", "avx512"}) {
        const Kernel* kernel = kernel_named(name);
        if (!kernel) continue;
        SCOPED_TRACE(std::string(shape_name(shape)) + " " + name);
        const drape_energy e = potential_energy(a.system, *kernel, a.state);
        // strains of 1e-3 round to 1e-16
        EXPECT_NEAR(e.stretch, expected.stretch, 1e-12 * expected.stretch);
        EXPECT_NEAR(e.shear, expected.shear, 1e-12 * expected.shear);
        EXPECT_NEAR(e.bending, expected.bending, 1e-12 * expected.bending);
      }
    }
}

TEST(PotentialEnergy, HasTheSameBitsInAllVectorLanes) {
  if (!kernel_named("scalar")) GTEST_SKIP() << "this processor has no AVX2 with FMA";
  Assembled a = assemble(cut_piece(reference::curved_fabric(), Shape::kDiscWithHole));
  crumple(a, 2e-3, 5);
  const drape_energy expected = potential_energy(a.system, *kernel_named("scalar"), a.state);
  for (const char* name : {"avx2", "avx512"}) {
    const Kernel* kernel = kernel_named(name);
    if (!kernel) continue;
    const drape_energy e = potential_energy(a.system, *kernel, a.state);
    EXPECT_EQ(energy_sum(e), energy_sum(expected)) << name;
  }
}

}  // namespace
}  // namespace drape::dynamics
