#include "laboratory/calibrate.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "fabric/material_law.h"
#include "laboratory/anderson.h"

namespace drape::laboratory {
namespace {

constexpr int kPlacingSweeps = 3;        // sweeps that move the points of the bias law
constexpr double kMinCorrection = 1e-3;  // smallest correction, as in the range of its key
constexpr model::YarnDirection kYarnDirections[] = {model::YarnDirection::kWarp, model::YarnDirection::kWeft,
                                                    model::YarnDirection::kBias};

scene::DiagramSpec& diagram_of(scene::FabricSpec& f, model::YarnDirection along) {
  return along == model::YarnDirection::kWarp   ? f.warp
         : along == model::YarnDirection::kWeft ? f.weft
                                                : f.bias;
}

bool switched_on(const scene::DiagramSpec& d) {
  return std::any_of(d.force.begin(), d.force.end(), [](double f) { return f > 0; });
}

std::string percent(double fraction) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g %%", 100 * fraction);
  return text;
}

// The initial corrections: 1 for warp and weft; for bias, those that give the law of a fabric without
// corrections.
void corrections_begin(scene::FabricSpec& f, std::vector<Problem>& problems) {
  const fabric::Law law = fabric::law_make(f, {}, 1, "fabric." + f.name, problems);
  for (model::YarnDirection along : kYarnDirections) {
    scene::DiagramSpec& d = diagram_of(f, along);
    d.correction.assign(d.force.size(), 1.0);
    if (along != model::YarnDirection::kBias) continue;
    if (f.bias.jaws) d.correction_elongation.assign(d.force.size(), 1.0);
    for (std::size_t i = 1; i < d.force.size(); ++i)
      if (d.force[i] > 0)
        d.correction[i] = math::curve_value(law.bias, d.elongation[i]) * f.strip_width / d.force[i];
  }
}

// Points beyond the last reached one take its correction. The origin takes that of the first point.
void corrections_end(std::vector<double>& q, std::size_t reached) {
  if (q.size() > 1) q[0] = q[1];
  for (std::size_t i = reached + 1; i < q.size(); ++i) q[i] = q[reached];
}

void warp_correct(scene::DiagramSpec& d, const StripPull& pull) {
  for (std::size_t k = 0; k < pull.force.size(); ++k)
    if (const double f = d.force[k + 1]; f > 0)
      d.correction[k + 1] = std::max(kMinCorrection, d.correction[k + 1] + (f - pull.force[k]) / f);
  corrections_end(d.correction, pull.force.size());
}

// Moves the points of the law to the leading strains of their strips.
void bias_place(const scene::FabricSpec& f, scene::DiagramSpec& d, const StripPull& pull) {
  std::vector<Problem> none;
  const math::Curve law = fabric::law_make(f, {}, 1, "", none).bias;
  for (std::size_t k = 0; k < pull.force.size(); ++k) {
    if (!(d.force[k + 1] > 0)) continue;
    d.correction_elongation[k + 1] = pull.strain[k] / d.elongation[k + 1];
    d.correction[k + 1] = math::curve_value(law, pull.strain[k]) * f.strip_width / d.force[k + 1];
  }
  corrections_end(d.correction_elongation, pull.force.size());
}

void bias_correct(Anderson& mixing, scene::DiagramSpec& d, const StripPull& pull) {
  const auto points = Eigen::Index(pull.force.size());
  Eigen::VectorXd x = Eigen::VectorXd::Zero(points), residual = x;
  for (Eigen::Index k = 0; k < points; ++k) {
    const auto i = std::size_t(k);
    if (!(d.force[i + 1] > 0)) continue;
    x[k] = std::log(d.correction[i + 1]);
    residual[k] = std::log(d.force[i + 1] / pull.force[i]);
  }
  const Eigen::VectorXd next = anderson_next(mixing, x, residual);
  for (Eigen::Index k = 0; k < points; ++k)
    if (d.force[std::size_t(k) + 1] > 0)
      d.correction[std::size_t(k) + 1] = std::max(kMinCorrection, std::exp(next[k]));
  corrections_end(d.correction, pull.force.size());
}

double max_difference(const scene::DiagramSpec& d, const StripPull& pull) {
  double largest = 0;
  for (std::size_t k = 0; k < pull.force.size(); ++k)
    if (const double f = d.force[k + 1]; f > 0) largest = std::max(largest, std::abs(pull.force[k] / f - 1));
  return largest;
}

// Empty, or the reason why these corrections give no valid law.
std::string law_problem(const scene::FabricSpec& f) {
  for (model::YarnDirection along : kYarnDirections) {
    const scene::DiagramSpec& d = strip_diagram(f, along);
    for (std::size_t i = 1; i < d.force.size(); ++i) {
      const std::string at = std::string(yarn_direction_name(along)) + " at " + percent(d.elongation[i]);
      if (d.correction[i] <= kMinCorrection)
        return "the " + at + " pulls no harder than the rest of the cloth in its strip";
      if (d.force[i] * d.correction[i] < d.force[i - 1] * d.correction[i - 1])
        return "the law of the " + at + " would fall; smooth its diagram";
    }
  }
  return "";
}

// One sweep: pulls all strips of `f` and corrects it. False, with the reason, where a strip has no
// equilibrium.
bool sweep(scene::FabricSpec& f, bool placing, Anderson& mixing, Calibration& c,
           std::vector<Problem>& problems) {
  scene::FabricSpec next = f;
  double residual = 0;
  for (model::YarnDirection along : kYarnDirections) {
    const scene::DiagramSpec& d = strip_diagram(f, along);
    if (!switched_on(d)) continue;
    const std::vector<double> elongation = strip_elongations(f, along, d.elongation.back());
    const StripPull pull = strip_pull(f, along, c.cell, elongation, problems);
    if (!problems.empty()) return false;
    if (pull.force.size() < elongation.size()) {
      c.why = law_problem(f);
      if (c.why.empty())
        c.why = std::string("the strip of the ") + yarn_direction_name(along) + " finds no rest at " +
                percent(elongation[pull.force.size()]);
      return false;
    }
    residual = std::max(residual, max_difference(d, pull));
    if (along != model::YarnDirection::kBias) warp_correct(diagram_of(next, along), pull);
    else {
      if (placing) bias_place(f, next.bias, pull), mixing = {};
      bias_correct(mixing, next.bias, pull);
    }
  }
  c.residuals.push_back(residual);
  c.fabric = f;
  f = std::move(next);
  return true;
}

}  // namespace

