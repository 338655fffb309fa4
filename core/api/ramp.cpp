#include "api/ramp.h"

#include <algorithm>

namespace drape::api {

Ramp ramp_at(const ParameterValues& values) {
  const std::vector<double> none(values.value.size(), 0.0);
  return {values, values, none, none};
}

bool ramp_under_way(const Ramp& ramp) {
  return std::any_of(ramp.span.begin(), ramp.span.end(), [](double span) { return span > 0; });
}

void ramp_set_target(Ramp& ramp, const ParameterValues& now, const ParameterValues& target, double span,
                     const std::vector<int>& group) {
  std::vector<bool> changed(std::size_t(1 + *std::max_element(group.begin(), group.end())), false);
  for (std::size_t k = 0; k < group.size(); ++k)
    if (group[k] >= 0 && target.value[k] != ramp.to.value[k]) changed[std::size_t(group[k])] = true;
  for (std::size_t k = 0; k < group.size(); ++k) {
    if (group[k] >= 0 && !changed[std::size_t(group[k])]) continue;
    ramp.from.value[k] = now.value[k];
    ramp.elapsed[k] = 0;
    ramp.span[k] = group[k] >= 0 && now.value[k] != target.value[k] ? span : 0;
  }
  ramp.to = target;
}

void ramp_advance(Ramp& ramp, double intervals) {
  for (std::size_t k = 0; k < ramp.span.size(); ++k) {
    if (ramp.span[k] == 0) continue;
    ramp.elapsed[k] += intervals;
    if (ramp.elapsed[k] >= ramp.span[k] * (1 - 1e-12)) ramp.span[k] = 0;  // T/q is a rounded quotient
  }
}

ParameterValues ramp_values(const Ramp& ramp) {
  ParameterValues values = ramp.to;
  for (std::size_t k = 0; k < ramp.span.size(); ++k)
    if (ramp.span[k] > 0)
      values.value[k] =
          ramp.from.value[k] + (ramp.to.value[k] - ramp.from.value[k]) * (ramp.elapsed[k] / ramp.span[k]);
  return values;
}

}  // namespace drape::api
