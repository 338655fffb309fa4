#include "bench/bench.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bench/bound.h"
#include "bench/clock.h"
#include "bench/cloths.h"
#include "validation/load.h"

namespace drape::bench {
namespace {

constexpr const char* kKernels[] = {"portable", "scalar", "avx2", "avx512"};
constexpr int kSides[] = {33, 65, 129, 257, 1025};

// Million particle-steps per second of each cloth, measured alternately.
std::vector<double> rates_of(std::vector<Ready>& cloths, const Patience& patience) {
  std::vector<Contender> contenders;
  for (Ready& r : cloths)
    contenders.push_back([&r](long n) {
      for (long k = 0; k < n; ++k) dynamics::leapfrog_step(r.system, r.motion, r.state, r.step);
    });
  std::vector<double> rates = race(contenders, patience.turns, patience.seconds);
  for (std::size_t k = 0; k < rates.size(); ++k)
    rates[k] = double(cloths[k].system.particle.size()) / rates[k] / 1e6;
  return rates;
}

// Adds a row for each cloth, with its ratio to the first.
void rows_add(const char* group, const std::vector<std::string>& names, std::vector<Ready>& cloths,
              const std::string& against, const Patience& patience, std::vector<Row>& rows) {
  const std::vector<double> rates = rates_of(cloths, patience);
  for (std::size_t k = 0; k < cloths.size(); ++k)
    rows.push_back({group, names[k], cloths[k].system.particle.size(), cloths[k].motion.kernel->name,
                    rates[k], rates[k] / rates[0], against});
}

// Adds every instruction set of this processor on one cloth, against the portable kernel.
void race_kernels(const Features& features, int side, const Patience& patience, std::vector<Row>& rows) {
  const Scene scene = scene_of(features, side);
  std::vector<Ready> cloths;
  for (const char* name : kKernels)
    if (const dynamics::Kernel* kernel = dynamics::kernel_named(name)) {
      cloths.push_back(ready(scene));
      cloths.back().motion.kernel = kernel;
    }
  const std::string name = std::string(features.name) + ", " + std::to_string(side) + " squared";
  rows_add("kernel", std::vector(cloths.size(), name), cloths, kKernels[0], patience, rows);
}

std::vector<Row> kernel_rows(const Patience& patience) {
  std::vector<Row> rows;
  for (const Features& features : {kStretchShear, kHinges, kFull})
    for (int side : kSides) race_kernels(features, side, patience, rows);
  return rows;
}

// One and two threads by size; the process must not be pinned to one core.
std::vector<Row> thread_rows(const Patience& patience) {
  std::vector<Row> rows;
  for (const Features& features : {kStretchShear, kHinges, kFull})
    for (int side : {33, 65, 129, 257, 513}) {
      const Scene scene = scene_of(features, side);
      std::vector<Ready> cloths;
      std::vector<std::string> names;
      for (int threads : {1, 2}) {
        cloths.push_back(ready(scene, threads));
        const std::size_t used = cloths.back().motion.workspace.threads.size();
        names.push_back(std::string(features.name) + ", threads " + std::to_string(threads) +
                        (int(used) < threads ? " (one is used)" : ""));
      }
      rows_add("threads", names, cloths, "1 thread", patience, rows);
    }
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
                               {"self-contact, nothing near", 1, false, false, 0, 0, false, false, 1},
                               {"self-contact, two layers", 1, false, false, 0, 0, false, false, 2},
                               kFull};
  std::vector<Ready> cloths;
  std::vector<std::string> names;
  for (const Features& f : features) {
    cloths.push_back(ready(scene_of(f, 129)));
    names.push_back(f.name);
  }
  std::vector<Row> rows;
  rows_add("features", names, cloths, names[0], patience, rows);
  return rows;
}

// The fraction of the port bound that the kernel reaches. Both are measured in this run.
std::vector<Row> bound_rows(const Patience& patience) {
  std::vector<Row> rows;
  for (Ports (*measure)() : {ports_avx2, ports_avx512}) {
    const bool wide = measure == ports_avx512;
    const dynamics::Kernel* kernel = dynamics::kernel_named(wide ? "avx512" : "avx2");
    if (!kernel) continue;
    for (const auto& [features, operations] :
         {std::pair{kStretchShear, kStretchShearOperations}, {kHinges, kHingesOperations}}) {
      const double bound = port_bound(operations, measure());
      std::vector<Ready> cloths;
      cloths.push_back(ready(scene_of(features, 129)));
      cloths[0].motion.kernel = kernel;
      const double rate = rates_of(cloths, patience)[0];
      rows.push_back({"bound", features.name, cloths[0].system.particle.size(), kernel->name, rate,
                      rate / bound, "port bound " + std::to_string(std::lround(bound))});
    }
  }
  return rows;
}

// The rows against which tests/bench/peers/run.py compares other programs.
std::vector<Row> peer_rows(const Patience& patience) {
  std::vector<Ready> cloths;
  std::vector<std::string> names;
  for (const Features& features : {kStretchShear, kHinges}) {
    cloths.push_back(ready(scene_of(features, 129)));
    names.push_back(features.name);
  }
  std::vector<Row> rows;
  rows_add("peers", names, cloths, names[0], patience, rows);
  return rows;
}

// Adds a scene as it is: the wall time of a simulated second, and the share of a step that the kernel's pass
// takes.
void scene_rows_add(const std::string& file, const Patience& patience, std::vector<Row>& rows) {
  std::vector<Problem> problems;
  const Scene scene = validation::scene_load(file, problems);
  for (const Problem& p : problems) throw std::runtime_error(scene::problem_text(p));
  Ready r = ready_at_start(scene);
  const double q = scene.communication;
  std::string event;
  long intervals = 0;
  const auto advance = [&](long n) {
    for (long k = 0; k < n; ++k, ++intervals)
      if (dynamics::leapfrog_advance(r.system, r.motion, r.state, q, event) != dynamics::Advance::kDone)
        throw std::runtime_error(file + " does not run to the end of the measurement");
  };
  advance(10);
  State still = r.state;
  const model::Scheme at_rest{};
  const auto pass = [&](long n) {
    for (long k = 0; k < n; ++k)
      dynamics::kernel_step(*r.motion.kernel, r.system, at_rest, r.motion.workspace, still);
  };
  const std::vector<double> seconds = race({advance, pass}, patience.turns, patience.seconds);
  const double particles = double(r.system.particle.size()),
               steps = double(r.state.steps) / double(intervals);
  rows.push_back({"scenes", scene.name, r.system.particle.size(), r.motion.kernel->name,
                  particles * steps / seconds[0] / 1e6, seconds[0] / q, "the simulated time"});
  rows.push_back({"scenes", scene.name + ": its pass", r.system.particle.size(), r.motion.kernel->name,
                  particles / seconds[1] / 1e6, seconds[1] * steps / seconds[0], "the step"});
}
std::vector<Row> scene_rows(const Patience& patience) {
  std::vector<Row> rows;
  for (const std::string& file : patience.scenes) scene_rows_add(file, patience, rows);
  return rows;
}

// The full model by size, against 129 squared.
std::vector<Row> scaling_rows(const Patience& patience) {
  std::vector<Ready> cloths;
  for (int side : {129, 33, 65, 257, 513, 1001}) cloths.push_back(ready(scene_of(kFull, side)));
  std::vector<Row> rows;
  rows_add("scaling", std::vector<std::string>(cloths.size(), kFull.name), cloths, "129 squared", patience,
           rows);
  return rows;
}

}  // namespace

const std::vector<Group>& groups() {
  static const std::vector<Group> kGroups = {
      {"kernel", "particle-steps per second by size, laws and instruction set", kernel_rows},
      {"threads", "what a second thread gains; not to be pinned", thread_rows, false},
      {"scenes", "the scenes of --scene: time of a simulated second, share of the pass", scene_rows, false},
      {"bound", "the share of what the arithmetic ports could do", bound_rows},
      {"features", "what each feature costs", feature_rows},
      {"peers", "Drape's side of tests/bench/peers/run.py", peer_rows},
      {"scaling", "particle-steps per second against particles", scaling_rows}};
  return kGroups;
}

}  // namespace drape::bench
