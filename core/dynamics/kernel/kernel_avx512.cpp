// The kernel of AVX-512, eight doubles.
#include "contact/particle/response.h"
#include "contact/self/response.h"
#include "dynamics/kernel/lattice_pass.h"
#include "dynamics/kernel/row_energy.h"
#include "dynamics/step_size/cell_bound.h"
#include "dynamics/step_size/cell_defect.h"
#include "forces/hinge_lanes.h"
#include "simd/lane_avx512.h"

namespace drape::dynamics {

const Kernel kKernelAvx512{"avx512",
                           block_pass<simd::Avx512Lane, false>,
                           block_pass<simd::Avx512Lane, true>,
                           cells_omega2<simd::Avx512Lane>,
                           cells_defect<simd::Avx512Lane>,
                           row_energy<simd::Avx512Lane>,
                           contact::contact_kernel<simd::Avx512Lane>(),
                           contact::self_contact_kernel<simd::Avx512Lane>(),
                           forces::hinges_bend<simd::Avx512Lane>};

}  // namespace drape::dynamics
