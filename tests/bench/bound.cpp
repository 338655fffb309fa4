#include "bench/bound.h"

#include <algorithm>

namespace drape::bench {

double port_bound(const Operations& n, const Ports& p) {
  const double lane =
      std::max({n.fma * p.fma, n.add * p.add, n.sqrt * p.sqrt + n.division * p.division, n.load * p.load});
  return p.width / lane / 1e6;
}

}  // namespace drape::bench
