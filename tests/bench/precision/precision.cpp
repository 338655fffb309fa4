#include "bench/precision/precision.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "bench/precision/own.h"
#include "bench/precision/solver.h"
#include "reference/motion.h"

namespace drape::bench {
namespace {

struct OwnMethod {
  const char* name;
  Own own;
  int order;
};
constexpr OwnMethod kOwn[] = {{"Drape", Own::kLeapfrog2, 2},
                              {"Drape", Own::kOrder4, 4},
                              {"Drape", Own::kOrder6, 6},
                              {"paper", Own::kPaper, 1},
                              {"explicit Euler", Own::kEuler, 1}};

constexpr double kAsExact = 1e-11;  // below this error, the error of the reference solver counts
constexpr long kEulerShare = 15;    // of the budget: undamped, it needs a step of about 2/(omega^2 end)
constexpr double kNoAnswer = 1;     // an error this large means no answer

// The size of a sweep, in evaluations of forces, so that its rows do not depend on the machine.
struct Budget {
  long own, kernel, krylov, reference;  // of one sweep; krylov: on the kernel, by methods that solve systems
  double tightest;                      // relative tolerance
  double short_run;                     // s, below which a run is timed three times
};
constexpr Budget kWhole{300000, 150000, 30000, 10000, 1e-12, 0.05}, kQuick{4000, 3000, 3000, 300, 1e-6, 0};

struct Exact {
  Eigen::VectorXd r;
  double way;  // m
};

Exact exact_of(const Trial& t) {
  reference::Motion motion = reference::motion_make(t.scene);
  const Eigen::VectorXd start = reference::motion_start(motion);
  const reference::SolverHandle solver = reference::solver_open(motion, start, {1e-12, 8, 0});
  const Eigen::Index n = reference::layout_of(motion.lattice).velocity;
  const Eigen::VectorXd r = reference::solver_advance(*solver, t.end).head(n);
  return {r, (r - start.head(n)).lpNorm<Eigen::Infinity>()};
}

// The time of a run; for a short run, the median over several.
template <class Run>
double seconds_of(double first, const Budget& budget, Run run) {
  std::vector<double> turns{first};
  while (first < budget.short_run && turns.size() < 3) turns.push_back(run().seconds);
  std::nth_element(turns.begin(), turns.begin() + std::ptrdiff_t(turns.size() / 2), turns.end());
  return turns[turns.size() / 2];
}

struct Sweep {
  const Trial& trial;
  const Exact& exact;
  const Budget& budget;
  std::vector<PrecisionRow>& rows;

