#include <algorithm>
#include <cstdlib>
#include <cstring>

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
  return w;
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
