#include "simd/lane_avx512.h"

#include "bench/ports_lane.h"

namespace drape::bench {

Ports ports_avx512() { return ports_of<simd::Avx512Lane>("avx512"); }

}  // namespace drape::bench