  double error(const Eigen::VectorXd& r) const {
    return r.size() ? (r - exact.r).lpNorm<Eigen::Infinity>() / exact.way : INFINITY;
  }
};

// Halves the step from the largest one that gives an answer.
void sweep_own(const Sweep& s, const OwnMethod& m) {
  if (!own_fits(s.trial.scene, m.own)) return;
  double largest = own_min_steps(s.trial.scene, m.own, s.trial.end);
  const bool euler = m.own == Own::kEuler;
  long spent = 0;
  bool found = false;
  for (int tries = 0; tries < 60; ++tries) {
    const long steps = std::max(1L, long(std::ceil(largest)));
    const auto run = [&] { return own_run(s.trial.scene, m.own, s.trial.end, steps); };
    const Stepped got = run();
    spent += got.evaluations;
    const double error = s.error(got.r);
    found = found || error < kNoAnswer;
    if (error < kNoAnswer)
      s.rows.push_back({s.trial.scene.name, m.name, "kernel", m.order, s.trial.end / double(steps), error,
                        seconds_of(got.seconds, s.budget, run), got.evaluations});
    if (error < kAsExact || spent > (euler ? kEulerShare : 1) * s.budget.own) return;
    largest *= found || euler ? 2 : 1.1;
  }
}

// Divides the tolerance by ten from 1e-2 until the error is reached, or the evaluations are used up.
void sweep_solver(const Sweep& s, const Equations& e, const Method& m, const char* forces, long largest) {
  long left = largest;
  for (double rtol = 1e-2; rtol > 0.9 * s.budget.tightest && left > 0; rtol /= 10) {
    const auto run = [&] { return solve(e, m, s.trial.end, rtol, left); };
    const Solved got = run();
    left -= got.evaluations;
    if (!got.done) continue;
    const double error = s.error(e.positions(got.y.data()));
    if (error < kNoAnswer)
      s.rows.push_back(
          {s.trial.scene.name, m.name, forces, m.order, rtol, error,
           seconds_of(got.seconds, s.budget, [&] { return solve(e, m, s.trial.end, rtol, largest); }),
           got.evaluations});
    if (error < kAsExact) return;
  }
}

// The seconds in which a sweep reaches an error: those of the cheapest run that does, or interpolated along
// the line of the logarithms between two neighbours of the sweep, one on either side. Infinite where no run
// does.
double seconds_for(const std::vector<PrecisionRow>& sweep, double error) {
  double best = INFINITY;
  for (std::size_t k = 0; k < sweep.size(); ++k) {
    if (sweep[k].error <= error) best = std::min(best, sweep[k].seconds);
    if (k == 0 || sweep[k - 1].error <= error || sweep[k].error > error) continue;
    const double a = std::log(sweep[k - 1].error), b = std::log(sweep[k].error);
    const double share = (std::log(error) - a) / (b - a);
    best = std::min(
        best, std::exp(std::log(sweep[k - 1].seconds) * (1 - share) + std::log(sweep[k].seconds) * share));
  }
  return best;
}

using Sweeps = std::map<std::string, std::vector<PrecisionRow>>;  // by method and order

std::pair<std::string, double> best_of(const Sweeps& sweeps, double error) {
  std::pair<std::string, double> best{"none", INFINITY};
  for (const auto& [name, rows] : sweeps)
    if (const double s = seconds_for(rows, error); s < best.second) best = {name, s};
  return best;
}

// Compares Drape's best order with the best solver on Drape's kernel. The aim is at most half of its time.
void summary_print(const std::string& scene, const std::vector<PrecisionRow>& rows) {
  Sweeps drape, peers;
  for (const PrecisionRow& row : rows) {
    if (row.scene != scene || row.forces != "kernel" || row.method == "paper" ||
        row.method == "explicit Euler")
      continue;
    std::string name = row.method;
    if (row.order) name += ' ', name += std::to_string(row.order);
    (row.method == "Drape" ? drape : peers)[name].push_back(row);
  }
  std::printf("\n%s\n%8s  %-10s %10s   %-16s %10s   %s\n", scene.c_str(), "error", "best order", "s",
              "best solver", "s", "ratio");
  for (int digits = 2; digits <= 8; ++digits) {
    const double error = std::pow(10.0, -digits);
    const auto [own, seconds] = best_of(drape, error);
    const auto [peer, others] = best_of(peers, error);
    const double ratio = seconds / others;
    const char* verdict = ratio <= 0.5          ? ""
                          : std::isinf(seconds) ? "  Drape does not get there"
                                                : "  more than half";
    std::printf("   1e-%02d  %-10s %10.3g   %-16s %10.3g   %.3f%s\n", digits, own.c_str(), seconds,
                peer.c_str(), others, ratio, verdict);
  }
  std::fflush(stdout);
}

}  // namespace

std::vector<PrecisionRow> precision(bool quick) {
  const Budget& budget = quick ? kQuick : kWhole;
  std::vector<PrecisionRow> rows;
  for (const Trial& trial : trials(quick)) {
    const Exact exact = exact_of(trial);
    const Sweep sweep{trial, exact, budget, rows};
    for (const OwnMethod& m : kOwn) sweep_own(sweep, m);
    const Equations kernel = equations_of_kernel(trial.scene),
                    reference = equations_of_reference(trial.scene);
    for (const Method& m : methods())
      sweep_solver(sweep, kernel, m, "kernel", m.krylov() ? budget.krylov : budget.kernel);
    for (const Method& m : methods()) sweep_solver(sweep, reference, m, "judge", budget.reference);
    summary_print(trial.scene.name, rows);
  }
  return rows;
}

void precision_write(std::FILE* out, const std::vector<PrecisionRow>& rows) {
  std::fprintf(out, "scene,method,forces,order,setting,error,seconds,evaluations\n");
  for (const PrecisionRow& r : rows)
    std::fprintf(out, "%s,\"%s\",%s,%d,%.6g,%.6g,%.6g,%ld\n", r.scene.c_str(), r.method.c_str(),
                 r.forces.c_str(), r.order, r.setting, r.error, r.seconds, r.evaluations);
}

}  // namespace drape::bench
