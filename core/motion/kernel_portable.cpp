// The baseline instruction set.
#include "forces/lane_scalar.h"
#include "motion/cell_bound.h"
#include "motion/lattice_pass.h"

namespace drape {

const Kernel kKernelPortable{"portable", kernel_step<ScalarLane<false>>, kernel_forces<ScalarLane<false>>,
                             kernel_omega2<ScalarLane<false>>};

}  // namespace drape
