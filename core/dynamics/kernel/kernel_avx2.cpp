// AVX2 with FMA, four doubles; and the scalar yardstick with the same fused arithmetic.
#include "contact/particle/response.h"
#include "forces/hinge_lanes.h"
#include "simd/lane_avx2.h"
#include "simd/lane_scalar.h"
#include "dynamics/step_size/cell_bound.h"
#include "dynamics/kernel/lattice_pass.h"

namespace drape {

const Kernel kKernelAvx2{"avx2",
                         block_pass<Avx2Lane, false>,
                         block_pass<Avx2Lane, true>,
                         cells_omega2<Avx2Lane>,
                         contact_kernel<Avx2Lane>(),
                         hinges_bend<Avx2Lane>};
const Kernel kKernelScalar{"scalar",
                           block_pass<ScalarLane<true>, false>,
                           block_pass<ScalarLane<true>, true>,
                           cells_omega2<ScalarLane<true>>,
                           contact_kernel<ScalarLane<true>>(),
                           hinges_bend<ScalarLane<true>>};

}  // namespace drape
