#include "outputs/energy.h"

#include <cmath>

#include "contact/self/self_contact.h"
#include "forces/hinge_energy.h"
#include "forces/irregular_elements.h"
#include "forces/seam_bending.h"
#include "model/elements.h"
#include "model/kinetic_energy.h"

namespace drape::outputs {
namespace {

Vec3 edge_of(const State& s, std::size_t from, std::size_t to) {
  return {s.x[to] - s.x[from], s.y[to] - s.y[from], s.z[to] - s.z[from]};
}

double bending_of(const System& system, const model::Lattice& l, const State& s) {
  double sum = 0;
  model::hinges_visit(
      system, l, [&](std::size_t n0, std::size_t n1, std::size_t n2, bool warp, double share) {
        const double rigidity = model::law_bending(l.law, warp);
        if (rigidity > 0)
          sum += rigidity * share * forces::hinge_energy_between(edge_of(s, n0, n1), edge_of(s, n1, n2));
      });
  for (const model::ClampHinge& c : system.irregular.clamps)
    if (c.lattice == l.piece)
      sum += model::law_bending(l.law, c.warp) * c.share *
             forces::hinge_energy_between(forces::clamp_direction(c, s), edge_of(s, c.node[0], c.node[1]));
  return sum;
}

}  // namespace

drape_energy energy_potential(const System& system, const State& s) {
  drape_energy e{};
  for (const model::Lattice& l : system.lattices) {
    model::links_visit(system, l, [&](const model::Link& link) {
      double& kind = link.along == model::YarnDirection::kBias ? e.shear : e.stretch;
      kind += link.width * link.rest *
              math::curve_energy(model::law_curve(l.law, link.along), model::link_strain(s, link));
    });
    e.bending += bending_of(system, l, s);
  }
  const forces::SeamEnergy sewn = forces::seams_energy(system, s);
  e.bending += sewn.bending;
  e.stretch += sewn.stretch;
  e.contact = contact::contact_energy(system, s) + contact::self_energy(system, s);
  const Vec3& g = system.gravity;
  for (std::size_t n : system.particle)
    e.gravity -= system.mass[n] * (g[0] * s.x[n] + g[1] * s.y[n] + g[2] * s.z[n]);
  return e;
}

double energy_sum(const drape_energy& e) {
  return e.kinetic + e.stretch + e.shear + e.bending + e.gravity + e.contact;
}

void energy_begin(const System& system, State& s) {
  const drape_energy e = energy_potential(system, s);
  s.energy_start = model::kinetic_energy(system, s) + energy_sum(e);
  s.dissipated = s.input = 0;
}

}  // namespace drape::outputs
