#include "laboratory/smooth.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "laboratory/monotone_fit.h"
#include "math/monotone_curve.h"
#include "scene/limits.h"

namespace drape::laboratory {
namespace {

constexpr double kMinRise = 1e-8;  // of the elongation, from point to point of a diagram

// The points of a diagram, as far as samples are one: from (0, 0), rising, not too many.
bool is_diagram(const Samples& s) {
  if (s.elongation.size() < 2 || s.elongation.size() > math::kCurvePoints) return false;
  if (s.elongation[0] != 0 || s.force[0] != 0) return false;
  for (std::size_t i = 1; i < s.elongation.size(); ++i)
    if (s.elongation[i] - s.elongation[i - 1] < kMinRise || s.force[i] < s.force[i - 1] || s.count[i] > 1)
      return false;
  return s.count[0] == 1;
}

void force_subtract(Samples& s, double force) {
  for (double& f : s.force) f -= force;
}

// A number as it will stand in the file: six digits of its unit.
double as_written(double value, double per_si) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value * per_si);
  return std::strtod(text, nullptr) / per_si;
}

void points_put(scene::DiagramSpec& to, const std::vector<double>& elongation,
                const std::vector<double>& force) {
  to.elongation.clear(), to.force.clear();
  for (std::size_t i = 0; i < elongation.size(); ++i) {
    to.elongation.push_back(as_written(elongation[i], to.elongation_as.per_si));
    to.force.push_back(as_written(force[i], to.force_as.per_si));
  }
}

// `count` points of the fit at equal distances.
void points_of_fit(const MonotoneFit& fit, int count, scene::DiagramSpec& to) {
  std::vector<double> e, f;
  for (int k = 0; k < count; ++k) {
    e.push_back(as_written(fit.length * k / (count - 1), to.elongation_as.per_si));
    f.push_back(fit_value(fit, e.back()));
  }
  points_put(to, e, f);
}

// The fewest points whose interpolant stays near the fit and whose slope travels no farther. The deviation,
// a fifth of the resolution, adds 2 % to the residual.
void points_choose(const MonotoneFit& fit, const Samples& s, double resolution, scene::DiagramSpec& to) {
  constexpr int kFewest = 8;
  constexpr double kDeviation = 0.2, kLargest = 0.5, kPath = 0.1;
  std::vector<double> value;
  for (const double e : s.elongation) value.push_back(fit_value(fit, e));
  const double path = fit_slope_path(fit) + kPath;
  for (int count = kFewest; count <= math::kCurvePoints; ++count) {
    points_of_fit(fit, count, to);
    if (count == math::kCurvePoints || math::slope_path(to.elongation, to.force) > path) continue;
    const math::Curve curve = math::curve_make(to.elongation, to.force, {});
    double square = 0, largest = 0;
    for (std::size_t i = 0; i < value.size(); ++i) {
      const double off = std::abs(math::curve_value(curve, s.elongation[i]) - value[i]);
      square += s.count[i] * off * off;
      largest = std::max(largest, off);
    }
    if (std::sqrt(square / samples_total(s)) <= kDeviation * resolution && largest <= kLargest * resolution)
      return;
  }
}

void residual_set(SmoothedDiagram& d, const Samples& s) {
  const math::Curve curve = math::curve_make(d.diagram.elongation, d.diagram.force, {});
  double square = samples_square(s);
  for (std::size_t i = 0; i < s.elongation.size(); ++i) {
    const double off = std::abs(math::curve_value(curve, s.elongation[i]) - s.force[i]);
    square += s.count[i] * off * off;
    d.largest = std::max(d.largest, off);
  }
  d.rms = std::sqrt(square / samples_total(s));
  d.path_after = math::slope_path(d.diagram.elongation, d.diagram.force);
}

// Finishes samples that are a smooth diagram but for a pretension and a slack without any force.
bool finish_smooth(SmoothedDiagram& d, Samples s) {
  if (s.elongation[0] != 0) return false;
  const double pretension = s.force[0];
  force_subtract(s, pretension);
  const double slack = samples_slack(s, 0).end;
  s = samples_from(s, slack);
  if (!is_diagram(s)) return false;
  const double path = math::slope_path(s.elongation, s.force);
  if (path > kSmoothPath) return false;
  d.pretension = pretension;
  d.slack = slack;
  d.is_smooth = pretension == 0 && slack == 0 && !d.record.reordered && d.record.after_break == 0 &&
                d.record.below_zero == 0;
  if (!d.is_smooth) points_put(d.diagram, s.elongation, s.force);
  d.path_after = path;
  return true;
}

// Subtracts a force at elongation 0 that is more than noise: the first sample and the curve through all of
// them have it.
void pretension_take(SmoothedDiagram& d, Samples& s) {
  constexpr double kBegin = 0.02;  // of the diagram
  if (s.elongation[0] > kBegin * s.elongation.back() || std::abs(s.force[0]) <= d.resolution) return;
  const double force = samples_beginning(s).force;
  if (std::abs(force) <= d.resolution) return;
  d.pretension = force;
  force_subtract(s, force);
}

// Takes a slack out, where the strip beyond it is ten times as stiff: a soft beginning belongs to the cloth.
// Where the slack ends is found by extending the curve beyond it back to no force.
void slack_take(SmoothedDiagram& d, Samples& s) {
  constexpr double kStiffer = 10;
  const Slack slack = samples_slack(s, d.resolution);
  if (slack.end == 0) return;
  const Samples beyond = samples_from(s, slack.end);
  if (beyond.elongation.size() < scene::kMinSamples) return;
  const Beginning begin = samples_beginning(beyond);
  if (!(begin.slope > kStiffer * slack.max_slope)) return;
  const double back = begin.slope > 0 ? std::max(0.0, begin.force) / begin.slope : 0;
  d.slack = std::max(0.0, slack.end - back);
  s = samples_from(s, d.slack);
}

std::string samples_problem(const Samples& s) {
  const std::size_t count = s.elongation.size();
  if (std::none_of(s.force.begin(), s.force.end(), [](double f) { return f > 0; }))
    return "has no force above 0 N; wanted: a strip that pulls";
  if (count >= scene::kMinSamples) return "";
  return "has " + std::to_string(count) + (count == 1 ? " elongation" : " elongations") +
         " from 0 to its greatest force; wanted: at least " + std::to_string(scene::kMinSamples);
}

}  // namespace

SmoothedDiagram diagram_smooth(const scene::DiagramSpec& samples, double resolution) {
  SmoothedDiagram d;
  d.diagram = samples;
  d.record = record_order(samples, resolution);
  Samples s = d.record.samples;
  d.resolution = resolution > 0 ? resolution : d.record.scatter;
  d.path_before = math::slope_path(s.elongation, s.force);
  if (!s.elongation.empty() && finish_smooth(d, s)) return d;
  d.problem = samples_problem(s);
  if (!d.problem.empty()) return d;
  pretension_take(d, s);
  slack_take(d, s);
  const MonotoneFit fit = monotone_fit(s, d.resolution, kSmoothPath);
  points_choose(fit, s, d.resolution, d.diagram);
  d.is_near = fit.is_near;
  residual_set(d, s);
  return d;
}

}  // namespace drape::laboratory
