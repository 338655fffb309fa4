#include "dynamics/potential_energy.h"

#include "contact/self/self_contact.h"
#include "dynamics/kernel/kernel.h"
#include "forces/hinge_energy.h"
#include "forces/irregular_elements.h"
#include "forces/seam_bending.h"
#include "model/elements.h"
#include "model/kinetic_energy.h"

namespace drape::dynamics {
namespace {

Vec3 edge_of(const State& s, std::size_t from, std::size_t to) {
  return {s.x[to] - s.x[from], s.y[to] - s.y[from], s.z[to] - s.z[from]};
}

void irregular_add(const System& system, const model::Lattice& l, const State& s, drape_energy& e) {
  model::irregular_links_visit(system, l, [&](const model::Link& link) {
    double& kind = link.along == model::YarnDirection::kBias ? e.shear : e.stretch;
    kind += link.width * link.rest *
            math::curve_energy(model::law_curve(l.law, link.along), model::link_strain(s, link));
  });
  model::irregular_hinges_visit(
      system, l, [&](std::size_t n0, std::size_t n1, std::size_t n2, bool warp, double share) {
        e.bending += model::law_bending(l.law, warp) * share *
                     forces::hinge_energy_between(edge_of(s, n0, n1), edge_of(s, n1, n2));
      });
  for (const model::ClampHinge& c : system.irregular.clamps)
    if (c.lattice == l.piece)
      e.bending +=
          model::law_bending(l.law, c.warp) * c.share *
          forces::hinge_energy_between(forces::clamp_direction(c, s), edge_of(s, c.node[0], c.node[1]));
}

}  // namespace

drape_energy potential_energy(const System& system, const Kernel& kernel, const State& s) {
  drape_energy e{};
  for (const model::Lattice& l : system.lattices) {
    for (int j = 0; j < l.rows; ++j) {
      const RowEnergy row = kernel.energy(system, l, s, j);
      e.stretch += row.stretch;
      e.shear += row.shear;
      e.bending += row.bending;
    }
    irregular_add(system, l, s, e);
  }
  const forces::SeamEnergy sewn = forces::seams_energy(system, s);
  e.bending += sewn.bending;
  e.stretch += sewn.stretch;
  e.contact = contact::contact_energy(system, s) + contact::self_energy(system, s);
  e.gravity = gravity_energy(system, s);
  return e;
}

double gravity_energy(const System& system, const State& s) {
  const Vec3& g = system.gravity;
  double sum = 0;
  for (std::size_t n : system.particle)
    sum -= system.mass[n] * (g[0] * s.x[n] + g[1] * s.y[n] + g[2] * s.z[n]);
  return sum;
}

drape_energy potential_energy(const System& system, const State& s) {
  return potential_energy(system, kernel_pick(), s);
}

double energy_sum(const drape_energy& e) {
  return e.kinetic + e.stretch + e.shear + e.bending + e.gravity + e.contact;
}

void energy_begin(const System& system, State& s) {
  const drape_energy e = potential_energy(system, s);
  s.energy_start = model::kinetic_energy(system, s) + energy_sum(e);
  s.dissipated = s.input = s.drive_work = 0;
}

}  // namespace drape::dynamics
