// Equations: core/README.md, section 4. The power of a pin on the cloth is -(F.v + T.w), with F and T its
// force and torque on the outside world: every held point moves with v + w x arm.
#include "reference/motion.h"

#include "reference/sewing.h"

namespace drape::reference {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

// The motion without constraints: [m g - m c v + F(r, v)]/m.
struct Free {
  VectorXd acceleration, couple;  // [3 N] m/s^2; [3 pins] N m, of the clamps' hinges on their pins
  double input, dissipated;       // W, power of wind and seams on the cloth; dissipated power
};

Free free_motion(const Motion& motion, const Outside& outside, const VectorXd& r, const VectorXd& v,
                 const VectorXd& integral) {
  const Lattice& lattice = motion.lattice;
  VectorXd F = VectorXd::Zero(3 * lattice.count);
  add_stretch(lattice, r, F);
  add_shear(lattice, r, F);
  add_bending(lattice, r, F);
  Free free;
  free.couple = add_clamps(lattice, turns_of(outside), r, F);
  free.dissipated = add_link_damping(lattice, r, v, F);
  const AirPower air = add_air(lattice, motion.air, outside.wind, r, v, F);
  free.dissipated += air.dissipated;
  free.dissipated += add_contact(lattice, motion.contact, r, v, F);
  add_bonds(lattice, motion.sewing, r, F);
  free.input = air.input + add_closing(lattice, motion.sewing, integral, r, v, F);
  for (int n = 0; n < lattice.count; ++n) {
    const double m = lattice.mass[std::size_t(n)];
    const Vector3d speed = v.segment<3>(3 * n);
    F.segment<3>(3 * n) = F.segment<3>(3 * n) / m + motion.gravity - motion.damping * speed;
    free.dissipated += motion.damping * m * speed.squaredNorm();
  }
  free.acceleration = std::move(F);
  return free;
}

double kinetic_energy(const Lattice& lattice, const VectorXd& v) {
  double sum = 0;
  for (int n = 0; n < lattice.count; ++n)
    sum += lattice.mass[std::size_t(n)] * v.segment<3>(3 * n).squaredNorm() / 2;
  return sum;
}

std::vector<Vector3d> arms_of(const Lattice& lattice, const Outside& outside,
                              const std::vector<Target>& targets) {
  std::vector<Vector3d> arms;
  for (std::size_t k = 0; k < targets.size(); ++k)
    arms.push_back(targets[k].r - outside.pins[std::size_t(lattice.rows[k].pin)].p);
  return arms;
}

std::vector<Vector3d> each(const std::vector<Target>& targets, Vector3d Target::* what) {
  std::vector<Vector3d> values;
  for (const Target& target : targets) values.push_back(target.*what);
  return values;
}

}  // namespace

Motion motion_make(const Scene& scene) {
  Motion motion;
  motion.lattice = lattice_make(scene);
  motion.contact = contact_make(scene);
  motion.sewing = sewing_start(motion.lattice);
  for (const Seam& seam : motion.lattice.seams) motion.closing_since.emplace_back(seam.pairs.size(), 0.0);
  motion.held = held_make(motion.lattice, motion.sewing);
  motion.gravity = {scene.gravity[0], scene.gravity[1], scene.gravity[2]};
  motion.damping = scene.damping;
  if (scene.has_air) motion.air = {scene.air_density, scene.air_normal, scene.air_tangential};
  motion.start = outside_start(scene, motion.lattice);
  return motion;
}

Layout layout_of(const Lattice& lattice) {
  const Index n = 3 * Index(lattice.count), pins = 3 * Index(lattice.pins.size()), end = 2 * (n + pins);
  Index pairs = 0;
  for (const Seam& seam : lattice.seams) pairs += Index(seam.pairs.size());
  return {n, 2 * n, 2 * n + pins, end, end + 1, end + 2, end + 2 + pairs, end + 3 + pairs};
}

Turns turns_of(const Outside& outside) {
  Turns turns;
  for (const Frame& frame : outside.pins) turns.push_back(frame.R.toRotationMatrix());
  return turns;
}

