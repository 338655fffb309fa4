// What this processor and its operating system can run. The compilers' __builtin_cpu_supports has a runtime
// library behind it, which on some targets answers no to everything.
#pragma once

namespace drape::dynamics {

bool processor_has_avx2();    // AVX2 and FMA
bool processor_has_avx512();  // these, and AVX-512 F, DQ and VL

}  // namespace drape::dynamics
