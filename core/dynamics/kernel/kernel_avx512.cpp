// AVX-512, eight doubles.
#include "contact/particle/response.h"
#include "forces/hinge_lanes.h"
#include "simd/lane_avx512.h"
#include "dynamics/step_size/cell_bound.h"
#include "dynamics/kernel/lattice_pass.h"

namespace drape {

const Kernel kKernelAvx512{"avx512",
                           block_pass<Avx512Lane, false>,
                           block_pass<Avx512Lane, true>,
                           cells_omega2<Avx512Lane>,
                           contact_kernel<Avx512Lane>(),
                           hinges_bend<Avx512Lane>};

}  // namespace drape
