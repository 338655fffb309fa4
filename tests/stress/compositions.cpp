// The published splitting methods on cloth: error of position at equal numbers of forces.
//
//     drape_compositions [--quick]
//
// Cloths of the work-precision diagram (tests/bench/precision) without air, from the start to their end. For
// each method: the limit of h omega over its forces and leapfrog's 2, the fewest forces with which it stays
// bounded, and the largest error of a coordinate over the largest way, there and with given numbers of
// forces. The reference is SRKN_11^b in steps four times as small as the smallest here.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "bench/cloths.h"
#include "bench/precision/trial.h"
#include "dynamics/step_size/step_limit.h"
#include "model/composition.h"

namespace drape::bench {
namespace {

struct Candidate {
  const char* name;  // with source
  int order;
  std::vector<double> kick, drift;
  double limit;
};

// Palindromes from their first halves: with the middle that makes the sum 1, or an even number.
std::vector<double> around(std::vector<double> half, bool middle) {
  double sum = 0;
  for (double x : half) sum += x;
  std::vector<double> all = half;
  if (middle) all.push_back(1 - 2 * sum);
  else all.push_back(0.5 - sum), half.push_back(0.5 - sum);
  all.insert(all.end(), half.rbegin(), half.rend());
  return all;
}

// Steps g_i of leapfrog: drifts g_i, kicks (g_{i-1} + g_i)/2.
Candidate leapfrogs(const char* name, int order, const std::vector<double>& half, double limit) {
  Candidate c{name, order, {}, around(half, true), limit};
  double before = 0;
  for (double g : c.drift) c.kick.push_back((before + g) / 2), before = g;
  c.kick.push_back(before / 2);
  return c;
}

std::vector<Candidate> candidates() {
  const double third = std::cbrt(2.0), fourth = std::cbrt(4.0), lambda = -0.02094333910398989;
  return {
      {"leapfrog", 2, {0.5, 0.5}, {1}, 2},
      leapfrogs("Yoshida 1990 (Forest, Ruth)", 4, {1 / (2 - third)}, 1.5734),
      leapfrogs("Suzuki 1990", 4, {1 / (4 - fourth), 1 / (4 - fourth)}, 2.7209),
      leapfrogs("McLachlan 1995, 5", 4, {0.28, 0.62546642846767004501}, 3.0182),
      {"Omelyan et al. 2002, VEFRL", 4, around({0.1644986515575760, 1.235692651138917}, true),
       around({(1 - 2 * lambda) / 2}, false), 3.4696},
      {"Blanes, Moan 2002, S_6", 4,
       around({0.0792036964311957, 0.353172906049774, -0.0420650803577195}, true),
       around({0.209515106613362, -0.143851773179818}, false), 3.1329},
      {"Blanes, Moan 2002, SRKN_6^b", 4,
       around({0.0829844064174052, 0.396309801498368, -0.0390563049223486}, true),
       around({0.245298957184271, 0.604872665711080}, false), 3.1635},
      leapfrogs("Yoshida 1990, A", 6, {0.784513610477560, 0.235573213359357, -1.17767998417887}, 2.2691),
      leapfrogs(
          "Kahan, Li 1997, 9", 6,
          {0.39216144400731413928, 0.33259913678935943860, -0.70624617255763935981, 0.08221359629355080023},
          2.5327),
      leapfrogs("McLachlan 1995, 9", 6,
                {0.1867, 0.55549702371247839916, 0.12946694891347535806, -0.84326562338773460855}, 2.7032),
      leapfrogs("Sofroniou, Spaletta 2005, 11", 6,
                {0.21375583945878254556, 0.18329381407425713911, 0.17692819473098943795,
                 -0.44329082681170215850, 0.11728560432865935385},
                2.9573),
      leapfrogs("Sofroniou, Spaletta 2005, 13", 6,
                {0.13861930854051695246, 0.13346562851074760407, 0.13070531011449225191,
                 0.12961893756907034773, -0.35000324893920896516, 0.11805530653002387170},
                3.0716),
      {"Blanes, Moan 2002, SRKN_11^b", 6,
       around({0.0414649985182624, 0.198128671918067, -0.0400061921041533, 0.0752539843015807,
               -0.0115113874206879},
              false),
       around(
           {0.123229775946271, 0.290553797799558, -0.127049212625417, -0.246331761062075, 0.357208872795928},
           true),
       3.1414},  // NOLINT(modernize-use-std-numbers): not pi
  };
}

std::vector<double> moved(const Trial& t, const Candidate& c, long steps) {
  const model::Composition own{c.order, int(c.drift.size()), c.kick.data(), c.drift.data(), c.limit};
  Ready r = ready_at_start(t.scene);
  r.system.composition = &own;
  for (long k = 0; k < steps; ++k)
    dynamics::leapfrog_step(r.system, r.motion, r.state, t.end / double(steps));
  std::vector<double> places;
  for (std::size_t n : r.system.particle)
    places.insert(places.end(), {r.state.x[n], r.state.y[n], r.state.z[n]});
  return places;
}

double apart(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double d = std::abs(a[k] - b[k]);
    largest = d <= largest ? largest : d;  // a NaN stays
  }
  return largest;
}

void table_print(const Trial& t, bool quick) {
  const std::vector<Candidate> all = candidates();
  const Ready start = ready_at_start(t.scene);
  const double smallest = t.end * std::sqrt(start.state.omega2) / 2;  // leapfrog's steps
  const int shares[] = {2, 4, 8, 16};
  const std::vector<double> exact = moved(t, all.back(), long((quick ? 16 : 64) * smallest / 11));
  const double way = apart(exact, moved(t, all[0], 0));
  std::printf("\n%s: forces over leapfrog's least, %.0f\n%-30s %5s %6s  %6s %8s", t.scene.name.c_str(),
              smallest, "", "order", "limit", "least", "error");
  for (int share : shares) std::printf(" %8d", share);
  std::printf("\n");
  for (const Candidate& c : all) {
    const double stages = double(c.drift.size());
    const auto error = [&](double forces) {
      return apart(moved(t, c, std::max(1L, long(std::ceil(forces * smallest / stages)))), exact) / way;
    };
    double forces = 2 * stages / c.limit, first = error(forces);
    while (!(first < 0.1) && forces < 50) first = error(forces *= 1.05);
    std::printf("%-30s %5d %6.3f  %6.2f %8.1e", c.name, c.order, c.limit / stages / 2, forces, first);
    for (int share : shares)
      if (share >= forces) std::printf(" %8.1e", error(share));
      else std::printf("        -");
    std::printf("\n");
  }
}

}  // namespace
}  // namespace drape::bench

int main(int argc, char** argv) {
  const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  for (const drape::bench::Trial& t : drape::bench::trials(quick))
    if (!t.scene.has_air) drape::bench::table_print(t, quick);
  return 0;
}
