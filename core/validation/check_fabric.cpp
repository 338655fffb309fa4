// Checks of diagrams as a whole.
#include <algorithm>

#include "scene/diagnostics.h"
#include "validation/checks.h"

namespace drape::validation {

namespace {

constexpr double kMinRise = 1e-8;  // smallest increase of the elongation from point to point
constexpr const char* kSmooth = ": `drape fabric smooth` makes a diagram of a tester's samples";
constexpr double kLocking = 0.41421;  // below sqrt(2) - 1, where the trellis of a bias strip locks

// Checks that the values of a diagram rise by `least` or more from point to point. A noisy list has one
// problem, not hundreds.
template <class Text>
void entries_check(const std::vector<double>& values, double least, const std::string& place,
                   const Text& text, const std::string& wanted, Problems& problems) {
  constexpr std::size_t kEach = 3;
  std::vector<std::size_t> found;
  for (std::size_t i = 1; i < values.size(); ++i)
    if (!(values[i] - values[i - 1] >= least)) found.push_back(i);
  const std::size_t told = found.size() > kEach ? 1 : found.size();
  for (std::size_t k = 0; k < told; ++k) {
    const std::size_t i = found[k];
    const std::string more =
        told < found.size() ? ", and so at " + std::to_string(found.size() - 1) + " more points" : "";
    problems.push_back(
        {scene::entry(place, i), "= " + text(values[i]) + " after " + text(values[i - 1]) + more + wanted});
  }
}

void diagram_check(const scene::DiagramSpec& d, const std::string& path, Problems& problems) {
  const scene::GivenAs &e_as = d.elongation_as, &f_as = d.force_as;
  const std::string elongation = path + "." + e_as.key, force = path + "." + f_as.key;
  const auto stretch = [&](double e) { return scene::rounded(e_as.per_si * e) + " " + e_as.unit; };
  const auto pull = [&](double f) {
    return (f_as.per_si == 1 ? scene::number_text(f) : scene::rounded(f_as.per_si * f)) + " " + f_as.unit;
  };
  const auto length_check = [&](const std::vector<double>& list, const std::string& name) {
    if (!list.empty() && !d.elongation.empty() && list.size() != d.elongation.size())
      problems.push_back({name, "has " + scene::entries_text(list.size()) + ", " + e_as.key + " has " +
                                    std::to_string(d.elongation.size()) + "; wanted: as many"});
  };
  if (!d.elongation.empty() && (d.elongation.size() < 2 || d.elongation.size() > 64))
    problems.push_back({elongation, "has " + scene::entries_text(d.elongation.size()) + "; allowed: 2 to 64" +
                                        (d.elongation.size() > 64 ? kSmooth : "")});
  length_check(d.force, force);
  length_check(d.correction, path + ".correction");
  length_check(d.correction_elongation, path + ".correction_elongation");

  if (!d.elongation.empty() && d.elongation[0] != 0)
    problems.push_back({scene::entry(elongation, 0),
                        "= " + stretch(d.elongation[0]) + "; a diagram starts at " + stretch(0)});
  if (!d.force.empty() && d.force[0] != 0)
    problems.push_back(
        {scene::entry(force, 0), "= " + pull(d.force[0]) + "; a diagram starts at " + pull(0) +
                                     ": subtract a pretension from all its forces, or let `drape "
                                     "fabric smooth` do so"});
  entries_check(d.elongation, kMinRise, elongation, stretch,
                "; wanted: a rise of at least " + stretch(kMinRise), problems);
  entries_check(d.force, 0, force, pull, std::string("; the force of a diagram does not fall") + kSmooth,
                problems);
  if (!d.correction_elongation.empty() && d.correction.empty())
    problems.push_back(
        {path + ".correction_elongation", "stands without correction; wanted: both or neither"});
  if (d.correction_elongation.size() == d.elongation.size())
    for (std::size_t i = 1; i < d.elongation.size(); ++i)
      if (const double law = d.elongation[i] * d.correction_elongation[i],
          last = d.elongation[i - 1] * d.correction_elongation[i - 1];
          !(law - last >= kMinRise) && d.elongation[i] - d.elongation[i - 1] >= kMinRise)
        problems.push_back({scene::entry(path + ".correction_elongation", i),
                            "= " + scene::number_text(d.correction_elongation[i]) + " gives " + stretch(law) +
                                " after " + stretch(last) +
                                "; wanted: elongation x correction_elongation rises"});
  if (d.correction.size() != d.force.size()) return;
  for (std::size_t i = 1; i < d.force.size(); ++i)
    if (const double law = d.force[i] * d.correction[i], last = d.force[i - 1] * d.correction[i - 1];
        law < last && d.force[i] >= d.force[i - 1])
      problems.push_back({scene::entry(path + ".correction", i),
                          "= " + scene::number_text(d.correction[i]) + " gives " + scene::rounded(law) +
                              " N after " + scene::rounded(last) + " N; force x correction does not fall"});
}

// Checks a bias diagram without a stored correction. Its law is computed from the geometry of the strip,
// which has limits of its own.
void bias_check(const Scene& scene, const scene::FabricSpec& f, const std::string& path, Problems& problems) {
  const std::vector<double>& force = f.bias.force;
  const bool off = std::all_of(force.begin(), force.end(), [](double v) { return v == 0; });
  if (off || !f.bias.correction.empty()) return;
  const double ratio = f.strip_gauge / f.strip_width;
  if (scene.clamp_correction && f.bias.jaws && !(ratio > 1.25))
    problems.push_back(
        {path + ".strip", "has gauge/width = " + scene::rounded(ratio) +
                              "; the clamp correction of a bias diagram takes values above 1.25 (or say "
                              "bias.jaws = false of a diagram without jaws)"});
  if (scene.bias_model != scene::BiasModel::kOdd || f.bias.elongation.size() < 2 ||
      !(f.bias.elongation[1] > kLocking))
    return;
  const scene::GivenAs& as = f.bias.elongation_as;
  const std::string percent = scene::rounded(100 * f.bias.elongation[1]) + " percent";
  const std::string given =
      as.per_si == 100 ? percent
                       : scene::rounded(as.per_si * f.bias.elongation[1]) + " " + as.unit + ", " + percent;
  problems.push_back(
      {scene::entry(path + ".bias." + as.key, 1),
       "= " + given +
           "; bias_model \"odd\" takes at least one point above 0 and below 41.42 percent, where the threads "
           "of a strip lie along the pull"});
}

}  // namespace

void fabric_check(const Scene& scene, const scene::FabricSpec& f, Problems& problems) {
  const std::string path = "fabric." + f.name;
  diagram_check(f.warp, path + ".warp", problems);
  diagram_check(f.weft, path + ".weft", problems);
  diagram_check(f.bias, path + ".bias", problems);
  bias_check(scene, f, path, problems);
  if (f.friction[1] > f.friction[0])
    problems.push_back({scene::entry(path + ".friction", 1),
                        "= " + scene::number_text(f.friction[1]) + " is more than the static coefficient, " +
                            scene::number_text(f.friction[0]) + "; allowed: at most as much"});
}

}  // namespace drape::validation
