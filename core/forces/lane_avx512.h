// Eight doubles: AVX-512 F, DQ.
#pragma once
#include <immintrin.h>

#include "forces/lane.h"

namespace drape {
namespace {

struct Avx512Lane {
  static constexpr int kWidth = 8;
  using Mask = __mmask8;
  using Index = __m512i;
  __m512d v;

  Avx512Lane() = default;
  DRAPE_INLINE Avx512Lane(double a) : v(_mm512_set1_pd(a)) {}
  DRAPE_INLINE Avx512Lane(__m512d a) : v(a) {}
  static DRAPE_INLINE Avx512Lane load(const double* p) { return _mm512_load_pd(p); }
  static DRAPE_INLINE Avx512Lane loadu(const double* p) { return _mm512_loadu_pd(p); }
  static DRAPE_INLINE void store(double* p, Avx512Lane a) { _mm512_store_pd(p, a.v); }
  static DRAPE_INLINE Index find(Avx512Lane e, const double* start, int n) {
    Index k = _mm512_setzero_si512();
    const Index one = _mm512_set1_epi64(1);
    for (int i = 1; i < n; ++i)
      k = _mm512_mask_add_epi64(k, _mm512_cmp_pd_mask(e.v, _mm512_set1_pd(start[i]), _CMP_GE_OQ), k, one);
    return k;
  }
  static DRAPE_INLINE Avx512Lane gather(const double* p, Index k) { return _mm512_i64gather_pd(k, p, 8); }

  friend DRAPE_INLINE Avx512Lane operator+(Avx512Lane a, Avx512Lane b) { return _mm512_add_pd(a.v, b.v); }
  friend DRAPE_INLINE Avx512Lane operator-(Avx512Lane a, Avx512Lane b) { return _mm512_sub_pd(a.v, b.v); }
  friend DRAPE_INLINE Avx512Lane operator*(Avx512Lane a, Avx512Lane b) { return _mm512_mul_pd(a.v, b.v); }
  friend DRAPE_INLINE Avx512Lane operator/(Avx512Lane a, Avx512Lane b) { return _mm512_div_pd(a.v, b.v); }
  friend DRAPE_INLINE Avx512Lane fma(Avx512Lane a, Avx512Lane b, Avx512Lane c) {
    return _mm512_fmadd_pd(a.v, b.v, c.v);
  }
  friend DRAPE_INLINE Avx512Lane sqrt(Avx512Lane a) { return _mm512_sqrt_pd(a.v); }
  friend DRAPE_INLINE Avx512Lane abs(Avx512Lane a) { return _mm512_abs_pd(a.v); }
  friend DRAPE_INLINE Avx512Lane max(Avx512Lane a, Avx512Lane b) { return _mm512_max_pd(a.v, b.v); }
  friend DRAPE_INLINE Avx512Lane min(Avx512Lane a, Avx512Lane b) { return _mm512_min_pd(a.v, b.v); }
  friend DRAPE_INLINE Mask ge(Avx512Lane a, Avx512Lane b) { return _mm512_cmp_pd_mask(a.v, b.v, _CMP_GE_OQ); }
  friend DRAPE_INLINE Mask gt(Avx512Lane a, Avx512Lane b) { return _mm512_cmp_pd_mask(a.v, b.v, _CMP_GT_OQ); }
  friend DRAPE_INLINE Avx512Lane copysign(Avx512Lane a, Avx512Lane b) {
    const __m512d sign = _mm512_set1_pd(-0.0);
    return _mm512_or_pd(_mm512_andnot_pd(sign, a.v), _mm512_and_pd(sign, b.v));
  }
  friend DRAPE_INLINE Avx512Lane select(Mask m, Avx512Lane a, Avx512Lane b) {
    return _mm512_mask_blend_pd(m, b.v, a.v);
  }
};

}  // namespace
}  // namespace drape
