#include "dynamics/relaxation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/seam_welding.h"
#include "dynamics/step_size/step_limit.h"
#include "model/elements.h"

namespace drape::dynamics {
namespace {

constexpr int kScaleEvery = 16;            // steps, at most
constexpr double kScaleWithin = 0.02;      // of a cell: no particle moves farther until then
constexpr int kConvergenceCheckEvery = 8;  // intervals
constexpr double kResidualRest = 1e-5;     // of the load
constexpr double kKineticRest = 1e-9;      // of that times the size of the largest piece
constexpr int kMeasureEvery = 64;          // steps, at least; the first after a change takes
constexpr int kMeasureFirst = 16;          // and each one twice as many as the one before
constexpr double kShrink = 0.01;           // of itself: an inertia shrinks at most by this in an update
constexpr double kMaxSettling = 1;         // s, for which a sewn garment settles without friction
constexpr double kConverged = 0.1;         // of the load: a residual below it ends settling
constexpr double kFaded = 1e-4;            // of the largest force so far: the load where there is none

// Gives all nodes the smallest scale among them. True where that changes one.
template <class Nodes>
bool nodes_even(const Nodes& nodes, State& s) {
  double smallest = 1;
  bool changed = false;
  for (std::size_t n : nodes) smallest = std::min(smallest, s.inverse_mass_scale[n]);
  for (std::size_t n : nodes) {
    changed = changed || s.inverse_mass_scale[n] != smallest;
    s.inverse_mass_scale[n] = smallest;
  }
  return changed;
}

// Rows on several nodes and links are projected with the true masses. That is right where the nodes of
// connected rows have one scale: the smallest of theirs. Fixed nodes do not move; their scale is 1, for the
// force on the pin.
void rows_even(const constraint::Constraints& constraints, State& s) {
  for (bool changed = true; changed;) {
    changed = false;
    for (const constraint::HeldRow& row : constraints.rows) changed = nodes_even(row.on.node, s) || changed;
    for (const constraint::RigidLink& link : constraints.rigid.link)
      changed = nodes_even(link.node, s) || changed;
  }
  for (const constraint::FixedNode& f : constraints.fixed) s.inverse_mass_scale[f.node] = 1;
}

// Steps until the next update of the inertia: a particle pulled onto a seam can cross a cell in kScaleEvery.
int steps_ahead(const System& system, const State& s, double h) {
  double cell = INFINITY, fastest = 0;
  for (const model::Lattice& l : system.lattices) cell = std::min(cell, l.cell);
  for (std::size_t n : system.particle)
    fastest = std::max(fastest, s.vx[n] * s.vx[n] + s.vy[n] * s.vy[n] + s.vz[n] * s.vz[n]);
  const double steps = kScaleWithin * cell / (h * std::sqrt(fastest));
  return steps < kScaleEvery ? std::max(1, int(steps)) : kScaleEvery;
}

double kinetic(const System& system, const State& s) {
  double sum = 0;
  for (std::size_t n : system.particle)
    sum += model::inertia_of(system, s, n) * (s.vx[n] * s.vx[n] + s.vy[n] * s.vy[n] + s.vz[n] * s.vz[n]);
  return sum / 2;
}

void stop(const System& system, State& s) {
  for (std::size_t n : system.particle) s.vx[n] = s.vy[n] = s.vz[n] = 0;
  if (!s.wx.empty()) s.wx = s.vx, s.wy = s.vy, s.wz = s.vz;
  s.h_old = s.h_older = 0;
}

double norm(const Vec3& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

}  // namespace

void relaxation_scale_masses(const System& system, const constraint::Constraints& constraints, State& s,
                             double h) {
  const int steps = steps_ahead(system, s, h);
  const Array before = std::move(s.inverse_mass_scale);
  s.inverse_mass_scale.assign(system.nodes, 0.0);  // at first m'/rho
  const double drag = step_limit_drag(system, s);
  const SeamsBound seams = step_limit_seams(system, s);
  double largest = 0;
  for (const model::Lattice& l : system.lattices) {
    const double clamps = step_limit_clamps(system, l, s, steps * h);
    const double contact = contact::added_omega2(system, s, l.piece);
    model::cells_visit(system, l, [&](const std::size_t* corner, double share) {
      const double bare = step_limit_cell(l, s, corner, steps * h) + clamps;
      const double omega2 = step_limit_rated(system, l, bare, drag, seams, contact);
      const double ratio = h / (kSafety * step_limit_of(system, omega2));
      const double quarter = share * l.cell * l.cell / 4 * std::max(1.0, ratio * ratio);
      for (int k = 0; k < 4; ++k) s.inverse_mass_scale[corner[k]] += quarter;
      largest = std::max(largest, std::min(omega2, omega2 / (ratio * ratio)));
    });
  }
  for (std::size_t n : system.particle) {
    s.inverse_mass_scale[n] = std::min(1.0, system.area[n] / s.inverse_mass_scale[n]);
    if (!before.empty())
      s.inverse_mass_scale[n] = std::min(s.inverse_mass_scale[n], before[n] / (1 - kShrink));
  }
  rows_even(constraints, s);
  s.omega2 = largest;
  s.steps_to_limit_check = steps;
}

namespace {

// omega (1/s) of the motion since the last measure: sqrt(u.[f(r) - f(r + u)]/(u.M' u)); 0 where nothing moved
// or no stiffness resisted.
double omega_moved(const System& system, Motion& motion, State& s) {
  kernel_forces(*motion.kernel, system, s, motion.workspace, motion_field(motion));
  const Array* r[] = {&s.x, &s.y, &s.z};
  const Array* f[] = {&motion.now_x, &motion.now_y, &motion.now_z};
  double stiff = 0, moved = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    Array &place = s.relaxation.place[k], &force = s.relaxation.force[k];
    if (s.relaxation.measure_every > 0)
      for (std::size_t n : system.particle) {
        const double u = (*r[k])[n] - place[n];
        stiff += u * (force[n] - (*f[k])[n]);
        moved += model::inertia_of(system, s, n) * u * u;
      }
    place = *r[k];
    force = *f[k];
  }
  return moved > 0 ? std::sqrt(std::max(0.0, stiff / moved)) : 0;
}

}  // namespace

void relaxation_update(const System& system, Motion& motion, State& s, double h) {
  s.relaxation.sewing = seams_to_close(system, s);
  relaxation_scale_masses(system, motion.constraints, s, h);
  if (s.relaxation.sewing) s.relaxation.settling = kMaxSettling;
  else s.relaxation.settling -= s.steps_to_limit_check * h;
  const bool kept = s.relaxation.measure_every > 0;
  if (kept && s.steps < s.relaxation.measured + s.relaxation.measure_every) return;
  const double omega = omega_moved(system, motion, s);
  if (kept) s.relaxation.damping = std::min(2 * omega, 1 / h);
  s.relaxation.measured = s.steps;
  s.relaxation.measure_every = kept ? std::min(2 * s.relaxation.measure_every, kMeasureEvery) : kMeasureFirst;
}

// The residual forces on particles and the forces of pins (N), summed by size.
namespace {
struct Left {
  double sum = 0, pins = 0;
};
Left forces_left(const System& system, Motion& motion, const State& s) {
  free_accelerations(system, motion, s);
  std::vector<math::Wrench> load(s.pin_impulse.size());
  held_refresh(motion.constraints, s, motion.held);
  project_synchronous(system, motion, s, {.pass = model::Pass::kAcceleration}, motion_field(motion), &load);
  Left left;
  for (const math::Wrench& l : load) left.pins += norm(l.force);
  for (std::size_t n : system.particle)
    left.sum += system.mass[n] * norm({motion.now_x[n], motion.now_y[n], motion.now_z[n]});
  return left;
}

// The part of the forces on particles that comes from the rounding of coordinates, N, summed by size.
double rounding(const System& system, const State& s) {
  double far = 0, inertia = 0;
  for (std::size_t n : system.particle) {
    far = std::max({far, std::abs(s.x[n]), std::abs(s.y[n]), std::abs(s.z[n])});
    inertia += model::inertia_of(system, s, n);
  }
  return std::numeric_limits<double>::epsilon() * far * s.omega2 * inertia;
}
}  // namespace

void check_convergence(const System& system, Motion& motion, State& s) {
  if (s.relaxation.intervals_to_convergence_check-- > 0) return;
  s.relaxation.intervals_to_convergence_check = kConvergenceCheckEvery - 1;
  const Left left = forces_left(system, motion, s);
  double weight = 0, size = 0;
  for (std::size_t n : system.particle) weight += system.mass[n] * norm(system.gravity);
  for (const model::Lattice& l : system.lattices) size = std::max(size, l.cell * std::max(l.columns, l.rows));
  s.relaxation.max_force = std::max(s.relaxation.max_force, left.sum + left.pins);
  s.relaxation.load = std::max(weight, left.pins);
  if (weight == 0)
    s.relaxation.load =
        std::max({s.relaxation.load, kFaded * s.relaxation.max_force, rounding(system, s) / kResidualRest});
  s.relaxation.residual = left.sum / s.relaxation.load;
  const bool sewn = !seams_to_close(system, s);
  if (sewn && s.relaxation.residual <= kConverged) s.relaxation.settling = 0;
  s.relaxation.at_rest = sewn && s.relaxation.settling <= 0 && s.relaxation.residual <= kResidualRest &&
                         kinetic(system, s) <= kKineticRest * s.relaxation.load * size;
  if (s.relaxation.at_rest) stop(system, s);
}

void relaxation_forget(State& s) { s.relaxation.measure_every = 0; }

void relaxation_resume(State& s) {
  s.relaxation.max_force = 0;
  if (!s.relaxation.at_rest) return;
  relaxation_forget(s);
  s.relaxation.at_rest = false;
  s.relaxation.intervals_to_convergence_check = 0;
  s.steps_to_limit_check = 0;
}

}  // namespace drape::dynamics
