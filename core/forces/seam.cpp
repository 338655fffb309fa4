#include "forces/seam.h"

#include <cmath>

#include "forces/bending.h"
#include "forces/hinge_energy.h"
#include "forces/node_lane.h"
#include "seam/row.h"

namespace drape {
namespace {

using namespace vector3;

bool is_welded(const State& s, std::size_t pair) { return s.sewn[pair] == Sewn::kWelded; }

// The law along the seam: that of the shorter side's threads nearest to it.
const Curve& link_curve(const System& system, const Seam& seam) {
  const Law& law = system.lattices[std::size_t(seam.piece[seam.shorter])].law;
  return seam.along_warp ? law.warp : law.weft;
}

// Visits hinges of welded pairs with their arms and stiffness.
template <class Visit>
void each_hinge_sewn(const System& system, const State& s, Visit visit) {
  for (const Seam& seam : system.seams.seam)
    for (std::size_t p = seam.first; p < seam.first + seam.count; ++p) {
      if (!is_welded(s, p)) continue;
      const SeamHinge& hinge = system.seams.hinge[p];
      const double kappa = seam_hinge_stiffness(system, seam, hinge);
      if (kappa > 0) visit(hinge, kappa, row_value(hinge.arm[0], s), row_value(hinge.arm[1], s));
    }
}

template <class Visit>
void each_link_sewn(const System& system, const State& s, Visit visit) {
  for (const Seam& seam : system.seams.seam)
    for (std::size_t k = seam.link_first; k < seam.link_first + seam.link_count; ++k) {
      const SeamLink& link = system.seams.link[k];
      if (is_welded(s, link.pair[0]) && is_welded(s, link.pair[1]))
        visit(seam, link, row_value(link.edge, s));
    }
}

NodeVec lanes(const Vec3& v) { return {v[0], v[1], v[2]}; }
Vec3 plain(const NodeVec& v) { return {v.x.v, v.y.v, v.z.v}; }

}  // namespace

double seam_hinge_stiffness(const System& system, const Seam& seam, const SeamHinge& hinge) {
  double compliance = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    const Law& law = system.lattices[std::size_t(seam.piece[k])].law;
    const double rigidity = hinge.threads[k][0] * law.bending_warp + hinge.threads[k][1] * law.bending_weft;
    if (!(rigidity > 0)) return 0;
    compliance += hinge.reach[k] / rigidity;
  }
  return 2 * hinge.width / compliance;
}

double seam_link_tension(const System& system, const Seam& seam, double strain) {
  return seam.link_width * curve_value(link_curve(system, seam), strain) + seam.tape * strain;
}

double seam_link_slope(const System& system, const Seam& seam) {
  return seam.link_width * curve_slope(link_curve(system, seam), 0) + seam.tape;
}

void seams_bond(const System& system, const State& s, SideForces to) {
  each_hinge_sewn(system, s, [&](const SeamHinge& hinge, double kappa, const Vec3& a, const Vec3& c) {
    const double inverse_a = 1 / norm(a), inverse_c = 1 / norm(c);
    const auto f = bending_hinge(lanes(inverse_a * a), NodeLane(inverse_a), lanes(inverse_c * c),
                                 NodeLane(inverse_c), NodeLane(kappa));
    row_force(hinge.arm[0], -1.0 * plain(f.first), to);  // on x0 it is +f.first, and a = x1 - x0
    row_force(hinge.arm[1], plain(f.last), to);
  });
  each_link_sewn(system, s, [&](const Seam& seam, const SeamLink& link, const Vec3& edge) {
    const double length = norm(edge);
    if (length == 0) return;
    const double tension = seam_link_tension(system, seam, length / seam.rest - 1);
    row_force(link.edge, (-tension / length) * edge, to);
  });
}

SeamEnergy seams_energy(const System& system, const State& s) {
  SeamEnergy e;
  each_hinge_sewn(system, s, [&](const SeamHinge&, double kappa, const Vec3& a, const Vec3& c) {
    e.bending += kappa * hinge_energy_between(a, c);
  });
  each_link_sewn(system, s, [&](const Seam& seam, const SeamLink&, const Vec3& edge) {
    const double strain = norm(edge) / seam.rest - 1;
    e.stretch += seam.rest * (seam.link_width * curve_energy(link_curve(system, seam), strain) +
                              seam.tape * strain * strain / 2);
  });
  return e;
}

}  // namespace drape
