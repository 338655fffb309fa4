// The baseline instruction set.
#include "contact/response.h"
#include "forces/hinge_lanes.h"
#include "forces/lane_scalar.h"
#include "motion/cell_bound.h"
#include "motion/lattice_pass.h"

namespace drape {

const Kernel kKernelPortable{"portable",
                             block_pass<ScalarLane<false>, false>,
                             block_pass<ScalarLane<false>, true>,
                             cells_omega2<ScalarLane<false>>,
                             contact_kernel<ScalarLane<false>>(),
                             hinges_bend<ScalarLane<false>>};

}  // namespace drape
