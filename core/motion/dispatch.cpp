#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "forces/side.h"
#include "motion/kernel.h"

namespace drape {
namespace {

bool runs_here(const Kernel& k) {
  if (&k == &kKernelPortable) return true;
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (&k == &kKernelAvx512)
    return avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq");
  return avx2;
}

constexpr const Kernel* kByChoice[] = {&kKernelAvx512, &kKernelAvx2, &kKernelPortable, &kKernelScalar};

}  // namespace

Workspace workspace_make(const System& system) {
  Workspace w;
  for (const Lattice& l : system.lattices) w.stride = std::max(w.stride, l.stride);
  w.rows.assign(kRowUnit + std::size_t(kScratchRows) * std::size_t(w.stride + kRowUnit), 0.0);
  for (Array* a : {&w.side_x, &w.side_y, &w.side_z}) a->assign(system.side.node.size(), 0.0);
  return w;
}

double velocity_lead(const System& system, const State& s) {
  if (system.integrator == Integrator::kPaper || s.h_old == 0) return 0;
  return s.h_old / (s.h_old + s.h_older);
}

void kernel_step(const Kernel& kernel, const System& system, const StepCoefficients& c, Workspace& w,
                 State& s) {
  const bool rates = system_has_rates(system);
  if (!system.side.node.empty())
    side_forces(system, s, rates, c.lead, {w.side_x.data(), w.side_y.data(), w.side_z.data()});
  for (const Lattice& l : system.lattices) (rates ? kernel.rates : kernel.plain).step(system, l, c, w, s);
}

void kernel_forces(const Kernel& kernel, const System& system, const State& s, Workspace& w, double* fx,
                   double* fy, double* fz) {
  const bool rates = system_has_rates(system);
  const double lead = velocity_lead(system, s);
  if (!system.side.node.empty())
    side_forces(system, s, rates, lead, {w.side_x.data(), w.side_y.data(), w.side_z.data()});
  for (const Lattice& l : system.lattices)
    (rates ? kernel.rates : kernel.plain).forces(system, l, s, lead, w, fx, fy, fz);
}

const Kernel* kernel_named(const char* name) {
  for (const Kernel* k : kByChoice)
    if (std::strcmp(k->name, name) == 0 && runs_here(*k)) return k;
  return nullptr;
}

const Kernel& kernel_pick() {
  if (const char* wanted = std::getenv("DRAPE_SIMD"))
    if (const Kernel* k = kernel_named(wanted)) return *k;
  for (const Kernel* k : kByChoice)
    if (runs_here(*k)) return *k;
  return kKernelPortable;
}

}  // namespace drape
