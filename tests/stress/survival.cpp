// The survival curve of the step: which share of nonlinear cloths is still bounded after many steps, against
// h / limit.
//
//     drape_survival [--steps N] [--seeds N] [--only CLOTH] [--from RATIO] [--to RATIO] [--order 2|4|6]
//
// Leapfrog is stable for a linear system while h omega < 2. In nonlinear cloth omega moves with the motion,
// and the step pumps energy into it well below the limit (parametric resonance with the time step). So each
// cloth is thrown: crumpled, hung up and let go, with every step at `ratio` times the least step limit met
// (looked at every 4 steps, 4 steps ahead) in the present or the last window of 5,000 steps. Energy of an
// undamped cloth is constant, that of a damped one falls. A run has survived when, sampled every 100 steps,
// kinetic + potential energy never rose above its start by more than a tenth of what is there to move: the
// weight's largest work, M g L, and the kinetic and elastic energy of the start.
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <numbers>
#include <random>
#include <thread>

#include "assembly/assemble.h"
#include "dynamics/advance.h"
#include "dynamics/potential_energy.h"
#include "dynamics/step_size/step_limit.h"
#include "model/kinetic_energy.h"
#include "scene_file.h"

namespace drape::stress {
namespace {

constexpr double kRatios[] = {0.4, 0.45, 0.5, 0.6, 0.7, 0.75, 0.8, 0.85, 0.9, 0.95, 1.0, 1.05};
constexpr double kDampings[] = {0, 0.2};     // 1/s
constexpr double kSide = 0.1, kCell = 0.01;  // m, of the square
constexpr double kCrumple = 0.004;           // of a cell
constexpr double kThrow = 0.3;               // m/s
constexpr int kLook = 4;                     // steps between checks of the limit
constexpr int kWindow = 5000;                // steps after which the step may grow again
constexpr int kSample = 100;                 // steps between samples of the energy
constexpr double kRise = 0.1;                // of the energy available

// A fabric and its pins.
struct Cloth {
  const char* name;
  const char* fabric;
  const char* pins;
};

constexpr const char* kWool = "file = \"" DRAPE_SOURCE_DIR "/examples/fabrics/wool.toml\"\n";
constexpr const char* kStraight = R"(areal_density = 0.15
thickness = 0.0005
bending = { rigidity_uN_cm2 = [1370, 1370] }
warp = { elongation_percent = [0, 10], force = [0, 30] }
weft = { elongation_percent = [0, 10], force = [0, 20] }
bias = { elongation_percent = [0, 10], force = [0, 4] }
)";
constexpr const char* kStiffening = R"(areal_density = 0.2
thickness = 0.0005
compression = 0.2
bending = { rigidity_uN_cm2 = [2000, 900] }
warp = { elongation_percent = [0, 2, 4, 6], force = [0, 2, 12, 60] }
weft = { elongation_percent = [0, 4, 8, 12], force = [0, 2, 12, 60] }
bias = { elongation_percent = [0, 5, 10, 15], force = [0, 1, 4, 15] }
)";
constexpr const char* kCorner = "at = [[0, 0.1]]\n";
constexpr const char* kTwo = "at = [[0, 0.1], [0.1, 0.1]]\n";
constexpr const char* kEdge = "edges = [2]\n";

constexpr Cloth kCloths[] = {
    {"wool, one pin", kWool, kCorner},
    {"wool, two pins", kWool, kTwo},
    {"wool, an edge", kWool, kEdge},
    {"straight, one pin", kStraight, kCorner},
    {"straight, two pins", kStraight, kTwo},
    {"straight, an edge", kStraight, kEdge},
    {"stiffening, one pin", kStiffening, kCorner},
    {"stiffening, two pins", kStiffening, kTwo},
    {"stiffening, an edge", kStiffening, kEdge},
};

