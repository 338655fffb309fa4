// AVX-512, eight doubles.
#include "forces/lane_avx512.h"
#include "motion/cell_bound.h"
#include "motion/lattice_pass.h"

namespace drape {

const Kernel kKernelAvx512{"avx512", kernel_step<Avx512Lane>, kernel_forces<Avx512Lane>,
                           kernel_omega2<Avx512Lane>};

}  // namespace drape
