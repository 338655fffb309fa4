// Throughput of a lane's operations: as many independent ones in a row as hide their latency; the best of
// many short runs.
#pragma once
#include <algorithm>
#include <chrono>

#include "bench/ports.h"

namespace drape::bench {
namespace {

constexpr int kChains = 12, kRounds = 400, kRuns = 400;

// op(a, p) gives a chain its next value. `p`: numbers of the chain.
template <class L, class Op>
double seconds_per_op(Op op) {
  using Clock = std::chrono::steady_clock;
  alignas(64) static double numbers[kChains * L::kWidth];
  double best = 1;
  for (int run = 0; run < kRuns; ++run) {
    L chain[kChains];
    for (L& a : chain) a = L(1.5);
    const Clock::time_point start = Clock::now();
    for (double& x : numbers) x = 1.5;
    for (int round = 0; round < kRounds; ++round)
      for (int k = 0; k < kChains; ++k) chain[k] = kept(op(chain[k], numbers + k * L::kWidth));
    for (int k = 0; k < kChains; ++k) L::store(numbers + k * L::kWidth, chain[k]);
    asm volatile("" : : "r"(numbers) : "memory");  // keeps the compiler from removing them
    const double spent = std::chrono::duration<double>(Clock::now() - start).count();
    best = std::min(best, spent);
  }
  return best / (kRounds * kChains);
}

template <class L>
Ports ports_of(const char* kernel) {
  const L one = kept(L(1.0)), tiny = kept(L(1e-9));
  return {kernel,
          L::kWidth,
          seconds_per_op<L>([&](L a, const double*) { return fma(a, one, tiny); }),
          seconds_per_op<L>([&](L a, const double*) { return a + tiny; }),
          seconds_per_op<L>([](L a, const double*) { return sqrt(a); }),
          seconds_per_op<L>([&](L a, const double*) { return one / a; }),
          seconds_per_op<L>([](L, const double* p) { return L::load(p); })};
}

}  // namespace
}  // namespace drape::bench
