#include "simd/lane_avx2.h"

#include "bench/ports_lane.h"

namespace drape::bench {

Ports ports_avx2() { return ports_of<simd::Avx2Lane>("avx2"); }

}  // namespace drape::bench
