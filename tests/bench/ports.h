// What the arithmetic ports of this core do in a second, lane by lane.
#pragma once

namespace drape::bench {

// Seconds that one operation on a lane takes where nothing waits for it.
struct Ports {
  const char* kernel;
  int width;  // doubles in a lane
  double fma, add, sqrt, division, load;
};
Ports ports_avx2();
Ports ports_avx512();

}  // namespace drape::bench
