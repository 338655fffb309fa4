#include "bench/bound.h"

#include <algorithm>

namespace drape::bench {

double port_bound(const Operations& operations, const Ports& ports) {
  const double lane = std::max({operations.fma * ports.fma, operations.add * ports.add,
                                operations.sqrt * ports.sqrt + operations.division * ports.division,
                                operations.load * ports.load});
  return ports.width / lane / 1e6;
}

}  // namespace drape::bench
