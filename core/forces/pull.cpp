#include "forces/pull.h"

#include <algorithm>
#include <cmath>

#include "constraint/vector3.h"

namespace drape {

using namespace vector3;

double seam_mass(const System& system, const SeamPair& pair) {
  double sum = 0;
  for (int k = 0; k < pair.count; ++k)
    sum += pair.weight[k] * pair.weight[k] * system.inverse_mass[pair.node[k]];
  return sum > 0 ? 1 / sum : 0;
}

Vec3 seam_gap(const SeamPair& pair, const Array& x, const Array& y, const Array& z) {
  Vec3 gap{0, 0, 0};
  for (int k = 0; k < pair.count; ++k)
    gap += pair.weight[k] * Vec3{x[pair.node[k]], y[pair.node[k]], z[pair.node[k]]};
  return gap;
}

Vec3 seam_pull(const System& system, const Seam& seam, std::size_t p, const State& s, double lead) {
  if (s.sewn[p] != Sewn::kPulled) return {0, 0, 0};
  const SeamPair& pair = system.seams.pair[p];
  const Vec3 gap = seam_gap(pair, s.x, s.y, s.z), now = seam_gap(pair, s.vx, s.vy, s.vz);
  const double* before = &s.gap_rate[3 * p];
  const double w = seam.pull, length = norm(gap);
  if (length == 0) return {0, 0, 0};
  const Vec3 rate = now + lead * (now - Vec3{before[0], before[1], before[2]});
  const double spring = w * w * std::min(length, 2 * seam.speed / w),
               damping = 2 * w * dot(rate, gap) / length;
  return (-seam_mass(system, pair) * (spring + damping) / length) * gap;
}

void seams_pull(const System& system, const State& s, double lead, SideForces to) {
  for (const Seam& seam : system.seams.seam)
    for (auto p = std::size_t(seam.first); p < std::size_t(seam.first + seam.count); ++p) {
      if (s.sewn[p] != Sewn::kPulled) continue;
      const SeamPair& pair = system.seams.pair[p];
      const Vec3 pull = seam_pull(system, seam, p, s, lead);
      for (int k = 0; k < pair.count; ++k) {
        const auto slot = std::size_t(pair.slot[k]);
        to.x[slot] += pair.weight[k] * pull[0];
        to.y[slot] += pair.weight[k] * pull[1];
        to.z[slot] += pair.weight[k] * pull[2];
      }
    }
}

void seams_rates(const System& system, const State& s, Array& rates) {
  rates.resize(3 * system.seams.pair.size());
  for (std::size_t p = 0; p < system.seams.pair.size(); ++p) {
    const Vec3 rate = seam_gap(system.seams.pair[p], s.vx, s.vy, s.vz);
    std::copy(rate.begin(), rate.end(), &rates[3 * p]);
  }
}

}  // namespace drape
