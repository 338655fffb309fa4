// Tuned values on their way to their targets: core/README.md, section 4, "Tuning".
#pragma once
#include "api/parameters.h"

namespace drape::api {

struct Ramp {
  ParameterValues from, to;     // where each value set out, and what has been committed
  std::vector<double> elapsed;  // [values] communication intervals since it set out
  std::vector<double> span;     // [values] of them for the whole way; 0: it is there
};

// All values are at their targets.
Ramp ramp_at(const ParameterValues& values);

bool ramp_under_way(const Ramp& ramp);

// New targets. What changes sets out from its present value for `span` intervals; with it, every value of its
// group, so that the points of a diagram move together. Group -1 jumps. The rest goes on as it was.
void ramp_set_target(Ramp& ramp, const ParameterValues& now, const ParameterValues& target, double span,
                     const std::vector<int>& group);

// `intervals` later (a number of communication intervals).
void ramp_advance(Ramp& ramp, double intervals);

// The values at present: from + (to - from) min(1, gone/span).
ParameterValues ramp_values(const Ramp& ramp);

}  // namespace drape::api
