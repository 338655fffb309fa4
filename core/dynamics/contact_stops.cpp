// The forces of stops, for pressures: the part of a body's force beyond its penalty. core/README.md,
// section 9.
#include "dynamics/advance.h"

namespace drape::dynamics {

contact::ContactStops leapfrog_stops(const System& system, Motion& motion, const State& s) {
  if (!contact::any_stopped(system, s)) return {};
  const model::Field f = motion_field(motion);
  const model::Scheme scheme{.pass = model::Pass::kAcceleration};
  free_accelerations(system, motion, s);
  held_refresh(motion.constraints, s, motion.held);
  held_rates(motion.constraints, s, model::Pass::kAcceleration, motion.held);
  contact::warm_start_synchronous(system, motion.contact, s, {scheme, f});
  constraints_project(system, motion.constraints, motion.held, f, nullptr);
  if (contact::self_enabled(system))
    contact::self_synchronous(system, motion.kernel->self_contact, motion.self, s, {scheme, f});
  const contact::ContactStops stops =
      contact::stop_forces(system, motion.contact.edge_scratch, s, motion.contact.edge_pairs, f);
  held_rates(motion.constraints, s, model::Pass::kSynchronous, motion.held);
  return stops;
}

}  // namespace drape::dynamics
