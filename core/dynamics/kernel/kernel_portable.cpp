// The kernel of the baseline instruction set.
#include "contact/particle/response.h"
#include "contact/self/response.h"
#include "dynamics/kernel/lattice_pass.h"
#include "dynamics/kernel/row_energy.h"
#include "dynamics/step_size/cell_bound.h"
#include "dynamics/step_size/cell_defect.h"
#include "forces/hinge_lanes.h"
#include "simd/lane_scalar.h"

namespace drape::dynamics {

const Kernel kKernelPortable{"portable",
                             block_pass<simd::ScalarLane<false>, false>,
                             block_pass<simd::ScalarLane<false>, true>,
                             cells_omega2<simd::ScalarLane<false>>,
                             cells_defect<simd::ScalarLane<false>>,
                             row_energy<simd::ScalarLane<false>>,
                             contact::contact_kernel<simd::ScalarLane<false>>(),
                             contact::self_contact_kernel<simd::ScalarLane<false>>(),
                             forces::hinges_bend<simd::ScalarLane<false>>};

}  // namespace drape::dynamics