VectorXd motion_rate(const Motion& motion, const Course& course, const VectorXd& y) {
  const Lattice& lattice = motion.lattice;
  const Layout at = layout_of(lattice);
  const Outside outside = course_at(course, y[at.time]);
  const VectorXd r = y.head(at.velocity), v = y.segment(at.velocity, at.velocity);
  const VectorXd integral = y.segment(at.integral, at.time - at.integral);
  Free free = free_motion(motion, outside, r, v, integral);
  const std::vector<Target> targets = targets_of(lattice, outside.pins);
  Passed passed = constraints_project(lattice, motion.held, each(targets, &Target::a),
                                      arms_of(lattice, outside, targets), free.acceleration);
  passed.torque += free.couple;
  for (std::size_t k = 0; k < outside.pins.size(); ++k)
    free.input -= passed.force.segment<3>(3 * Index(k)).dot(outside.pins[k].v) +
                  passed.torque.segment<3>(3 * Index(k)).dot(outside.pins[k].w);
  VectorXd rate(at.size);
  rate << v, free.acceleration, passed.force, passed.torque, free.input, free.dissipated,
      integral_rates(motion, motion.begun + y[at.time], r, v), 1;
  return rate;
}

VectorXd motion_start(const Motion& motion) {
  const Lattice& lattice = motion.lattice;
  const Layout at = layout_of(lattice);
  VectorXd y = VectorXd::Zero(at.size);
  y.head(at.velocity) = lattice.position;
  y.segment(at.velocity, at.velocity) = lattice.velocity;
  motion_begin(motion, course_make(lattice, motion.start, motion.start, 1), y);
  y[at.input] = 0;  // the start changes no energy
  return y;
}

void motion_begin(const Motion& motion, const Course& course, VectorXd& y) {
  const Lattice& lattice = motion.lattice;
  const Layout at = layout_of(lattice);
  const Outside outside = course_at(course, 0);
  const std::vector<Target> targets = targets_of(lattice, outside.pins);
  const std::vector<Vector3d> arms = arms_of(lattice, outside, targets);
  VectorXd r = y.head(at.velocity), v = y.segment(at.velocity, at.velocity);
  constraints_project(lattice, motion.held, each(targets, &Target::r), arms, r);
  const double before = kinetic_energy(lattice, v);
  const Passed passed = constraints_project(lattice, motion.held, each(targets, &Target::v), arms, v);
  y.head(at.velocity) = r;
  y.segment(at.velocity, at.velocity) = v;
  y.segment(at.impulse, passed.force.size()) += passed.force;
  y.segment(at.angular, passed.torque.size()) += passed.torque;
  y[at.input] += kinetic_energy(lattice, v) - before;
  y[at.time] = 0;
}

Energy motion_energy(const Motion& motion, const Turns& turns, const VectorXd& y) {
  const Lattice& lattice = motion.lattice;
  const Index n = 3 * Index(lattice.count);
  const VectorXd r = y.head(n), v = y.segment(n, n);
  double gravity = 0;
  for (int k = 0; k < lattice.count; ++k)
    gravity -= lattice.mass[std::size_t(k)] * motion.gravity.dot(r.segment<3>(3 * k));
  const BondEnergy sewn = bond_energy(lattice, motion.sewing, r);
  return {kinetic_energy(lattice, v),
          stretch_energy(lattice, r) + sewn.stretch,
          shear_energy(lattice, r),
          bending_energy(lattice, r) + clamp_energy(lattice, turns, r) + sewn.bending,
          gravity,
          contact_energy(lattice, motion.contact, r)};
}

Residual residual(const Motion& motion, const Outside& outside, const VectorXd& r) {
  const Lattice& lattice = motion.lattice;
  VectorXd a = free_motion(motion, outside, r, VectorXd::Zero(r.size()),
                           VectorXd::Zero(layout_of(lattice).time - layout_of(lattice).integral))
                   .acceleration;
  const std::vector<Vector3d> still(lattice.rows.size(), Vector3d::Zero());
  const Passed passed = constraints_project(lattice, motion.held, still, still, a);
  Residual unbalanced{0, 0};
  double mass = 0, pins = 0;
  for (int n = 0; n < lattice.count; ++n) {
    mass += lattice.mass[std::size_t(n)];
    unbalanced.force += lattice.mass[std::size_t(n)] * a.segment<3>(3 * n).norm();
  }
  for (Index k = 0; k < passed.force.size(); k += 3) pins += passed.force.segment<3>(k).norm();
  unbalanced.ratio = unbalanced.force / std::max(mass * motion.gravity.norm(), pins);
  return unbalanced;
}

}  // namespace drape::reference
