// The lane of one double. With kFused it is the reference that the vector lanes match bit for bit; without,
// it is the portable path.
#pragma once
#include <bit>
#include <cstdint>

#include "simd/lane.h"

namespace drape::simd {
namespace {

template <bool kFused>
struct ScalarLane {
  static constexpr int kWidth = 1;
  static constexpr bool kPermutes = false;
  struct Mask {
    bool m;
    friend DRAPE_INLINE bool any(Mask a) { return a.m; }
  };
  double v;

  ScalarLane() = default;
  DRAPE_INLINE ScalarLane(double a) : v(a) {}
  static DRAPE_INLINE ScalarLane load(const double* p) { return *p; }
  static DRAPE_INLINE ScalarLane loadu(const double* p) { return *p; }
  static DRAPE_INLINE void store(double* p, ScalarLane a) { *p = a.v; }
  static DRAPE_INLINE ScalarLane gather(const double* p, const int* i) { return p[*i]; }
  // NOLINTBEGIN(readability-function-size): four columns
  static DRAPE_INLINE void gather4(const double* p, const int* i, ScalarLane& a, ScalarLane& b, ScalarLane& c,
                                   ScalarLane& d) {
    const double* row = p + 4 * *i;
    a = row[0], b = row[1], c = row[2], d = row[3];
  }
  static DRAPE_INLINE void scatter4(double* p, const int* i, ScalarLane a, ScalarLane b, ScalarLane c,
                                    ScalarLane d) {
    double* row = p + 4 * *i;
    row[0] = a.v, row[1] = b.v, row[2] = c.v, row[3] = d.v;
  }
  // NOLINTEND(readability-function-size)
  static DRAPE_INLINE void truncate(int* to, ScalarLane a) { *to = int(a.v); }
  // NOLINTNEXTLINE(readability-function-size): six columns
  static DRAPE_INLINE void columns(const double* const* rows, ScalarLane& c0, ScalarLane& c1, ScalarLane& c2,
                                   ScalarLane& c3, ScalarLane& c4, ScalarLane& c5) {
    const double* row = rows[0];
    // NOLINTNEXTLINE(clang-analyzer-security.ArrayBound): a row goes on past the member that it begins with
    c0 = row[0], c1 = row[1], c2 = row[2], c3 = row[3], c4 = row[4], c5 = row[5];
  }

  friend DRAPE_INLINE ScalarLane operator+(ScalarLane a, ScalarLane b) { return a.v + b.v; }
  friend DRAPE_INLINE ScalarLane operator-(ScalarLane a, ScalarLane b) { return a.v - b.v; }
  friend DRAPE_INLINE ScalarLane operator*(ScalarLane a, ScalarLane b) { return a.v * b.v; }
  friend DRAPE_INLINE ScalarLane operator/(ScalarLane a, ScalarLane b) { return a.v / b.v; }
  friend DRAPE_INLINE ScalarLane fma(ScalarLane a, ScalarLane b, ScalarLane c) {
    return kFused ? __builtin_fma(a.v, b.v, c.v) : a.v * b.v + c.v;
  }
  friend DRAPE_INLINE ScalarLane fms(ScalarLane a, ScalarLane b, ScalarLane c) {
    return kFused ? __builtin_fma(a.v, b.v, -c.v) : a.v * b.v - c.v;
  }
  friend DRAPE_INLINE ScalarLane sqrt(ScalarLane a) { return __builtin_sqrt(a.v); }
  friend DRAPE_INLINE ScalarLane shifted(ScalarLane a, ScalarLane) { return a; }
  friend DRAPE_INLINE ScalarLane ahead(ScalarLane, ScalarLane b) { return b; }
  friend DRAPE_INLINE ScalarLane abs(ScalarLane a) { return __builtin_fabs(a.v); }
  friend DRAPE_INLINE ScalarLane max(ScalarLane a, ScalarLane b) { return a.v > b.v ? a.v : b.v; }
  friend DRAPE_INLINE ScalarLane min(ScalarLane a, ScalarLane b) { return a.v < b.v ? a.v : b.v; }
  friend DRAPE_INLINE ScalarLane select(Mask m, ScalarLane a, ScalarLane b) { return m.m ? a : b; }
  friend DRAPE_INLINE ScalarLane kept(ScalarLane a) { return a; }
  friend DRAPE_INLINE Mask ge(ScalarLane a, ScalarLane b) { return {a.v >= b.v}; }
  friend DRAPE_INLINE Mask gt(ScalarLane a, ScalarLane b) { return {a.v > b.v}; }
  friend DRAPE_INLINE ScalarLane bits_and(ScalarLane a, ScalarLane b) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(a.v) & std::bit_cast<std::uint64_t>(b.v));
  }
  friend DRAPE_INLINE ScalarLane bits_xor(ScalarLane a, ScalarLane b) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(a.v) ^ std::bit_cast<std::uint64_t>(b.v));
  }
};

}  // namespace
}  // namespace drape::simd
