#include "bench/bench.h"

#include <algorithm>
#include <cmath>

#include "bench/clock.h"
#include "bench/cloths.h"

namespace drape::bench {
namespace {

constexpr const char* kKernels[] = {"portable", "scalar", "avx2", "avx512"};
constexpr int kSides[] = {33, 65, 129, 257, 1025};

std::string size_text(int side) { return std::to_string(side) + " squared"; }

Contender stepper(Ready& r) {
  return [&r](long n) {
    for (long k = 0; k < n; ++k) leapfrog_step(r.system, r.motion, r.state, r.step);
  };
}

double rate_of(const Ready& r, double seconds) { return double(r.system.particle.size()) / seconds / 1e6; }

// Every instruction set of this processor on one cloth, against the portable kernel.
void race_kernels(const Features& features, int side, const Patience& patience, std::vector<Row>& rows) {
  const Scene scene = scene_of(features, side);
  std::vector<Ready> cloths;
  std::vector<const char*> names;
  for (const char* name : kKernels)
    if (const Kernel* kernel = kernel_named(name)) {
      cloths.push_back(ready(scene));
      cloths.back().motion.kernel = kernel;
      names.push_back(name);
    }
  std::vector<Contender> contenders;
  for (Ready& r : cloths) contenders.push_back(stepper(r));
  const std::vector<double> seconds = race(contenders, patience.turns, patience.seconds);
  for (std::size_t k = 0; k < seconds.size(); ++k)
    rows.push_back({"kernel", std::string(features.name) + ", " + size_text(side),
                    cloths[k].system.particle.size(), names[k], rate_of(cloths[k], seconds[k]),
                    seconds[0] / seconds[k], names[0]});
}

std::vector<Row> kernel_rows(const Patience& patience) {
  std::vector<Row> rows;
  for (const Features& features : {kStretchShear, kHinges, kFull})
    for (int side : kSides) race_kernels(features, side, patience, rows);
  return rows;
}

// Each feature alone, added to stretch and shear.
std::vector<Row> feature_rows(const Patience& patience) {
  const Features features[] = {kStretchShear,
                               {"tables of 16 points", 16},
                               {"tables of 30 points", 30},
                               {"hinges", 1, true},
                               {"cut cells", 1, false, true},
                               {"damping", 1, false, false, 2},
                               {"damping along the springs", 1, false, false, 0, 1e-5},
                               {"air", 1, false, false, 0, 0, true},
                               {"energy balance", 1, false, false, 0, 0, false, true},
                               kFull};
  std::vector<Ready> cloths;
  for (const Features& f : features) cloths.push_back(ready(scene_of(f, 129)));
  std::vector<Contender> contenders;
  for (Ready& r : cloths) contenders.push_back(stepper(r));
  const std::vector<double> seconds = race(contenders, patience.turns, patience.seconds);
  std::vector<Row> rows;
  for (std::size_t k = 0; k < seconds.size(); ++k) {
    const double rate = rate_of(cloths[k], seconds[k]);
    rows.push_back({"features", features[k].name, cloths[k].system.particle.size(),
                    cloths[k].motion.kernel->name, rate, rate / rate_of(cloths[0], seconds[0]),
                    features[0].name});
  }
  return rows;
}

// The full model by size, against 129 squared.
std::vector<Row> scaling_rows(const Patience& patience) {
  std::vector<Ready> cloths;
  for (int side : {129, 33, 65, 257, 513, 1001}) cloths.push_back(ready(scene_of(kFull, side)));
  std::vector<Contender> contenders;
  for (Ready& r : cloths) contenders.push_back(stepper(r));
  const std::vector<double> seconds = race(contenders, patience.turns, patience.seconds);
  std::vector<Row> rows;
  for (std::size_t k = 0; k < seconds.size(); ++k) {
    const double rate = rate_of(cloths[k], seconds[k]);
    rows.push_back({"scaling", kFull.name, cloths[k].system.particle.size(), cloths[k].motion.kernel->name,
                    rate, rate / rate_of(cloths[0], seconds[0]), "129 squared"});
  }
  return rows;
}

}  // namespace

const std::vector<Group>& groups() {
  static const std::vector<Group> kGroups = {
      {"kernel", "particle-steps per second by size, laws and instruction set", kernel_rows},
      {"features", "what each feature costs", feature_rows},
      {"scaling", "particle-steps per second against particles", scaling_rows}};
  return kGroups;
}

}  // namespace drape::bench
