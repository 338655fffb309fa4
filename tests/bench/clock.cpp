#include "bench/clock.h"

#include <algorithm>
#include <chrono>

namespace drape::bench {
namespace {

double seconds_of(const Contender& contender, long n) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  contender(n);
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

std::vector<double> race(const std::vector<Contender>& contenders, int turns, double turn) {
  std::vector<long> steps;
  for (const Contender& contender : contenders) {  // also warms up
    long n = 1;
    double seconds = seconds_of(contender, n);
    while (seconds < turn / 4) seconds = seconds_of(contender, n *= 2);
    steps.push_back(std::max(1L, long(double(n) * turn / seconds)));
  }
  std::vector<std::vector<double>> times(contenders.size());
  for (int k = 0; k < turns; ++k)
    for (std::size_t c = 0; c < contenders.size(); ++c)
      times[c].push_back(seconds_of(contenders[c], steps[c]) / double(steps[c]));
  std::vector<double> medians;
  for (const std::vector<double>& of : times) medians.push_back(median(of));
  return medians;
}

}  // namespace drape::bench
