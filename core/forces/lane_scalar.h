// One double as a lane: the portable path, and with kFused the yardstick that the vector lanes match bit for
// bit.
#pragma once
#include <cmath>

#include "forces/lane.h"

namespace drape {
namespace {

template <bool kFused>
struct ScalarLane {
  static constexpr int kWidth = 1;
  using Mask = bool;
  using Index = int;
  double v;

  ScalarLane() = default;
  DRAPE_INLINE ScalarLane(double a) : v(a) {}
  static DRAPE_INLINE ScalarLane load(const double* p) { return *p; }
  static DRAPE_INLINE ScalarLane loadu(const double* p) { return *p; }
  static DRAPE_INLINE void store(double* p, ScalarLane a) { *p = a.v; }
  static DRAPE_INLINE Index find(ScalarLane e, const double* start, int n) {
    int k = 0;
    for (int i = 1; i < n; ++i) k += e.v >= start[i];
    return k;
  }
  static DRAPE_INLINE ScalarLane gather(const double* p, Index k) { return p[k]; }

  friend DRAPE_INLINE ScalarLane operator+(ScalarLane a, ScalarLane b) { return a.v + b.v; }
  friend DRAPE_INLINE ScalarLane operator-(ScalarLane a, ScalarLane b) { return a.v - b.v; }
  friend DRAPE_INLINE ScalarLane operator*(ScalarLane a, ScalarLane b) { return a.v * b.v; }
  friend DRAPE_INLINE ScalarLane operator/(ScalarLane a, ScalarLane b) { return a.v / b.v; }
  friend DRAPE_INLINE ScalarLane fma(ScalarLane a, ScalarLane b, ScalarLane c) {
    return kFused ? __builtin_fma(a.v, b.v, c.v) : a.v * b.v + c.v;
  }
  friend DRAPE_INLINE ScalarLane sqrt(ScalarLane a) { return __builtin_sqrt(a.v); }
  friend DRAPE_INLINE ScalarLane abs(ScalarLane a) { return __builtin_fabs(a.v); }
  friend DRAPE_INLINE ScalarLane max(ScalarLane a, ScalarLane b) { return a.v > b.v ? a.v : b.v; }
  friend DRAPE_INLINE ScalarLane min(ScalarLane a, ScalarLane b) { return a.v < b.v ? a.v : b.v; }
  friend DRAPE_INLINE Mask ge(ScalarLane a, ScalarLane b) { return a.v >= b.v; }
  friend DRAPE_INLINE Mask gt(ScalarLane a, ScalarLane b) { return a.v > b.v; }
  friend DRAPE_INLINE ScalarLane copysign(ScalarLane a, ScalarLane b) { return __builtin_copysign(a.v, b.v); }
};

template <bool kFused>
DRAPE_INLINE ScalarLane<kFused> select(bool m, ScalarLane<kFused> a, ScalarLane<kFused> b) {
  return m ? a : b;
}

}  // namespace
}  // namespace drape
