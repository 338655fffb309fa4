// The same equations with the forces of Drape's kernel and with those of the reference solver.
#include <memory>
#include <stdexcept>

#include "bench/cloths.h"
#include "bench/precision/trial.h"
#include "reference/motion.h"

namespace drape::bench {
namespace {

// Particles that are contiguous in the arrays of nodes, and are copied at once.
struct Stretch {
  std::size_t node, count;
};

// Drape's forces on y = [x, y, z, vx, vy, vz], each [particles].
struct KernelForces {
  Ready cloth;
  std::vector<Stretch> stretches;
  std::size_t particles;
  bool moves;  // true: r' = v is part of it
  Array f[3];
};

std::shared_ptr<KernelForces> kernel_forces_make(const Scene& scene, bool moves) {
  auto forces = std::make_shared<KernelForces>();
  forces->cloth = ready_at_start(scene);
  const System& system = forces->cloth.system;
  if (!system.constraints.rows.empty()) throw std::runtime_error("a trial holds whole nodes only");
  forces->particles = system.particle.size();
  forces->moves = moves;
  for (const std::size_t n : system.particle) {
    std::vector<Stretch>& s = forces->stretches;
    if (!s.empty() && s.back().node + s.back().count == n) ++s.back().count;
    else s.push_back({n, 1});
  }
  for (Array& a : forces->f) a.assign(system.nodes, 0.0);
  return forces;
}

// v' = F/m + g - c v of one coordinate. Held particles do not move.
void acceleration(const KernelForces& forces, std::size_t k, const double* v, double* rate) {
  const System& system = forces.cloth.system;
  const double g = system.gravity[k], c = system.damping;
  for (const Stretch& s : forces.stretches) {
    const double* __restrict pull = forces.f[k].data() + s.node, * __restrict inverse_mass =
                                                                     system.inverse_mass.data() + s.node;
    double* __restrict to = rate;
    const double* __restrict speed = v;
    for (std::size_t n = 0; n < s.count; ++n) to[n] = pull[n] * inverse_mass[n] + g - c * speed[n];
    rate += s.count;
    v += s.count;
  }
}

void rate_by(KernelForces& forces, const double* y, double* rate) {
  Ready& r = forces.cloth;
  const std::size_t n = forces.particles;
  Array* to[] = {&r.state.x, &r.state.y, &r.state.z, &r.state.vx, &r.state.vy, &r.state.vz};
  const double* from = y;
  for (Array* a : to)
    for (const Stretch& s : forces.stretches) {
      std::copy(from, from + s.count, a->data() + s.node);
      from += s.count;
    }
  dynamics::kernel_forces(*r.motion.kernel, r.system, r.state, r.motion.workspace,
                          {forces.f[0].data(), forces.f[1].data(), forces.f[2].data()});
  if (forces.moves) std::copy(y + 3 * n, y + 6 * n, rate);
  else std::fill(rate, rate + 3 * n, 0.0);
  for (std::size_t k = 0; k < 3; ++k) acceleration(forces, k, y + (3 + k) * n, rate + (3 + k) * n);
}

// The indices of the held particles among all.
std::vector<std::size_t> held_of(const System& system) {
  std::vector<std::size_t> held;
  for (std::size_t k = 0; k < system.particle.size(); ++k)
    for (const constraint::FixedNode& f : system.constraints.fixed)
      if (f.node == system.particle[k]) held.push_back(k);
  return held;
}

// The scene with stretch, shear and -m c v alone, and the scene with all other forces.
Scene inner_of(Scene s) {
  for (scene::FabricSpec& f : s.fabrics) f.bending_warp = f.bending_weft = 0;
  s.gravity = s.wind = {0, 0, 0};
  s.has_air = false;
  s.air_normal = s.air_tangential = 0;
  return s;
}
Scene outer_of(Scene s) {
  for (scene::FabricSpec& f : s.fabrics) f.warp = f.weft = f.bias = {};
  s.damping = 0;
  return s;
}

Rate kernel_rate(const Scene& scene, bool moves) {
  const std::shared_ptr<KernelForces> forces = kernel_forces_make(scene, moves);
  const std::vector<std::size_t> held = held_of(forces->cloth.system);
  return [forces, held](const double* y, double* rate) {
    rate_by(*forces, y, rate);
    for (std::size_t k : held)
      for (std::size_t c = 3; c < 6; ++c) rate[c * forces->particles + k] = 0;
  };
}

Rate reference_rate(const Scene& scene, bool moves) {
  const auto motion = std::make_shared<reference::Motion>(reference::motion_make(scene));
  const auto course = std::make_shared<reference::Course>(
      reference::course_make(motion->lattice, motion->start, motion->start, 1));
  const reference::Layout at = reference::layout_of(motion->lattice);
  return [=](const double* y, double* rate) {
    Eigen::Map<Eigen::VectorXd> to(rate, at.size);
    to = reference::motion_rate(*motion, *course, Eigen::Map<const Eigen::VectorXd>(y, at.size));
    if (!moves) to.head(at.velocity).setZero(), to[at.time] = 0;
  };
}

}  // namespace

Equations equations_of_kernel(const Scene& scene) {
  Equations e;
  const std::shared_ptr<KernelForces> forces = kernel_forces_make(scene, true);
  const State& s = forces->cloth.state;
  const Array* from[] = {&s.x, &s.y, &s.z, &s.vx, &s.vy, &s.vz};
  for (const Array* a : from)
    for (const std::size_t n : forces->cloth.system.particle) e.start.push_back((*a)[n]);
  const std::size_t n = forces->particles;
  e.scale.assign(6 * n, scene.pieces[0].cell);
  std::fill(e.scale.begin() + std::ptrdiff_t(3 * n), e.scale.end(), 1.0);
  e.rate = kernel_rate(scene, true);
  e.inner = kernel_rate(inner_of(scene), true);
  e.outer = kernel_rate(outer_of(scene), false);
  e.positions = [n](const double* y) {
    return Eigen::VectorXd(Eigen::Map<const Eigen::MatrixXd>(y, Eigen::Index(n), 3).transpose().reshaped());
  };
  return e;
}

Equations equations_of_reference(const Scene& scene) {
  Equations e;
  const reference::Motion motion = reference::motion_make(scene);
  const reference::Layout at = reference::layout_of(motion.lattice);
  const Eigen::VectorXd y = reference::motion_start(motion);
  e.start.assign(y.begin(), y.end());
  constexpr double kFree = 1e100;  // impulses, work and time do not control the step
  e.scale.assign(e.start.size(), kFree);
  std::fill_n(e.scale.begin(), at.velocity, scene.pieces[0].cell);
  std::fill_n(e.scale.begin() + at.velocity, at.velocity, 1.0);
  e.rate = reference_rate(scene, true);
  e.inner = reference_rate(inner_of(scene), true);
  e.outer = reference_rate(outer_of(scene), false);
  e.positions = [at](const double* z) {
    return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(z, at.velocity));
  };
  return e;
}

}  // namespace drape::bench
