#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "dynamics/kernel/row_blocks.h"
#include "forces/irregular_elements.h"

namespace drape::dynamics {
namespace {

bool runs_here(const Kernel& k) {
  if (&k == &kKernelPortable) return true;
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (&k == &kKernelAvx512)
    return avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq");
  return avx2;
}

constexpr const Kernel* kByChoice[] = {&kKernelAvx512, &kKernelAvx2, &kKernelPortable, &kKernelScalar};

void pass_run_all(const Kernel& kernel, const System& system, const model::Scheme& c, Workspace& w,
                  const State& s, const PassTarget& to) {
  const bool rates = model::system_has_rates(system);
  if (!system.irregular.node.empty())
    forces::irregular_forces(system, s, rates, c.extrapolation, kernel.hinges,
                             {w.slot_x.data(), w.slot_y.data(), w.slot_z.data()});
  blocks_copy(system, s, w);
  struct Task {
    const System& system;
    const model::Scheme& c;
    Workspace& w;
    const State& s;
    const PassTarget& to;
    LatticePass pass;
  } task{system, c, w, s, to, rates ? kernel.rates : kernel.plain};
  const auto run = [](void* context, int k) {
    const Task& t = *static_cast<Task*>(context);
    ThreadWorkspace& workspace = t.w.threads[std::size_t(k)];
    for (const RowBlock& block : workspace.blocks)
      t.pass(t.system, block, t.c, t.w, workspace.rows.data(), t.s, t.to);
  };
  if (w.workers) return workers_run(*w.workers, run, &task);
  for (int k = 0; k < int(w.threads.size()); ++k) run(&task, k);
}

}  // namespace

double velocity_extrapolation(const System& system, const State& s) {
  if (system.integrator == scene::Integrator::kPaper || s.h_old == 0) return 0;
  return s.h_old / (s.h_old + s.h_older);
}

void kernel_step(const Kernel& kernel, const System& system, const model::Scheme& c, Workspace& w,
                 State& s) {
  pass_run_all(kernel, system, c, w, s, {&s, nullptr, nullptr, nullptr});
}

void kernel_forces(const Kernel& kernel, const System& system, const State& s, Workspace& w,
                   model::Field force) {
  model::Scheme c{};
  c.extrapolation = velocity_extrapolation(system, s);
  pass_run_all(kernel, system, c, w, s, {nullptr, force.x, force.y, force.z});
}

const Kernel* kernel_named(const char* name) {
  for (const Kernel* k : kByChoice)
    if (std::strcmp(k->name, name) == 0 && runs_here(*k)) return k;
  return nullptr;
}

const Kernel& kernel_pick() {
  if (const char* expected = std::getenv("DRAPE_SIMD"))
    if (const Kernel* k = kernel_named(expected)) return *k;
  for (const Kernel* k : kByChoice)
    if (runs_here(*k)) return *k;
  return kKernelPortable;
}

}  // namespace drape::dynamics
