// The state at t_n: staggered velocities completed by the last half kick. core/README.md, section 4.
#include <algorithm>
#include <cmath>

#include "dynamics/advance.h"
#include "dynamics/agreement.h"
#include "forces/irregular_elements.h"
#include "math/vector3.h"

namespace drape::dynamics {

using namespace math::vector3;

void leapfrog_complete(const System& system, Motion& motion, State& s) {
  if (s.h_old == 0 || system.integrator == scene::Integrator::kPaper) return;
  std::vector<math::Wrench> load;
  const double extrapolation = velocity_extrapolation(system, s);
  const HalfKick done = leapfrog_synchronous(system, motion, s, motion_field(motion), load);
  if (system.energy) {
    const BalanceNow now =
        balance_now(system, motion.balance, s, extrapolation, {motion.now_x, motion.now_y, motion.now_z});
    s.dissipated = now.dissipated + done.dissipated;
    s.input = now.input + done.work_of_bodies;
  }
  s.drive_work += done.work_of_drives;
  const double half = last_half(system, s);
  // The half kick that was taken out in advance (edge_half_kick_report) is added back here.
  const bool adds = !s.advance_begins || motion.contact.half_kick_reported;
  for (std::size_t b = 0; adds && b < s.body.size(); ++b) {
    s.body[b].impulse.force += motion.contact.load[b].force;
    s.body[b].impulse.torque += motion.contact.load[b].torque;
  }
  if (s.advance_begins) motion.contact.half_kick_reported = false;
  for (std::size_t p = 0; !s.advance_begins && p < load.size(); ++p) {
    s.pin_impulse[p].force += half * load[p].force;
    s.pin_impulse[p].torque += half * load[p].torque;
  }
  for (std::size_t n : system.particle) {
    s.vx[n] = motion.now_x[n];
    s.vy[n] = motion.now_y[n];
    s.vz[n] = motion.now_z[n];
  }
  if (contact::edge_any(s))
    contact::edge_store_velocities(system, s,
                                   motion.contact.edge_pairs);  // the loss of penalties is counted above
  s.h_old = s.h_older = 0;
}

void free_accelerations(const System& system, Motion& motion, const State& s) {
  kernel_forces(*motion.kernel, system, s, motion.workspace, motion_field(motion));
  Array* a[] = {&motion.now_x, &motion.now_y, &motion.now_z};
  const Vec3 g = gravity_of(system, s);
  for (std::size_t n : system.particle)
    for (std::size_t k = 0; k < 3; ++k) (*a[k])[n] = (*a[k])[n] * system.inverse_mass[n] + g[k];
}

void project_synchronous(const System& system, Motion& motion, const State& s, const model::Scheme& scheme,
                         model::Field f, std::vector<math::Wrench>* load) {
  const bool self_contact = contact::self_enabled(system);
  held_rates(motion.constraints, s, scheme.pass, motion.held);
  contact::warm_start_synchronous(system, motion.contact, s, {scheme, f});
  constraints_project(system, motion.constraints, motion.held, f, load);
  if (self_contact)
    contact::self_synchronous(system, motion.kernel->self_contact, motion.self, s, {scheme, f});
  double first = 0;
  if (!s.body.empty())
    first = contact::apply_synchronous(system, motion.kernel->contact, motion.contact, s, {scheme, f}, false);
  if (contact::any_near(s) || (self_contact && contact::self_any_touching(motion.self)))
    constraints_project(system, motion.constraints, motion.held, f, load);
  if (s.body.empty() || !contact::couples(system, motion.contact, s)) return;
  agree(
      scheme.pass == model::Pass::kAcceleration ? kAgreeAtRest : kAgreeInMotion, first,
      [&] {
        return contact::apply_synchronous(system, motion.kernel->contact, motion.contact, s, {scheme, f},
                                          true);
      },
      [&] { constraints_project(system, motion.constraints, motion.held, f, load); });
}

model::Scheme scheme_of_last_kick(const System& system, const State& s) {
  const double half = last_half(system, s);
  return {.pass = half > 0 && !system.fit ? model::Pass::kSynchronous : model::Pass::kAcceleration,
          .decay = last_decay(system, s),
          .half = half,
          .centred = system.composition ? 1 : 1 + damping_of(system, s) * half};
}

namespace {

HalfKick contact_half_kick(const System& system, Motion& motion, const State& s, model::Field f) {
  HalfKick done;
  const double* const v[] = {f.x, f.y, f.z};
  if (!s.body.empty()) {
    const contact::ContactWork work = contact::contact_work(motion.contact, s, v);
    done.dissipated = motion.contact.edge_lost + work.dissipated;
    done.work_of_bodies = work.input;
  }
  if (contact::self_enabled(system))
    done.dissipated += contact::self_work(motion.kernel->self_contact, motion.self, v);
  return done;
}

}  // namespace

// With the free acceleration f = F/m + g,
//
//     v_n = (v_{n-1/2} + (h_old/2) f)/(1 + c h_old/2).
//
// Above order 2 it is the damped v of the last drift + b h_old f. For outputs the paper's scheme holds v_n
// itself. Loads are what the projection takes out of that half kick. Where there was none, and in a fit,
// whose steps have another inertia, loads are those of the accelerations f - c v_n, and v_n follows from the
// projected accelerations.
HalfKick leapfrog_synchronous(const System& system, Motion& motion, const State& s, model::Field f,
                              std::vector<math::Wrench>& load) {
  return half_kick(system, motion, s, scheme_of_last_kick(system, s), f, load);
}

HalfKick half_kick(const System& system, Motion& motion, const State& s, const model::Scheme& scheme,
                   model::Field f, std::vector<math::Wrench>& load) {
  const double half = scheme.half, centred = scheme.centred, decay = scheme.decay,
               damping = damping_of(system, s);
  const bool kicks = scheme.pass == model::Pass::kSynchronous;
  const Array* staggered[] = {&s.vx, &s.vy, &s.vz};
  double* now[] = {f.x, f.y, f.z};
  const double* inverse_mass_scale = s.inverse_mass_scale.empty() ? nullptr : s.inverse_mass_scale.data();
  const Vec3 gravity = gravity_of(system, s);
  const auto each =
      [&](auto value) {  // of force or acceleration, v_{n-1/2}, h_old/2, 1/m, g; unused nodes too
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
  kernel_forces(*motion.kernel, system, s, motion.workspace, f);
  HalfKick done;
  std::fill(held.taken.begin(), held.taken.end(), 0.0);
  if (kicks) {
    each([&](double force, double v, double kick, double inverse_mass, double g) {
      return (decay * v + kick * (force * inverse_mass + g)) / centred;
    });
    project_synchronous(system, motion, s, scheme, f, &load);
    if (system.energy) done = contact_half_kick(system, motion, s, f);
    if (held.moves) done.work_of_drives = held_work(motion.constraints, s, decay, centred, held);
    done.work_of_drives += half * pull_power(system, motion.balance, s, f);
    for (math::Wrench& l : load) l = {(centred / half) * l.force, (centred / half) * l.torque};
  } else {
    each([&](double force, double v, double kick, double inverse_mass, double g) {
      const double free = force * inverse_mass + g;
      return free - damping * ((v + kick * free) / centred);
    });
    project_synchronous(system, motion, s, {.pass = model::Pass::kAcceleration}, f, &load);
    each([&](double acceleration, double v, double kick, double, double) {
      return (v + kick * acceleration) / (centred - kick * damping);
    });
    held_rates(motion.constraints, s, model::Pass::kSynchronous, held);
    constraints_project(system, motion.constraints, held, f, nullptr);
  }
  forces::clamp_torques(system, s, motion.torque);
  for (std::size_t p = 0; p < load.size(); ++p) load[p].torque += motion.torque[p];
  return done;
}

}  // namespace drape::dynamics
