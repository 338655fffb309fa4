#include "forces/seam_bending.h"

#include <cmath>

#include "forces/hinge_energy.h"
#include "model/node_sums.h"

namespace drape::forces {
namespace {

using namespace math::vector3;

bool is_welded(const State& s, std::size_t pair) { return s.sewn[pair] == model::Sewn::kWelded; }

// The law along the seam: that of the shorter side, along its warp or weft, whichever is nearer to the seam.
const math::Curve& link_curve(const System& system, const model::Seam& seam) {
  const fabric::Law& law = system.lattices[std::size_t(seam.piece[seam.shorter])].law;
  return seam.along_warp ? law.warp : law.weft;
}

template <class Visit>
void sewn_hinges_visit(const System& system, const State& s, Visit visit) {
  for (std::size_t p = 0; p < system.seams.hinge.size(); ++p)
    if (is_welded(s, p) && system.seams.hinge[p].stiffness > 0) visit(system.seams.hinge[p]);
}

template <class Visit>
void sewn_links_visit(const System& system, const State& s, Visit visit) {
  for (const model::Seam& seam : system.seams.seam)
    for (std::size_t k = seam.link_first; k < seam.link_first + seam.link_count; ++k) {
      const model::SeamLink& link = system.seams.link[k];
      if (is_welded(s, link.pair[0]) && is_welded(s, link.pair[1]))
        visit(seam, link, model::sum_value(link.edge, s));
    }
}

void batch_set(HingeBatch& b, std::size_t i, const Vec3& a, const Vec3& c, double stiffness) {
  for (std::size_t k = 0; k < 3; ++k) b.a[k][i] = a[k], b.c[k][i] = c[k];
  b.stiffness[i] = stiffness;
}

// Computes the batch and adds its forces. The force on x is minus the sum of the others, as a = x - p_a.
void batch_bend(HingeBatch& b, const model::SeamHinge* const* of, std::size_t count, HingeKernel hinges,
                model::SlotForces to) {
  for (std::size_t i = count; i < std::size_t(math::kRowUnit); ++i) batch_set(b, i, {1, 0, 0}, {1, 0, 0}, 0);
  hinges(b);
  for (std::size_t i = 0; i < count; ++i) {
    model::sum_force(of[i]->arm[0], {-b.a[0][i], -b.a[1][i], -b.a[2][i]}, to);
    model::sum_force(of[i]->arm[1], {b.c[0][i], b.c[1][i], b.c[2][i]}, to);
  }
}

}  // namespace

double seam_hinge_stiffness(const System& system, const model::Seam& seam, const model::SeamHinge& hinge) {
  double compliance = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    const fabric::Law& law = system.lattices[std::size_t(seam.piece[k])].law;
    const double rigidity =
        hinge.yarn_shares[k][0] * law.bending_warp + hinge.yarn_shares[k][1] * law.bending_weft;
    if (!(rigidity > 0)) return 0;
    compliance += hinge.reach[k] / rigidity;
  }
  return 2 * hinge.width / compliance;
}

double seam_link_tension(const System& system, const model::Seam& seam, double strain) {
  return seam.link_width * math::curve_value(link_curve(system, seam), strain) + seam.tape * strain;
}

double seam_link_slope(const System& system, const model::Seam& seam) {
  return seam.link_width * math::curve_slope(link_curve(system, seam), 0) + seam.tape;
}

void seams_bending_forces(const System& system, const State& s, HingeKernel hinges, model::SlotForces to) {
  HingeBatch batch;
  const model::SeamHinge* of[math::kRowUnit];
  std::size_t count = 0;
  sewn_hinges_visit(system, s, [&](const model::SeamHinge& hinge) {
    batch_set(batch, count, model::sum_value(hinge.arm[0], s), model::sum_value(hinge.arm[1], s),
              hinge.stiffness);
    of[count++] = &hinge;
    if (count < std::size_t(math::kRowUnit)) return;
    batch_bend(batch, of, count, hinges, to);
    count = 0;
  });
  if (count > 0) batch_bend(batch, of, count, hinges, to);
  sewn_links_visit(system, s, [&](const model::Seam& seam, const model::SeamLink& link, const Vec3& edge) {
    const double length = norm(edge);
    if (length == 0) return;
    const double tension = seam_link_tension(system, seam, length / seam.rest - 1);
    model::sum_force(link.edge, (-tension / length) * edge, to);
  });
}

SeamEnergy seams_energy(const System& system, const State& s) {
  SeamEnergy e;
  sewn_hinges_visit(system, s, [&](const model::SeamHinge& h) {
    e.bending +=
        h.stiffness * hinge_energy_between(model::sum_value(h.arm[0], s), model::sum_value(h.arm[1], s));
  });
  sewn_links_visit(system, s, [&](const model::Seam& seam, const model::SeamLink&, const Vec3& edge) {
    const double strain = norm(edge) / seam.rest - 1;
    e.stretch += seam.rest * (seam.link_width * math::curve_energy(link_curve(system, seam), strain) +
                              seam.tape * strain * strain / 2);
  });
  return e;
}

}  // namespace drape::forces
