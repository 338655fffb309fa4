#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "dynamics/kernel/processor.h"
#include "dynamics/kernel/row_blocks.h"
#include "forces/irregular_elements.h"

namespace drape::dynamics {
namespace {

bool runs_anywhere() { return true; }
// The kernels of this build, the fastest first. CMake says which there are.
struct Choice {
  const Kernel* kernel;
  bool (*runs_here)();
};
constexpr Choice kByChoice[] = {
#ifdef DRAPE_KERNEL_AVX512
    {&kKernelAvx512, processor_has_avx512},
#endif
#ifdef DRAPE_KERNEL_AVX2
    {&kKernelAvx2, processor_has_avx2},
#endif
    {&kKernelPortable, runs_anywhere},
#ifdef DRAPE_KERNEL_SCALAR
    {&kKernelScalar, processor_has_avx2},
#endif
};

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

void kernel_step(const Kernel& kernel, const System& system, const model::Scheme& c, Workspace& w, State& s) {
  pass_run_all(kernel, system, c, w, s, {&s, nullptr, nullptr, nullptr});
}

void kernel_forces(const Kernel& kernel, const System& system, const State& s, Workspace& w,
                   model::Field force) {
  model::Scheme c{};
  c.extrapolation = velocity_extrapolation(system, s);
  pass_run_all(kernel, system, c, w, s, {nullptr, force.x, force.y, force.z});
}

const Kernel* kernel_named(const char* name) {
  for (const Choice& choice : kByChoice)
    if (std::strcmp(choice.kernel->name, name) == 0 && choice.runs_here()) return choice.kernel;
  return nullptr;
}

const Kernel& kernel_pick() {
  if (const char* expected = std::getenv("DRAPE_SIMD"))
    if (const Kernel* k = kernel_named(expected)) return *k;
  for (const Choice& choice : kByChoice)
    if (choice.runs_here()) return *choice.kernel;
  return kKernelPortable;
}

}  // namespace drape::dynamics