Scene scene_of(const Cloth& cloth, double damping, int order) {
  const tests::SceneFolder folder;
  const std::string text =
      "[scene]\nname = \"survival\"\ndamping = " + std::to_string(damping) +
      "\norder = " + std::to_string(order) + "\n[options]\nclamp_correction = false\n[fabric.cloth]\n" +
      cloth.fabric + "[[piece]]\nname = \"square\"\nfabric = \"cloth\"\ncell = " + std::to_string(kCell) +
      "\noutline = [[0, 0], [0.1, 0], [0.1, 0.1], [0, 0.1]]\n" +
      "place = { origin = [0, 0, 0], axis_x = [1, 0, 0], axis_y = [0, 1, 0] }\n" +
      "[[pin]]\nname = \"peg\"\npiece = \"square\"\n" + cloth.pins;
  std::vector<Problem> problems;
  const Scene scene = validation::scene_load(folder.write("scene.toml", text), problems);
  for (const Problem& p : problems) std::fprintf(stderr, "%s\n", scene::problem_text(p).c_str());
  if (!problems.empty()) std::exit(1);
  return scene;
}

struct Run {
  System system;
  State state;
  dynamics::Motion motion;
  Array vx, vy, vz;
  std::vector<math::Wrench> load;
};

// Level cloth with every free particle off by up to kCrumple of a cell and moving at up to kThrow.
void run_begin(Run& r, const Scene& scene, unsigned seed) {
  std::vector<Problem> problems;
  r.system = assembly::system_assemble(scene, r.state, problems);
  r.motion = dynamics::motion_make(r.system);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (std::size_t n : r.system.particle) {
    const bool held = r.state.vx[n] == 0 && r.system.inverse_mass[n] == 0;
    for (Array* a : {&r.state.x, &r.state.y, &r.state.z})
      (*a)[n] += held ? 0 : kCrumple * kCell * unit(random);
    for (Array* a : {&r.state.vx, &r.state.vy, &r.state.vz}) (*a)[n] = held ? 0 : kThrow * unit(random);
  }
  for (const constraint::FixedNode& f : r.system.constraints.fixed) {
    r.state.x[f.node] = f.target.start[0], r.state.y[f.node] = f.target.start[1],
    r.state.z[f.node] = f.target.start[2];
    r.state.vx[f.node] = r.state.vy[f.node] = r.state.vz[f.node] = 0;
  }
  for (Array* a : {&r.vx, &r.vy, &r.vz}) a->assign(r.system.nodes, 0.0);
}

struct Energy {
  double moving;  // kinetic and elastic
  double total;   // and of the weight
};
Energy energy_of(Run& r) {
  dynamics::leapfrog_synchronous(r.system, r.motion, r.state, {r.vx.data(), r.vy.data(), r.vz.data()},
                                 r.load);
  const drape_energy e = dynamics::potential_energy(r.system, r.state);
  const double moving = model::kinetic_energy(r.system, r.vx, r.vy, r.vz) + e.stretch + e.shear + e.bending;
  return {moving, moving + e.gravity};
}

bool survives(const Cloth& cloth, double damping, int order, double ratio, unsigned seed, long steps) {
  Run r;
  run_begin(r, scene_of(cloth, damping, order), seed);
  double mass = 0, h = INFINITY, smallest = INFINITY;
  for (std::size_t n : r.system.particle) mass += r.system.mass[n];
  const Energy start = energy_of(r);
  const double largest = start.total + kRise * (mass * 9.81 * kSide * std::numbers::sqrt2 + start.moving);
  for (long n = 0; n < steps; ++n) {
    if (n % kLook == 0) {
      const double ahead = std::isfinite(h) ? kLook * h : 0;
      const double limit = dynamics::step_limit_of(
          r.system, dynamics::step_limit_omega2(r.system, *r.motion.kernel, r.state, ahead));
      h = std::min(h, ratio * limit);
      smallest = std::min(smallest, limit);
      if (!(h > 1e-9)) return false;
    }
    if (n % kWindow == kWindow - 1) h = ratio * smallest, smallest = INFINITY;
    dynamics::leapfrog_step(r.system, r.motion, r.state, h);
    if (n % kSample == kSample - 1 && !(energy_of(r).total <= largest)) return false;
  }
  return true;
}

struct Job {
  const Cloth* cloth;
  double damping, ratio;
  unsigned seed;
  bool survived = false;
};

