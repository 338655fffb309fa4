// Four doubles: AVX2 with FMA.
#pragma once
#include <immintrin.h>

#include "forces/lane.h"

namespace drape {
namespace {

struct Avx2Lane {
  static constexpr int kWidth = 4;
  using Mask = __m256d;
  using Index = __m256i;
  __m256d v;

  Avx2Lane() = default;
  DRAPE_INLINE Avx2Lane(double a) : v(_mm256_set1_pd(a)) {}
  DRAPE_INLINE Avx2Lane(__m256d a) : v(a) {}
  static DRAPE_INLINE Avx2Lane load(const double* p) { return _mm256_load_pd(p); }
  static DRAPE_INLINE Avx2Lane loadu(const double* p) { return _mm256_loadu_pd(p); }
  static DRAPE_INLINE void store(double* p, Avx2Lane a) { _mm256_store_pd(p, a.v); }
  static DRAPE_INLINE Index find(Avx2Lane e, const double* start, int n) {
    Index k = _mm256_setzero_si256();
    for (int i = 1; i < n; ++i)  // a true comparison is -1 in each lane
      k = _mm256_sub_epi64(k, _mm256_castpd_si256(_mm256_cmp_pd(e.v, _mm256_set1_pd(start[i]), _CMP_GE_OQ)));
    return k;
  }
  static DRAPE_INLINE Avx2Lane gather(const double* p, Index k) { return _mm256_i64gather_pd(p, k, 8); }

  friend DRAPE_INLINE Avx2Lane operator+(Avx2Lane a, Avx2Lane b) { return _mm256_add_pd(a.v, b.v); }
  friend DRAPE_INLINE Avx2Lane operator-(Avx2Lane a, Avx2Lane b) { return _mm256_sub_pd(a.v, b.v); }
  friend DRAPE_INLINE Avx2Lane operator*(Avx2Lane a, Avx2Lane b) { return _mm256_mul_pd(a.v, b.v); }
  friend DRAPE_INLINE Avx2Lane operator/(Avx2Lane a, Avx2Lane b) { return _mm256_div_pd(a.v, b.v); }
  friend DRAPE_INLINE Avx2Lane fma(Avx2Lane a, Avx2Lane b, Avx2Lane c) {
    return _mm256_fmadd_pd(a.v, b.v, c.v);
  }
  friend DRAPE_INLINE Avx2Lane sqrt(Avx2Lane a) { return _mm256_sqrt_pd(a.v); }
  friend DRAPE_INLINE Avx2Lane abs(Avx2Lane a) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a.v); }
  friend DRAPE_INLINE Avx2Lane max(Avx2Lane a, Avx2Lane b) { return _mm256_max_pd(a.v, b.v); }
  friend DRAPE_INLINE Avx2Lane min(Avx2Lane a, Avx2Lane b) { return _mm256_min_pd(a.v, b.v); }
  friend DRAPE_INLINE Mask ge(Avx2Lane a, Avx2Lane b) { return _mm256_cmp_pd(a.v, b.v, _CMP_GE_OQ); }
  friend DRAPE_INLINE Mask gt(Avx2Lane a, Avx2Lane b) { return _mm256_cmp_pd(a.v, b.v, _CMP_GT_OQ); }
  friend DRAPE_INLINE Avx2Lane copysign(Avx2Lane a, Avx2Lane b) {
    const __m256d sign = _mm256_set1_pd(-0.0);
    return _mm256_or_pd(_mm256_andnot_pd(sign, a.v), _mm256_and_pd(sign, b.v));
  }
  friend DRAPE_INLINE Avx2Lane select(Mask m, Avx2Lane a, Avx2Lane b) {
    return _mm256_blendv_pd(b.v, a.v, m);
  }
};

}  // namespace
}  // namespace drape
