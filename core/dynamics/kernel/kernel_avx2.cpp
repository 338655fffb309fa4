// The kernel of AVX2 with FMA, four doubles.
#include "contact/particle/response.h"
#include "contact/self/response.h"
#include "dynamics/kernel/lattice_pass.h"
#include "dynamics/kernel/row_energy.h"
#include "dynamics/step_size/cell_bound.h"
#include "dynamics/step_size/cell_defect.h"
#include "forces/hinge_lanes.h"
#include "simd/lane_avx2.h"

namespace drape::dynamics {

const Kernel kKernelAvx2{"avx2",
                         block_pass<simd::Avx2Lane, false>,
                         block_pass<simd::Avx2Lane, true>,
                         cells_omega2<simd::Avx2Lane>,
                         cells_defect<simd::Avx2Lane>,
                         row_energy<simd::Avx2Lane>,
                         contact::contact_kernel<simd::Avx2Lane>(),
                         contact::self_contact_kernel<simd::Avx2Lane>(),
                         forces::hinges_bend<simd::Avx2Lane>};

}  // namespace drape::dynamics
