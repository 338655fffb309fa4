// One step as kicks and drifts. core/README.md, section 4.
#include <cmath>

#include "dynamics/advance.h"
#include "dynamics/agreement.h"
#include "forces/irregular_elements.h"
#include "forces/seam_closing.h"
#include "math/vector3.h"
#include "model/composition.h"

namespace drape::dynamics {
namespace {

using namespace math::vector3;

// h_old = 0 is the half kick of the start.
model::Scheme scheme_of_leapfrog(const System& system, const State& s, double h) {
  const double c = damping_of(system, s), impulse = 1 + c * h / 2, span = (s.h_old + h) / 2;
  return {.decay = (1 - c * s.h_old / 2) / impulse,
          .kick = span / impulse,
          .drift = h,
          .half = s.h_old / 2,
          .half_new = h / 2,
          .span = span,
          .impulse = impulse,
          .centred = 1 + c * (s.h_old / 2),
          .begins_advance = s.advance_begins};
}

// The paper's scheme: v holds v_n, so that a kick is all of one step.
model::Scheme scheme_of_paper(const System& system, const State& s, double h) {
  return {.decay = 1 - damping_of(system, s) * h, .kick = h, .drift = h, .half_new = h / 2, .span = h};
}

// Stage k of a composition; -m c v alone acts during its drift.
model::Scheme scheme_of_composition(const System& system, const State& s, double h, int k) {
  const model::Composition& of = *system.composition;
  const double c = system.damping, time = of.drift[k] * h, half_new = of.kick[k] * h;
  const double before = k == 0 ? last_decay(system, s) : std::exp(-c * (of.drift[k - 1] * h));
  const double half = k == 0 ? last_half(system, s) : 0, span = half + half_new;
  return {.decay = before,
          .kick = span,
          .drift = c == 0 ? time : -std::expm1(-c * time) / c,
          .half = half,
          .half_new = half_new,
          .span = span,
          .decay_before = before,
          .decay_drift = std::exp(-c * time),
          .begins_advance = s.advance_begins};
}

// What the phases of a step share.
struct StepContext {
  const System& system;
  Motion& motion;
  State& state;
  const model::Scheme& scheme;
  double h;                   // s, of the whole step
  double share;               // of the interval: where the stage leads
  bool near_body;             // a particle is near a body, or a link near a sharp edge
  bool self_contact;          // cloth touches cloth in this scene
  bool pulled;                // a pair of a seam is closing
  bool turned;                // a clamp turns
  double contact_change = 0;  // m/s, the largest change of a velocity by contact with bodies
};

void store_velocities(StepContext& c) {
  const System& system = c.system;
  if (system.energy) balance_begin(system, c.motion.balance, c.state, c.scheme.extrapolation);
  if (c.turned) clamps_begin(system, c.motion.balance, c.state);
  if (c.scheme.begins_advance || c.motion.held.moves)
    held_store_velocities(c.motion.constraints, c.state, c.motion.held);
  if (!c.state.sewn.empty()) {
    forces::seams_gap_rates(system, c.state, c.motion.gap_rate);
    if (c.pulled) pull_begin(system, c.motion.balance, c.state, c.scheme.extrapolation);
  }
  if (c.near_body) contact::store_velocities(system, c.motion.contact, c.state);
  if (!c.self_contact) return;
  contact::self_store_velocities(system, c.motion.kernel->self_contact, c.motion.self, c.state, c.h);
  if (system.energy) c.state.input += contact::self_parting_work(system, c.motion.self, c.state, c.h);
}

// The torques of clamps pass to the pins beside the forces on held points.
void report_clamp_torques(StepContext& c) {
  if (c.system.irregular.clamps.empty()) return;
  std::vector<Vec3>& torque = c.motion.torque;
  forces::clamp_torques(c.system, c.state, torque);
  const double time = c.scheme.begins_advance ? c.scheme.half_new : c.scheme.span;
  for (std::size_t p = 0; p < torque.size(); ++p) c.state.pin_impulse[p].torque += time * torque[p];
}

void step_freely(StepContext& c) {
  kernel_step(*c.motion.kernel, c.system, c.scheme, c.motion.workspace, c.state);
  if (!c.state.sewn.empty()) c.state.gap_rate.swap(c.motion.gap_rate);
}

void move_pins(StepContext& c) { path_follow(c.motion.path, c.share, c.state); }

void warm_start_contact(StepContext& c) {
  if (c.near_body) contact::warm_start(c.system, c.motion.contact, c.scheme, c.state);
}

void project_constraints(StepContext& c) {
  constraints_project_step(c.system, c.motion.constraints, c.scheme, c.motion.held, c.state);
}

void apply_self_contact(StepContext& c) {
  if (c.self_contact)
    contact::self_apply(c.system, c.motion.kernel->self_contact, c.motion.self, c.scheme, c.state);
}

void apply_contact(StepContext& c) {
  if (c.near_body)
    c.contact_change =
        contact::apply(c.system, c.motion.kernel->contact, c.motion.contact, c.scheme, false, c.state);
}

// What contact has changed is projected again. Self-contact does not note where it acted.
void project_again(StepContext& c) {
  if (!c.near_body && !(c.self_contact && contact::self_any_touching(c.motion.self))) return;
  const std::vector<char>& touched = c.motion.contact.touched;
  const bool known = !c.self_contact && !touched.empty();
  constraints_project_again(c.system, c.motion.constraints, c.scheme, known ? touched.data() : nullptr,
                            c.motion.held, c.state);
}

// Where contact acts on particles that constraints or several surfaces share, they respond in turns.
void agree_contact(StepContext& c) {
  if (!c.near_body || !contact::couples(c.system, c.motion.contact, c.state)) return;
  agree(
      c.system.fit ? kAgreeInFit : kAgreeInMotion, c.contact_change,
      [&] {
        return contact::apply(c.system, c.motion.kernel->contact, c.motion.contact, c.scheme, true, c.state);
      },
      [&] { project_again(c); });
}

// Contact has done its work at the velocities that the last projection has left.
void balance_contact(StepContext& c) {
  if (!c.system.energy) return;
  const double* const v[] = {c.state.vx.data(), c.state.vy.data(), c.state.vz.data()};
  if (c.near_body) {
    const contact::ContactWork work = contact::contact_work(c.motion.contact, c.state, v);
    c.state.dissipated += work.dissipated;
    c.state.input += work.input;
  }
  if (c.self_contact)
    c.state.dissipated += contact::self_work(c.motion.kernel->self_contact, c.motion.self, v);
}

void end_projection(StepContext& c) { constraints_end_step(c.motion.constraints, c.state, c.motion.held); }

void move_bodies(StepContext& c) { bodies_follow(c.motion.path, c.share, c.state); }

void update_proximity(StepContext& c) {
  if (!c.state.body.empty())
    contact::update_proximity(c.system, c.motion.kernel->contact, c.motion.contact, c.state, c.scheme.drift,
                              c.h);
  if (c.self_contact) contact::self_update_proximity(c.system, c.state, c.scheme.drift);
}

void update_seams(StepContext& c) {
  if (!c.state.sewn.empty()) forces::seams_update_integral(c.system, c.state, c.h);
}

void balance_energy(StepContext& c) {
  if (c.turned) c.state.drive_work += clamps_work(c.system, c.motion.balance, c.state);
  if (c.pulled) c.state.drive_work += pull_work(c.system, c.motion.balance, c.state, c.scheme.span);
  if (!c.system.energy) return;
  if (c.system.composition) balance_drifted(c.system, c.state, c.scheme.decay_drift);
  else balance_end(c.system, c.motion.balance, c.state, c.state.h_old, c.h);
}

// A phase and the facts about the state that it needs and establishes.
enum Fact : unsigned {
  kClampsReported = 1 << 0,  // the torques of t_n
  kStored = 1 << 1,          // what later phases need of v_{n-1/2}
  kFree = 1 << 2,            // all particles have moved as if nothing held or touched them
  kPinsMoved = 1 << 3,       // pins and wind are at t_{n+1}
  kWarmStarted = 1 << 4,     // contact has given what it gave in the last step
  kProjected = 1 << 5,       // held points are where their pins are
  kSelfContact = 1 << 6,     // cloth has responded to cloth
  kContact = 1 << 7,         // cloth has responded to bodies
  kHeld = 1 << 8,            // constraints hold after contact
  kAgreed = 1 << 9,          // and contact has responded to what they have changed
  kEnded = 1 << 10,          // the targets of t_{n+1} are those of the next t_n
  kBodiesMoved = 1 << 11,    // bodies are at t_{n+1}
  kContactBooked = 1 << 12   // the energy that contact has dissipated and brought in
};
struct Phase {
  void (*run)(StepContext&);
  unsigned needs, establishes;
};
constexpr Phase kPhases[] = {
    {report_clamp_torques, 0, kClampsReported},
    {store_velocities, 0, kStored},
    {step_freely, kClampsReported | kStored, kFree},
    {move_pins, kFree, kPinsMoved},
    {warm_start_contact, kFree, kWarmStarted},
    {project_constraints, kPinsMoved | kWarmStarted, kProjected},
    {apply_self_contact, kProjected, kSelfContact},
    {apply_contact, kSelfContact, kContact},
    {project_again, kContact, kHeld},
    {agree_contact, kHeld, kAgreed},
    {balance_contact, kAgreed, kContactBooked},
    {end_projection, kAgreed, kEnded},
    {move_bodies, kAgreed, kBodiesMoved},
    {update_proximity, kContactBooked | kBodiesMoved, 0},
    {update_seams, kAgreed, 0},
    {balance_energy, kEnded, 0},
};

// Every phase comes after those that establish what it needs.
constexpr bool phases_in_order() {
  unsigned facts = 0;
  for (const Phase& phase : kPhases) {
    if ((phase.needs & facts) != phase.needs) return false;
    facts |= phase.establishes;
  }
  return true;
}
static_assert(phases_in_order());

// A stage that leads to `share` of the interval.
void stage_run(const System& system, Motion& motion, State& s, model::Scheme scheme, double h, double share) {
  scheme.gravity = gravity_of(system, s);
  scheme.extrapolation = velocity_extrapolation(system, s);
  StepContext context{system,
                      motion,
                      s,
                      scheme,
                      h,
                      share,
                      contact::any_near(s),
                      contact::self_enabled(system),
                      forces::seams_any_pulled(s),
                      !system.irregular.clamps.empty() && path_rotates(motion.path)};
  for (const Phase& phase : kPhases) phase.run(context);
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
  const model::Composition* of = system.composition;
  if (system.integrator == scene::Integrator::kPaper) {
    stage_run(system, motion, s, scheme_of_paper(system, s, h), h, u);
  } else if (!of) {
    stage_run(system, motion, s, scheme_of_leapfrog(system, s, h), h, u);
  } else {
    double left = 1;  // of the step
    for (int k = 0; k < of->stages; ++k) {
      left -= of->drift[k];
      const bool last = k + 1 == of->stages;
      stage_run(system, motion, s, scheme_of_composition(system, s, h, k), h, last ? u : u - left * share);
    }
  }
  s.h_older = s.h_old;
  s.h_old = h;
  ++s.steps;
}

}  // namespace drape::dynamics
