// Equations: core/README.md, section 3, "Laws per width".
#include "reference/law.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace drape::reference {
namespace {

const double kRoot2 = std::numbers::sqrt2;

bool switched_on(const scene::DiagramSpec& d) {
  return std::any_of(d.force.begin(), d.force.end(), [](double f) { return f != 0; });
}

// P_i = z F_i / (K w_p): the diagram as force per width.
std::vector<double> per_width(const scene::DiagramSpec& d, double z, double K, double strip_width) {
  std::vector<double> P;
  for (double F : d.force) P.push_back(z * F / (K * strip_width));
  return P;
}

// P_i q_i with the stored correction q; 1 where there is none.
std::vector<double> corrected(std::vector<double> P, const scene::DiagramSpec& d) {
  for (std::size_t i = 0; i < d.correction.size(); ++i) P[i] *= d.correction[i];
  return P;
}

// e_i c_i with the stored correction of elongations c; 1 where there is none.
std::vector<double> elongations(const scene::DiagramSpec& d) {
  std::vector<double> e = d.elongation;
  for (std::size_t i = 0; i < d.correction_elongation.size(); ++i) e[i] *= d.correction_elongation[i];
  return e;
}

// The diagram without its stored corrections where the scene has other than the default laws: they belong to
// those.
scene::DiagramSpec used(const Scene& scene, scene::DiagramSpec d) {
  if (scene.bias_model != scene::BiasModel::kOdd || scene.scaling != scene::Scaling::kWidth)
    d.correction.clear(), d.correction_elongation.clear();
  return d;
}

}  // namespace

Law yarn_law(const Scene& scene, const scene::FabricSpec& fabric, const scene::DiagramSpec& diagram,
             double b) {
  const scene::DiagramSpec d = used(scene, diagram);
  if (!switched_on(d)) return {Curve{}, std::numeric_limits<double>::infinity()};
  const double z = scene.scaling == scene::Scaling::kPaperArea ? b / fabric.strip_gauge : 1;
  const std::vector<double> P = corrected(per_width(d, z, 1, fabric.strip_width), d);
  const std::vector<double> e = elongations(d);
  return {curve_make(e, P, Below::kCompression, fabric.compression, fabric.compression_blend), e.back()};
}

namespace {

// K = r (r - 1.25)/(r - 1)^2, r = gauge/width: the factor by which jaws stiffen a strip cut at 45 degrees.
double clamp_stiffening(const scene::FabricSpec& fabric) {
  const double r = fabric.strip_gauge / fabric.strip_width;
  return r * (r - 1.25) / ((r - 1) * (r - 1));
}

}  // namespace

Law bias_law(const Scene& scene, const scene::FabricSpec& fabric, double b) {
  const scene::DiagramSpec d = used(scene, fabric.bias);
  if (!switched_on(d)) return {Curve{}, std::numeric_limits<double>::infinity()};
  const double z = scene.scaling == scene::Scaling::kPaperArea ? kRoot2 * b / fabric.strip_gauge : 1;
  const bool stored = !d.correction.empty();
  const bool held = scene.clamp_correction && d.jaws;
  const double K = held && !stored ? clamp_stiffening(fabric) : 1;
  const std::vector<double> P = per_width(d, z, K, fabric.strip_width);
  const std::vector<double> e = elongations(d);
  const double end = e.back();
  if (scene.bias_model == scene::BiasModel::kTension) {
    return {curve_make(e, corrected(P, d), Below::kCompression, 0, fabric.compression_blend), end};
  }
  if (scene.bias_model == scene::BiasModel::kPaper) {
    return {curve_make(e, corrected(P, d), Below::kCompression, fabric.compression, fabric.compression_blend),
            end};
  }
  if (!stored) return {odd_law(e, P), end};
  const std::vector<double> kept = below_locking(e);
  std::vector<double> g = corrected(P, d);
  g.resize(kept.size());
  return {curve_make(kept, g, Below::kOdd), end};
}

}  // namespace drape::reference
