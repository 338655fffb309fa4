// The forces of stops, for pressures: the part of a body's force beyond its penalty. core/README.md,
// section 9.
#include "dynamics/advance.h"

namespace drape::dynamics {

contact::ContactStops leapfrog_stops(const System& system, Motion& motion, const State& s) {
  if (!contact::any_stopped(system, s)) return {};
  Array a[3];
  for (Array& of : a) of.assign(system.nodes, 0.0);
  double* field[] = {a[0].data(), a[1].data(), a[2].data()};
  const model::Field f{field[0], field[1], field[2]};
  const model::Scheme scheme{.pass = model::Pass::kAcceleration};
  kernel_forces(*motion.kernel, system, s, motion.workspace, f);
  const Vec3 g = gravity_of(system, s);
  for (std::size_t n : system.particle)
    for (std::size_t k = 0; k < 3; ++k) a[k][n] = a[k][n] * system.inverse_mass[n] + g[k];
  held_refresh(motion.constraints, s, motion.held);
  held_rates(motion.constraints, s, model::Pass::kAcceleration, motion.held);
  contact::warm_start_synchronous(system, motion.contact, s, {scheme, f});
  constraints_project(system, motion.constraints, motion.held, f, nullptr);
  if (contact::self_enabled(system)) contact::self_synchronous(system, motion.self, s, {scheme, f});
  const contact::ContactStops stops =
      contact::stop_forces(system, motion.contact.edge_scratch, s, motion.contact.edge_pairs, field);
  held_rates(motion.constraints, s, model::Pass::kSynchronous, motion.held);
  return stops;
}

}  // namespace drape::dynamics
