#include "laboratory/samples.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace drape::laboratory {
namespace {

constexpr double kSame = 1e-9;  // of the greatest elongation: samples of one elongation

// Sorts the samples [0, end) of a record, and merges those of one elongation.
Samples samples_sort(const std::vector<double>& e, const std::vector<double>& f, std::size_t end) {
  std::vector<std::size_t> order(end);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return e[a] < e[b]; });
  Samples s;
  const double same = end > 0 ? kSame * std::abs(e[order.back()]) : 0;
  for (const std::size_t i : order) {
    if (s.elongation.empty() || e[i] - s.elongation.back() > same) {
      s.elongation.push_back(e[i]), s.force.push_back(f[i]), s.count.push_back(1), s.square.push_back(0);
      continue;
    }
    const double off = f[i] - s.force.back();
    s.force.back() += off / ++s.count.back();
    s.square.back() += off * (f[i] - s.force.back());
  }
  return s;
}

std::size_t greatest(const std::vector<double>& f) {
  return std::size_t(std::max_element(f.begin(), f.end()) - f.begin());
}

}  // namespace

double samples_total(const Samples& s) { return std::accumulate(s.count.begin(), s.count.end(), 0.0); }

double samples_square(const Samples& s) { return std::accumulate(s.square.begin(), s.square.end(), 0.0); }

double samples_scatter(const Samples& s) {
  const std::size_t n = s.elongation.size(), width = std::min<std::size_t>(4, n);
  double sum = samples_square(s), degrees = samples_total(s) - double(n);
  for (std::size_t first = 0; width > 2 && first + width <= n; ++first) {
    const double range = s.elongation[first + width - 1] - s.elongation[first];
    double difference = 0, norm = 0;
    for (std::size_t k = first; k < first + width; ++k) {
      double w = 1;
      for (std::size_t j = first; j < first + width; ++j)
        if (j != k) w *= range / (s.elongation[k] - s.elongation[j]);
      difference += w * s.force[k];
      norm += w * w / s.count[k];
    }
    sum += difference * difference / norm;
    degrees += 1;
  }
  return degrees > 0 ? std::sqrt(sum / degrees) : 0;
}

Record record_order(const scene::DiagramSpec& samples, double resolution) {
  Record r;
  std::vector<double> e, f;
  for (std::size_t i = 0; i < samples.elongation.size(); ++i) {
    if (samples.elongation[i] < 0) ++r.below_zero;
    else e.push_back(samples.elongation[i]), f.push_back(samples.force[i]);
  }
  if (e.empty()) return r;
  const std::size_t top = greatest(f);
  const double floor = kMinScatter * f[top];
  r.samples = samples_sort(e, f, top + 1);
  r.scatter = std::max(floor, samples_scatter(r.samples));
  const double noise = resolution > 0 ? resolution : r.scatter;
  r.break_elongation = e[top];
  if (f[top] - *std::min_element(f.begin() + std::ptrdiff_t(top), f.end()) > kBreakFall * noise) {
    r.after_break = e.size() - top - 1;
  } else {
    r.samples = samples_sort(e, f, e.size());
    r.scatter = std::max(floor, samples_scatter(r.samples));
  }
  e.resize(e.size() - r.after_break);
  r.reordered = e != r.samples.elongation;
  return r;
}

Slack samples_slack(const Samples& s, double resolution) {
  constexpr double kErrors = 2, kLeastShare = 0.05;
  constexpr int kLeastSamples = 3;
  Slack slack;
  double moment = 0, square = 0;
  int count = 0;
  bool zero = true;
  for (std::size_t k = 0; k < s.elongation.size(); ++k) {
    const double e = s.elongation[k], m = s.count[k];
    zero = zero && s.force[k] <= 0;
    if (!(e > 0)) continue;
    ++count;
    moment += m * e * s.force[k];
    square += m * e * e;
    const bool noise = count >= kLeastSamples && moment <= kErrors * resolution * std::sqrt(square);
    const double error = resolution / std::sqrt(square);
    if (zero) slack = {e, 0};
    else if (resolution > 0 && noise) slack = {e, moment / square + kErrors * error};
  }
  const bool is_all = slack.end >= s.elongation.back();  // no force at all: a law that is off
  return is_all || slack.end < kLeastShare * s.elongation.back() ? Slack{} : slack;
}

Samples samples_from(const Samples& s, double elongation) {
  Samples from;
  for (std::size_t k = 0; k < s.elongation.size(); ++k) {
    if (s.elongation[k] < elongation) continue;
    from.elongation.push_back(s.elongation[k] - elongation);
    from.force.push_back(s.force[k]);
    from.count.push_back(s.count[k]);
    from.square.push_back(s.square[k]);
  }
  return from;
}

}  // namespace drape::laboratory
