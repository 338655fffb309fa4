// AVX-512, eight doubles.
#include "forces/lane_avx512.h"
#include "motion/cell_bound.h"
#include "motion/lattice_pass.h"

namespace drape {

const Kernel kKernelAvx512{"avx512", pass_of<Avx512Lane, false>(), pass_of<Avx512Lane, true>(),
                           cells_omega2<Avx512Lane>};

}  // namespace drape
