// AVX2 with FMA, four doubles; and the scalar yardstick with the same fused arithmetic.
#include "forces/lane_avx2.h"
#include "forces/lane_scalar.h"
#include "motion/cell_bound.h"
#include "motion/lattice_pass.h"

namespace drape {

const Kernel kKernelAvx2{"avx2", kernel_step<Avx2Lane>, kernel_forces<Avx2Lane>, kernel_omega2<Avx2Lane>};
const Kernel kKernelScalar{"scalar", kernel_step<ScalarLane<true>>, kernel_forces<ScalarLane<true>>,
                           kernel_omega2<ScalarLane<true>>};

}  // namespace drape