const char* yarn_direction_name(model::YarnDirection along) {
  return along == model::YarnDirection::kWarp   ? "warp"
         : along == model::YarnDirection::kWeft ? "weft"
                                                : "bias";
}

Calibration calibrate(const scene::FabricSpec& fabric, const CalibrationOptions& options,
                      std::vector<Problem>& problems) {
  Calibration c;
  c.cell = options.cell > 0 ? options.cell : fabric.strip_width / kStripCells;
  scene::FabricSpec f = fabric;
  const bool fresh = f.bias.correction.empty();
  if (fresh) corrections_begin(f, problems);
  for (scene::DiagramSpec* d : {&f.warp, &f.weft})
    if (d->correction.empty()) d->correction.assign(d->force.size(), 1.0);
  c.fabric = f;
  Anderson mixing;
  for (int k = 0; k < options.max_sweeps && problems.empty(); ++k) {
    if (!sweep(f, fresh && f.bias.jaws && k < kPlacingSweeps, mixing, c, problems)) return c;
    if (c.residuals.back() > options.tolerance) continue;
    c.why = law_problem(c.fabric);
    c.converged = c.why.empty();
    return c;
  }
  c.why = law_problem(c.fabric);
  if (c.why.empty()) c.why = "its sweeps do not settle";
  return c;
}

}  // namespace drape::laboratory
