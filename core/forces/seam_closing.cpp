#include "forces/seam_closing.h"

#include <algorithm>
#include <cmath>

#include "model/node_sums.h"

namespace drape::forces {

using namespace math::vector3;

double seam_mass(const System& system, const model::SeamPair& pair) {
  const model::NodeSum& row = pair.gap;
  double sum = 0;
  for (const model::NodeTerm& t : row) sum += t.weight * t.weight * system.inverse_mass[t.node];
  return sum > 0 ? 1 / sum : 0;
}

Vec3 seam_closing_force(const System& system, const model::Seam& seam, std::size_t p, const State& s,
                        double extrapolation) {
  if (s.sewn[p] != model::Sewn::kPulled) return {0, 0, 0};
  const model::SeamPair& pair = system.seams.pair[p];
  const Vec3 gap = model::sum_value(pair.gap, s), now = model::sum_value(pair.gap, s.vx, s.vy, s.vz);
  const double* before = &s.gap_rate[3 * p];
  const double w = seam.pull, length = norm(gap);
  if (length == 0 || w == 0) return {0, 0, 0};
  const Vec3 rate = now + extrapolation * (now - Vec3{before[0], before[1], before[2]});
  const double integral = s.closing_integral[p] * length / std::hypot(length, seam.gap_tolerance);
  const double spring = w * w * (std::min(length, 2 * seam.speed / w) + integral),
               damping = 2 * w * dot(rate, gap) / length;
  return (-seam_mass(system, pair) * (spring + damping) / length) * gap;
}

void seams_closing_forces(const System& system, const State& s, double extrapolation, model::SlotForces to) {
  for (const model::Seam& seam : system.seams.seam)
    for (std::size_t p = seam.first; p < seam.first + seam.count; ++p)
      if (s.sewn[p] == model::Sewn::kPulled)
        model::sum_force(system.seams.pair[p].gap, seam_closing_force(system, seam, p, s, extrapolation), to);
}

double seams_integral_bound(const System& system, const State& s) {
  double largest = 0;
  for (const model::Seam& seam : system.seams.seam)
    for (std::size_t p = seam.first; p < seam.first + seam.count; ++p)
      if (s.sewn[p] == model::Sewn::kPulled)
        largest = std::max(largest, s.closing_integral[p] / seam.gap_tolerance);
  return largest;
}

void seams_update_integral(const System& system, State& s, double h) {
  constexpr double kWait = 20, kStalled = 0.1, kMax = 2000;
  for (const model::Seam& seam : system.seams.seam) {
    const double w = seam.pull, reach = 2 * seam.speed / w;
    for (std::size_t p = seam.first; p < seam.first + seam.count; ++p) {
      if (s.sewn[p] != model::Sewn::kPulled) continue;
      s.closing_time[p] += h;
      if (s.closing_time[p] * w < kWait) continue;
      const model::NodeSum& row = system.seams.pair[p].gap;
      const Vec3 rate = model::sum_value(row, s.vx, s.vy, s.vz),
                 gap = model::sum_value(row, s) - (h / 2) * rate;
      const double length = norm(gap), closing = -dot(rate, gap);
      if (closing < kStalled * length * std::min(w * length, 2 * seam.speed))
        s.closing_integral[p] =
            std::min(s.closing_integral[p] + h * w * std::min(length, reach), kMax * reach);
    }
  }
}

bool seams_any_pulled(const State& s) {
  return std::find(s.sewn.begin(), s.sewn.end(), model::Sewn::kPulled) != s.sewn.end();
}

void seams_gap_rates(const System& system, const State& s, Array& rates) {
  rates.resize(3 * system.seams.pair.size());
  for (std::size_t p = 0; p < system.seams.pair.size(); ++p) {
    const bool pulled = s.sewn[p] == model::Sewn::kPulled;  // no other rate is ever read
    const Vec3 rate = pulled ? model::sum_value(system.seams.pair[p].gap, s.vx, s.vy, s.vz) : Vec3{0, 0, 0};
    std::copy(rate.begin(), rate.end(), &rates[3 * p]);
  }
}

}  // namespace drape::forces
