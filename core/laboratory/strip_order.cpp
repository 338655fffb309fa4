#include "laboratory/strip_order.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/bisection.h"

namespace drape::laboratory {

double order_of(const std::array<double, 3>& b, double first, double second) {
  constexpr double kLow = 1e-3, kHigh = 12;
  const auto ratio = [&](double p) {
    return (std::pow(b[0], p) - std::pow(b[1], p)) / (std::pow(b[1], p) - std::pow(b[2], p));
  };
  const double changed = first / second;
  if (!(changed > ratio(kLow) && changed < ratio(kHigh))) return std::numeric_limits<double>::quiet_NaN();
  return math::bisect_rising(ratio, changed, kLow, kHigh);
}

StripOrder strip_order(const scene::FabricSpec& f, double cell, const std::vector<double>& elongation,
                       std::vector<Problem>& problems) {
  StripOrder o;
  const double middle = strip_cell(f, model::YarnDirection::kBias, cell);
  o.cell = {strip_cell(f, model::YarnDirection::kBias, 2 * middle), middle,
            strip_cell(f, model::YarnDirection::kBias, middle / 2)};
  o.has_order = o.cell[0] <= std::min(f.strip_width, f.strip_gauge) / kMinCells;
  if (!o.has_order) return o;
  std::array<StripPull, 3> pull;
  for (std::size_t i = 0; i < 3; ++i) {
    pull[i] = strip_pull(f, model::YarnDirection::kBias, o.cell[i], elongation, problems);
    if (pull[i].force.size() == elongation.size()) continue;
    o.why = "the strip finds no rest";
    return o;
  }
  double change[2] = {0, 0};
  for (std::size_t k = 0; k < elongation.size(); ++k) {
    const double force = f.bias.force[k + 1];
    if (!(force > 0)) continue;
    for (std::size_t i = 0; i < 3; ++i) o.off[i] = std::max(o.off[i], std::abs(pull[i].force[k] / force - 1));
    for (std::size_t i = 0; i < 2; ++i)
      change[i] = std::max(change[i], std::abs(pull[i].force[k] - pull[i + 1].force[k]) / force);
  }
  o.order = order_of(o.cell, change[0], change[1]);
  return o;
}

}  // namespace drape::laboratory
