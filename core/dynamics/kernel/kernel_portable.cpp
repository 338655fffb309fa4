// The baseline instruction set.
#include "contact/particle/response.h"
#include "forces/hinge_lanes.h"
#include "simd/lane_scalar.h"
#include "dynamics/step_size/cell_bound.h"
#include "dynamics/kernel/lattice_pass.h"

namespace drape {

const Kernel kKernelPortable{"portable",
                             block_pass<ScalarLane<false>, false>,
                             block_pass<ScalarLane<false>, true>,
                             cells_omega2<ScalarLane<false>>,
                             contact_kernel<ScalarLane<false>>(),
                             hinges_bend<ScalarLane<false>>};

}  // namespace drape
