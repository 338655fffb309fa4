// The kernel with the fused arithmetic of AVX2, one double at a time: a slow reference for benchmark and
// tests.
#include "contact/particle/response.h"
#include "contact/self/response.h"
#include "dynamics/kernel/lattice_pass.h"
#include "dynamics/kernel/row_energy.h"
#include "dynamics/step_size/cell_bound.h"
#include "dynamics/step_size/cell_defect.h"
#include "forces/hinge_lanes.h"
#include "simd/lane_scalar.h"

namespace drape::dynamics {

const Kernel kKernelScalar{"scalar",
                           block_pass<simd::ScalarLane<true>, false>,
                           block_pass<simd::ScalarLane<true>, true>,
                           cells_omega2<simd::ScalarLane<true>>,
                           cells_defect<simd::ScalarLane<true>>,
                           row_energy<simd::ScalarLane<true>>,
                           contact::contact_kernel<simd::ScalarLane<true>>(),
                           contact::self_contact_kernel<simd::ScalarLane<true>>(),
                           forces::hinges_bend<simd::ScalarLane<true>>};

}  // namespace drape::dynamics
