// One step as kicks and drifts, and the completion of its last kick. core/README.md, section 4.
#include <algorithm>
#include <cmath>

#include "dynamics/advance.h"
#include "forces/irregular_elements.h"
#include "forces/seam_closing.h"
#include "math/vector3.h"
#include "model/composition.h"

namespace drape::dynamics {
namespace {

using namespace math::vector3;

// v <- keep v + kick a,  r <- r + drift v.  Of the kick, `half` belongs to the step before.
struct Stage {
  double keep, kick, drift;
  double half;       // s
  double begun;      // s, the part of the kick's time that belongs to this step
  double span;       // s, the time of the whole kick
  double impulse;    // over mass and what is taken out of v after the kick
  double before;     // what damping has left of v when the kick begins
  double centred;    // over the synchronous velocity
  double decay = 1;  // of v in the drift
};

// h_old = 0 is the half kick of the start.
Stage stage_of_leapfrog(const System& system, const State& s, double h) {
  const double c = damping_of(system, s), half = s.h_old / 2;
  if (system.integrator == scene::Integrator::kPaper) return {1 - c * h, h, h, 0, h, h, 1, 1, 1};
  const double centred = 1 + c * h / 2, span = (s.h_old + h) / 2;
  return {(1 - c * s.h_old / 2) / centred, span / centred, h, half, h / 2, span, centred, 1, 1 + c * half};
}

// Stage k of a composition; -m c v alone acts during its drift.
Stage stage_of_composition(const System& system, const State& s, double h, int k) {
  const model::Composition& of = *system.composition;
  const double c = system.damping, time = of.drift[k] * h, begun = of.kick[k] * h;
  const double before = k == 0 ? last_decay(system, s) : std::exp(-c * (of.drift[k - 1] * h));
  const double half = k == 0 ? last_half(system, s) : 0, span = half + begun;
  const double drift = c == 0 ? time : -std::expm1(-c * time) / c;
  return {before, span, drift, half, begun, span, 1, before, 1, std::exp(-c * time)};
}

// What the slopes that clamps hold pass to the pins beside the forces on held points: their torques now x
// `span` (s).
void clamp_torques_add(const System& system, Motion& motion, State& s, double span) {
  if (system.irregular.clamps.empty()) return;
  motion.torque.assign(motion.torque.size(), Vec3{0, 0, 0});
  forces::clamp_torques(system, s, motion.torque);
  for (std::size_t p = 0; p < motion.torque.size(); ++p) s.pin_impulse[p].torque += span * motion.torque[p];
}

// A stage that leads to the share u of the interval.
void stage_run(const System& system, Motion& motion, State& s, const Stage& stage, double h, double u) {
  const bool begins = s.advance_begins && system.integrator != scene::Integrator::kPaper;
  const StepCoefficients c{stage.keep, stage.kick, stage.drift, gravity_of(system, s),
                           velocity_extrapolation(system, s)};
  if (system.energy) balance_begin(system, motion.balance, s, c.extrapolation);
  if (begins || system.energy) held_store_velocities(motion.constraints, s, motion.held);
  clamp_torques_add(system, motion, s, begins ? stage.begun : stage.span);
  if (!s.sewn.empty()) forces::seams_gap_rates(system, s, motion.gap_rate);
  const bool touches = contact::any_near(s);
  if (touches) contact::store_velocities(system, motion.contact, s);
  const bool rubs = contact::self_enabled(system);
  if (rubs) contact::self_store_velocities(system, motion.self, s, h);
  kernel_step(*motion.kernel, system, c, motion.workspace, s);
  if (!s.sewn.empty()) s.gap_rate.swap(motion.gap_rate);
  const double old = system.integrator == scene::Integrator::kPaper ? 0 : s.h_old / 2;
  const contact::ContactStep contact{stage.drift,
                                     stage.keep,
                                     stage.kick,
                                     old,
                                     h / 2,
                                     stage.impulse,
                                     begins && !motion.contact.half_kick_reported,
                                     stage.centred};
  path_follow(motion.path, u, s);
  HeldStep step{stage.drift,
                stage.keep,
                stage.kick,
                stage.impulse,
                begins,
                begins ? stage.half : 0,
                begins ? stage.centred : 1,
                stage.before};
  if (touches) contact::warm_start(system, motion.contact, contact, s);
  constraints_project_step(system, motion.constraints, step, motion.held, s);
  if (rubs) contact::self_apply(system, motion.self, contact, s);
  if (touches) contact::apply(system, motion.kernel->contact, motion.contact, contact, s);
  if (touches || (rubs && contact::self_any_touching(motion.self))) {
    step.again = true;
    if (!rubs && !motion.contact.touched.empty()) step.hit = motion.contact.touched.data();
    constraints_project_step(system, motion.constraints, step, motion.held, s);
  }
  constraints_end_step(motion.constraints, s, motion.held);
  bodies_follow(motion.path, u, s);
  if (!s.body.empty())
    contact::update_proximity(system, motion.kernel->contact, motion.contact, s, stage.drift, h);
  if (rubs) contact::self_update_proximity(system, s, stage.drift);
  if (!s.sewn.empty()) forces::seams_update_integral(system, s, h);
  if (system.energy && system.composition) balance_drifted(system, motion.balance, s, stage.decay);
  else if (system.energy) balance_end(system, motion.balance, s, s.h_old, h);
  s.advance_begins = false;
}

}  // namespace

double damping_of(const System& system, const State& s) {
  return system.fit ? s.relaxation.damping : system.damping;
}

Vec3 gravity_of(const System& system, const State& s) {
  return system.fit && s.relaxation.sewing ? Vec3{0, 0, 0} : system.gravity;
}

double last_half(const System& system, const State& s) {
  if (system.composition) return system.composition->kick[system.composition->stages] * s.h_old;
  return system.integrator == scene::Integrator::kPaper ? 0 : s.h_old / 2;
}

double last_decay(const System& system, const State& s) {
  if (!system.composition) return 1;
  return std::exp(-system.damping * (system.composition->drift[system.composition->stages - 1] * s.h_old));
}

void leapfrog_step(const System& system, Motion& motion, State& s, double h, double u, double share) {
  if (const model::Composition* of = system.composition) {
    double left = 1;  // of the step
    for (int k = 0; k < of->stages; ++k) {
      left -= of->drift[k];
      const bool last = k + 1 == of->stages;
      stage_run(system, motion, s, stage_of_composition(system, s, h, k), h, last ? u : u - left * share);
    }
  } else {
    stage_run(system, motion, s, stage_of_leapfrog(system, s, h), h, u);
  }
  s.h_older = s.h_old;
  s.h_old = h;
  ++s.steps;
}

void leapfrog_complete(const System& system, Motion& motion, State& s) {
  if (s.h_old == 0 || system.integrator == scene::Integrator::kPaper) return;
  std::vector<math::Wrench> reported;
  const double extrapolation = velocity_extrapolation(system, s);
  leapfrog_synchronous(system, motion, s, motion.now_x.data(), motion.now_y.data(), motion.now_z.data(),
                       reported);
  if (system.energy) {
    const BalanceNow now =
        balance_now(system, motion.balance, s, extrapolation, motion.now_x, motion.now_y, motion.now_z);
    s.dissipated = now.dissipated + motion.contact.dissipated + motion.self.dissipated;
    s.input = now.input + motion.held.work + motion.contact.input;
  }
  const double half = last_half(system, s);
  // what has been taken out for the first step (ridges_told) does not come in any more
  const bool adds = !s.advance_begins || motion.contact.half_kick_reported;
  for (std::size_t b = 0; adds && b < s.body.size(); ++b) {
    s.body[b].impulse.force += motion.contact.load[b].force;
    s.body[b].impulse.torque += motion.contact.load[b].torque;
  }
  if (s.advance_begins) motion.contact.half_kick_reported = false;
  for (std::size_t p = 0; !s.advance_begins && p < reported.size(); ++p) {
    s.pin_impulse[p].force += half * reported[p].force;
    s.pin_impulse[p].torque += half * reported[p].torque;
  }
  for (std::size_t n : system.particle) {
    s.vx[n] = motion.now_x[n];
    s.vy[n] = motion.now_y[n];
    s.vz[n] = motion.now_z[n];
  }
  if (contact::edge_any(s))
    contact::edge_store_velocities(system, s,
                                   motion.contact.edge_pairs);  // what penalties lost is counted above
  s.h_old = s.h_older = 0;
}

void project_synchronous(const System& system, Motion& motion, const State& s, Rate which, double half,
                         double centred, Field f, std::vector<math::Wrench>* load) {
  held_rates(motion.constraints, s, which, motion.held);
  contact::warm_start_synchronous(system, motion.contact, s, {half, centred, f});
  constraints_project(system, motion.constraints, motion.held, f, load);
  if (contact::self_enabled(system)) contact::self_synchronous(system, motion.self, s, {half, centred, f});
  if (!s.body.empty())
    contact::apply_synchronous(system, motion.kernel->contact, motion.contact, s, {half, centred, f});
  if (contact::any_near(s) || (contact::self_enabled(system) && contact::self_any_touching(motion.self)))
    constraints_project(system, motion.constraints, motion.held, f, load);
}

// v_n = (v_{n-1/2} + (h_old/2) f)/(1 + c h_old/2) with the free acceleration f = F/m + g; above order 2, the
// damped v of the last drift + b h_old f; the paper's scheme holds v_n itself. Loads are what a projection
// takes out of that half kick; where there was none, and in a fit, whose steps have another inertia, of the
// accelerations f - c v_n, from which v_n then follows again.
void leapfrog_synchronous(const System& system, Motion& motion, const State& s, double* vx, double* vy,
                          double* vz, std::vector<math::Wrench>& load) {
  const double half = last_half(system, s), damping = damping_of(system, s), decay = last_decay(system, s),
               centred = system.composition ? 1 : 1 + damping * half;
  const bool step = half > 0 && !system.fit;
  const Array* staggered[] = {&s.vx, &s.vy, &s.vz};
  double* now[] = {vx, vy, vz};
  const double* inverse_mass_scale = s.inverse_mass_scale.empty() ? nullptr : s.inverse_mass_scale.data();
  const Vec3 gravity = gravity_of(system, s);
  const auto each = [&](auto value) {  // from what it is, v_{n-1/2}, h_old/2, 1/m, g; unused nodes too
    for (std::size_t k = 0; k < 3; ++k) {
      const double *v = staggered[k]->data(), *inverse_mass = system.inverse_mass.data();
      const double g = gravity[k];
      for (std::size_t n = 0; n < system.nodes; ++n)
        now[k][n] = value(now[k][n], v[n], inverse_mass_scale ? half * inverse_mass_scale[n] : half,
                          inverse_mass[n], g);
    }
  };
  HeldMotion& held = motion.held;
  load.assign(s.pin_impulse.size(), math::Wrench{});
  held_refresh(motion.constraints, s, held);
  kernel_forces(*motion.kernel, system, s, motion.workspace, vx, vy, vz);
  held.work = 0;
  motion.self.dissipated = 0;
  std::fill(held.taken.begin(), held.taken.end(), 0.0);
  if (step) {
    each([&](double force, double v, double kick, double inverse_mass, double g) {
      return (decay * v + kick * (force * inverse_mass + g)) / centred;
    });
    project_synchronous(system, motion, s, Rate::kVelocity, half, centred, {vx, vy, vz}, &load);
  } else {
    each([&](double force, double v, double kick, double inverse_mass, double g) {
      const double free = force * inverse_mass + g;
      return free - damping * ((v + kick * free) / centred);
    });
    project_synchronous(system, motion, s, Rate::kAcceleration, 0, 1, {vx, vy, vz}, &load);
    each([&](double acceleration, double v, double kick, double, double) {
      return (v + kick * acceleration) / (centred - kick * damping);
    });
    held_rates(motion.constraints, s, Rate::kVelocity, held);
    constraints_project(system, motion.constraints, held, {vx, vy, vz}, nullptr);
  }
  if (step) {
    if (system.energy) held.work = held_work(motion.constraints, s, decay, centred, held);
    for (math::Wrench& l : load) l = {(centred / half) * l.force, (centred / half) * l.torque};
  }
  motion.torque.assign(load.size(), Vec3{0, 0, 0});
  forces::clamp_torques(system, s, motion.torque);
  for (std::size_t p = 0; p < load.size(); ++p) load[p].torque += motion.torque[p];
}

}  // namespace drape::dynamics
