// The throughput of this core's arithmetic ports, for operations on a lane.
#pragma once

namespace drape::bench {

// Seconds that one operation on a lane takes where no other operation waits for it.
struct Ports {
  const char* kernel;
  int width;  // doubles in a lane
  double fma, add, sqrt, division, load;
};
Ports ports_avx2();
Ports ports_avx512();

}  // namespace drape::bench
