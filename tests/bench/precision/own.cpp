#include "bench/precision/own.h"

#include <chrono>
#include <cmath>

#include "bench/cloths.h"
#include "dynamics/step_size/step_limit.h"
#include "model/composition.h"

namespace drape::bench {
namespace {

Scene scene_for(Scene scene, Own own) {
  scene.integrator = own == Own::kPaper ? scene::Integrator::kPaper : scene::Integrator::kLeapfrog;
  scene.order = own == Own::kOrder4 ? 4 : own == Own::kOrder6 ? 6 : 2;
  return scene;
}

// r <- r + h v,  v <- v + h (F/m + g - c v): the old velocity moves the particles, the old positions give
// the forces.
void euler_step(Ready& r, Array (&f)[3], double h) {
  dynamics::kernel_forces(*r.motion.kernel, r.system, r.state, r.motion.workspace,
                          {f[0].data(), f[1].data(), f[2].data()});
  Array* at[] = {&r.state.x, &r.state.y, &r.state.z};
  Array* speed[] = {&r.state.vx, &r.state.vy, &r.state.vz};
  const double c = r.system.damping;
  for (std::size_t k = 0; k < 3; ++k) {
    double *x = at[k]->data(), *v = speed[k]->data();
    const double *pull = f[k].data(), *inverse_mass_scale = r.system.inverse_mass.data(),
                 g = r.system.gravity[k];
    for (std::size_t n : r.system.particle) {
      x[n] += h * v[n];
      v[n] += h * (pull[n] * inverse_mass_scale[n] + g - c * v[n]);
    }
  }
  for (const constraint::FixedNode& node : r.system.constraints.fixed)
    for (Array* v : speed) (*v)[node.node] = 0;
}

}  // namespace

bool own_fits(const Scene& scene, Own own) {
  return !scene.has_air || (own != Own::kOrder4 && own != Own::kOrder6);
}

double own_min_steps(const Scene& scene, Own own, double end) {
  const Ready r = ready_at_start(scene_for(scene, own));
  return end / dynamics::step_limit_of(r.system, r.state.omega2);
}

Stepped own_run(const Scene& scene, Own own, double end, long steps) {
  Ready r = ready_at_start(scene_for(scene, own));
  Array f[3];
  for (Array& a : f) a.assign(r.system.nodes, 0.0);
  const double h = end / double(steps);
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  for (long k = 0; k < steps; ++k) {
    if (own == Own::kEuler) euler_step(r, f, h);
    else dynamics::leapfrog_step(r.system, r.motion, r.state, h);
  }
  Stepped result;
  result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  result.evaluations = steps * (r.system.composition ? r.system.composition->stages : 1);
  result.r.resize(Eigen::Index(3 * r.system.particle.size()));
  Eigen::Index k = 0;
  for (std::size_t n : r.system.particle)
    for (const Array* a : {&r.state.x, &r.state.y, &r.state.z}) result.r[k++] = (*a)[n];
  if (!result.r.allFinite()) result.r.resize(0);
  return result;
}

}  // namespace drape::bench
