#include "fabric/material_law.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drape::fabric {
namespace {

// The locking strain of a trellis, where its yarns touch: 1 + L = sqrt(2), less a margin that keeps l2 above
// 0.
const double kLocked = std::numbers::sqrt2 - 1 - 1e-6;

std::vector<double> below_locking(std::vector<double> e) {
  e.erase(std::lower_bound(e.begin(), e.end(), kLocked), e.end());
  return e;
}

// Elongations of the law's points: those of the diagram times the corrections that a calibration has stored.
std::vector<double> law_elongations(const scene::DiagramSpec& diagram) {
  std::vector<double> e(diagram.elongation);
  for (std::size_t i = 0; i < diagram.correction_elongation.size(); ++i)
    e[i] *= diagram.correction_elongation[i];
  return e;
}

// Forces per width (N/m) at the points of a diagram, including the origin.
std::vector<double> per_width(const scene::DiagramSpec& diagram, double strip_width, double factor) {
  std::vector<double> f(diagram.force);
  for (std::size_t i = 0; i < f.size(); ++i) {
    f[i] *= factor / strip_width;
    if (!diagram.correction.empty()) f[i] *= diagram.correction[i];
  }
  return f;
}

// The jaw factor K. Jaws keep the ends of a 45 degree strip square, so its force is K times that of the free
// trellis; r = gauge/width.
double jaw_factor(double r) { return r * (r - 1.25) / ((r - 1) * (r - 1)); }

// The odd law. Both diagonals of a trellis of inextensible yarns carry force, the short one in compression:
//
//   g(L) + g(|e2|) l1/l2 = P(L),   l1 = 1 + L,   l2 = sqrt(2 - l1^2),   e2 = l2 - 1
//
// at every point L of the diagram. The unknowns are the values g at the points; between them g is the curve
// through them. The fixed-point iteration adds a share of the residual. Near 0 the left side is 2 g, so it
// converges there in one sweep with a half; at 7 % of elongation each sweep reduces the error to about 1/3.
// Diagrams of many points may need a smaller share.
//
// A law never decreases. After a slack toe the short diagonal alone would exceed P; there g stays constant.
math::Curve odd_law_iterate(const std::vector<double>& e, const std::vector<double>& p, double share,
                            bool& converged) {
  const std::size_t n = e.size();
  std::vector<double> g(n), next(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) g[i] = p[i] / 2;

  const math::Continuation odd{.odd = true};
  math::Curve curve = math::curve_make(e, g, odd);
  converged = curve.segments == 0;
  for (int sweep = 0; sweep < 1000 && !converged; ++sweep) {
    double change = 0;
    for (std::size_t i = 1; i < n; ++i) {
      const double l1 = 1 + e[i], l2 = std::sqrt(2 - l1 * l1);
      next[i] =
          std::max(next[i - 1], g[i] + share * (p[i] - g[i] - math::curve_value(curve, 1 - l2) * l1 / l2));
      change = std::max(change, std::abs(next[i] - g[i]));
    }
    g = next;
    curve = math::curve_make(e, g, odd);
    converged = change <= 1e-14 * p[n - 1];
  }
  return curve;
}

constexpr double kSmallestShare = 1.0 / 32;

math::Curve odd_law(std::vector<double> e, const std::vector<double>& p, bool& converged) {
  e = below_locking(std::move(e));
  converged = false;
  math::Curve curve;
  for (double share = 0.5; !converged && share >= kSmallestShare; share /= 2)
    curve = odd_law_iterate(e, p, share, converged);
  return curve;
}

math::Curve bias_law(const scene::FabricSpec& fabric, const LawOptions& options, double cell,
                     const std::string& place, std::vector<Problem>& problems) {
  const double scale =
      options.scaling == scene::Scaling::kPaperArea ? std::numbers::sqrt2 * cell / fabric.strip_gauge : 1.0;
  const bool corrected = !fabric.bias.correction.empty();
  const double k =
      law_corrects_for_jaws(fabric, options) ? jaw_factor(fabric.strip_gauge / fabric.strip_width) : 1.0;
  const std::vector<double> e = law_elongations(fabric.bias),
                            p = per_width(fabric.bias, fabric.strip_width, scale / k);
  switch (options.bias_model) {
    case scene::BiasModel::kTension:
      return math::curve_make(e, p, {.compression = 0, .blend = fabric.compression_blend});
    case scene::BiasModel::kPaper:
      return math::curve_make(e, p, {.compression = fabric.compression, .blend = fabric.compression_blend});
    case scene::BiasModel::kOdd:
      break;
  }
  if (e.size() > 1 && e[1] >= kLocked) {
    problems.push_back(
        {place + ".bias", "its first elongation after 0 is past the trellis' locking at 41.4 percent"});
    return {};
  }
  if (corrected) return math::curve_make(below_locking(e), p, {.odd = true});
  bool converged = false;
  math::Curve curve = odd_law(e, p, converged);
  if (!converged)
    problems.push_back(
        {place + ".bias",
         "has no odd law: g(L) + g(|e2|) l1/l2 = P(L) finds no rest in 1000 sweeps; wanted: a diagram whose "
         "points begin nearer to 0 percent and whose last ones, towards 41.4 percent, rise more gently, or "
         "end earlier"});
  return curve;
}

}  // namespace

namespace {

// Drops the corrections of a calibration unless the options are those that it was made with.
scene::FabricSpec with_valid_corrections(scene::FabricSpec fabric, const LawOptions& options) {
  if (options.bias_model == scene::BiasModel::kOdd && options.scaling == scene::Scaling::kWidth)
    return fabric;
  for (scene::DiagramSpec* d : {&fabric.warp, &fabric.weft, &fabric.bias})
    d->correction.clear(), d->correction_elongation.clear();
  return fabric;
}

}  // namespace

bool law_corrects_for_jaws(const scene::FabricSpec& f, const LawOptions& options) {
  return options.clamp_correction && f.bias.jaws && f.bias.correction.empty();
}

Law law_make(const scene::FabricSpec& stated, const LawOptions& options, double cell,
             const std::string& place, std::vector<Problem>& problems) {
  const scene::FabricSpec fabric = with_valid_corrections(stated, options);
  const double scale = options.scaling == scene::Scaling::kPaperArea ? cell / fabric.strip_gauge : 1.0;
  const math::Continuation below{.compression = fabric.compression, .blend = fabric.compression_blend};
  const double plate = 1 / (1 - fabric.poisson * fabric.poisson);
  Law law;
  law.areal_density = fabric.areal_density;
  law.warp = math::curve_make(law_elongations(fabric.warp), per_width(fabric.warp, fabric.strip_width, scale),
                              below);
  law.weft = math::curve_make(law_elongations(fabric.weft), per_width(fabric.weft, fabric.strip_width, scale),
                              below);
  law.bias = bias_law(fabric, options, cell, place, problems);
  law.bending_warp = fabric.bending_warp * plate;
  law.bending_weft = fabric.bending_weft * plate;
  law.damping = fabric.damping;
  return law;
}

}  // namespace drape::fabric
