// Linear ramps of tuned values to their targets: core/README.md, section 4, "Tuning".
#pragma once
#include "api/parameters.h"

namespace drape::api {

struct Ramp {
  ParameterValues from, to;     // where each value started, and its committed target
  std::vector<double> elapsed;  // [values] communication intervals since the start
  std::vector<double> span;     // [values] length of the ramp in communication intervals; 0: target reached
};

// A ramp whose values are all at their targets.
Ramp ramp_at(const ParameterValues& values);

// True while a value has not reached its target.
bool ramp_under_way(const Ramp& ramp);

// Sets new targets. A value whose target changes starts from its present value and takes `span` intervals. So
// do all values of its group: the points of a diagram move together. Values of group -1 jump. All others
// continue as before.
void ramp_set_target(Ramp& ramp, const ParameterValues& now, const ParameterValues& target, double span,
                     const std::vector<int>& group);

// Advances the ramps by a number of communication intervals.
void ramp_advance(Ramp& ramp, double intervals);

// The present values: from + (to - from) min(1, elapsed/span).
ParameterValues ramp_values(const Ramp& ramp);

}  // namespace drape::api