void table_print(const std::vector<Job>& jobs, double damping) {
  std::printf("\ndamping %g 1/s: share of runs bounded, against h / limit\n%-22s", damping, "cloth");
  for (double ratio : kRatios) std::printf(" %5.2f", ratio);
  std::printf("\n");
  const auto line = [&](const char* name, const Cloth* cloth) {
    std::printf("%-22s", name);
    for (double ratio : kRatios) {
      int all = 0, good = 0;
      for (const Job& j : jobs)
        if (j.damping == damping && j.ratio == ratio && (!cloth || j.cloth == cloth))
          ++all, good += j.survived;
      if (all) std::printf(" %5.2f", double(good) / all);
      else std::printf("     -");
    }
    std::printf("\n");
  };
  for (const Cloth& c : kCloths)
    for (const Job& j : jobs)
      if (j.cloth == &c && j.damping == damping) {
        line(c.name, &c);
        break;
      }
  line("all", nullptr);
}

// h/limit up to which cloth thrown as slowly as here stays bounded.
double sound_ratio(double damping) { return damping > 0 ? dynamics::kSafety : dynamics::kSafetyNonlinear; }

int run(long steps, unsigned seeds, const char* only, double smallest, double largest, int order) {
  std::vector<Job> jobs;
  for (double ratio : kRatios) {
    if (ratio < smallest || ratio > largest) continue;
    for (double damping : kDampings)
      for (const Cloth& c : kCloths)
        for (unsigned seed = 1; seed <= seeds; ++seed)
          if (std::strstr(c.name, only)) jobs.push_back({&c, damping, ratio, seed});
  }
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t k = next++; k < jobs.size(); k = next++)
      jobs[k].survived = survives(*jobs[k].cloth, jobs[k].damping, order, jobs[k].ratio, jobs[k].seed, steps);
  };
  std::vector<std::thread> threads;
  for (unsigned t = 0; t < std::max(1u, std::thread::hardware_concurrency()); ++t) threads.emplace_back(work);
  for (std::thread& t : threads) t.join();
  std::printf("order %d, %ld steps, %u seeds, %zu runs\n", order, steps, seeds, jobs.size());
  for (double damping : kDampings) table_print(jobs, damping);
  int broken = 0;
  for (const Job& j : jobs) broken += j.ratio <= sound_ratio(j.damping) && !j.survived;
  if (broken)
    std::printf("%d runs at or below %g of the step limit, undamped, and %g grew\n", broken,
                dynamics::kSafetyNonlinear, dynamics::kSafety);
  return broken ? 1 : 0;
}

}  // namespace
}  // namespace drape::stress

int main(int argc, char** argv) {
  long steps = 100000;
  unsigned seeds = 4;
  const char* only = "";
  double min_ratio = 0, max_ratio = INFINITY;
  long order = 2;
  for (int k = 1; k < argc; ++k) {
    if (std::strcmp(argv[k], "--steps") == 0 && k + 1 < argc) steps = std::strtol(argv[++k], nullptr, 10);
    else if (std::strcmp(argv[k], "--seeds") == 0 && k + 1 < argc)
      seeds = unsigned(std::strtoul(argv[++k], nullptr, 10));
    else if (std::strcmp(argv[k], "--only") == 0 && k + 1 < argc) only = argv[++k];
    else if (std::strcmp(argv[k], "--from") == 0 && k + 1 < argc) min_ratio = std::strtod(argv[++k], nullptr);
    else if (std::strcmp(argv[k], "--to") == 0 && k + 1 < argc) max_ratio = std::strtod(argv[++k], nullptr);
    else if (std::strcmp(argv[k], "--order") == 0 && k + 1 < argc)
      order = std::strtol(argv[++k], nullptr, 10);
    else {
      std::fprintf(stderr,
                   "usage: drape_survival [--steps N] [--seeds N] [--only WORD OF A CLOTH] [--from RATIO] "
                   "[--to RATIO] [--order 2|4|6]\n");
      return 1;
    }
  }
  if (steps < 1 || seeds < 1) return std::fprintf(stderr, "--steps and --seeds: allowed: 1 or more\n"), 1;
  if (order != 2 && order != 4 && order != 6) return std::fprintf(stderr, "--order: allowed: 2, 4, 6\n"), 1;
  return drape::stress::run(steps, seeds, only, min_ratio, max_ratio, int(order));
}
