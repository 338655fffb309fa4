// Times by turns: the contenders are measured alternately in one run, and each figure is a median.
#pragma once
#include <functional>
#include <vector>

namespace drape::bench {

// Seconds that each contender takes for one of its steps. `steps(n)` runs n of them. Each turn of each
// contender lasts `turn` seconds.
using Contender = std::function<void(long n)>;
std::vector<double> race(const std::vector<Contender>& contenders, int turns, double turn);

}  // namespace drape::bench
