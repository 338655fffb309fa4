// AVX-512, eight doubles.
#include "contact/response.h"
#include "forces/hinge_lanes.h"
#include "forces/lane_avx512.h"
#include "motion/cell_bound.h"
#include "motion/lattice_pass.h"

namespace drape {

const Kernel kKernelAvx512{"avx512",
                           block_pass<Avx512Lane, false>,
                           block_pass<Avx512Lane, true>,
                           cells_omega2<Avx512Lane>,
                           contact_kernel<Avx512Lane>(),
                           hinges_bend<Avx512Lane>};

}  // namespace drape
