// The lane of four doubles: AVX2 with FMA.
#pragma once
#include <immintrin.h>

#include "simd/lane.h"

namespace drape::simd {
namespace {

struct Avx2Lane {
  static constexpr int kWidth = 4;
  static constexpr bool kPermutes = false;
  struct Mask {
    __m256d v;
    friend DRAPE_INLINE bool any(Mask m) { return _mm256_movemask_pd(m.v) != 0; }
  };
  __m256d v;

  Avx2Lane() = default;
  DRAPE_INLINE Avx2Lane(double a) : v(_mm256_set1_pd(a)) {}
  DRAPE_INLINE Avx2Lane(__m256d a) : v(a) {}
  static DRAPE_INLINE Avx2Lane load(const double* p) { return _mm256_load_pd(p); }
  static DRAPE_INLINE Avx2Lane loadu(const double* p) { return _mm256_loadu_pd(p); }
  static DRAPE_INLINE void store(double* p, Avx2Lane a) { _mm256_store_pd(p, a.v); }
  // one by one: processors gather no faster, and some far slower
  static DRAPE_INLINE Avx2Lane gather(const double* p, const int* i) {
    return _mm256_set_m128d(_mm_loadh_pd(_mm_load_sd(p + i[2]), p + i[3]),
                            _mm_loadh_pd(_mm_load_sd(p + i[0]), p + i[1]));
  }
  // Exchanges rows and columns of four by four.
  static DRAPE_INLINE void transpose(__m256d& a, __m256d& b, __m256d& c, __m256d& d) {
    const __m256d ab = _mm256_unpacklo_pd(a, b), ab_on = _mm256_unpackhi_pd(a, b),
                  cd = _mm256_unpacklo_pd(c, d), cd_on = _mm256_unpackhi_pd(c, d);
    a = _mm256_permute2f128_pd(ab, cd, 0x20);
    b = _mm256_permute2f128_pd(ab_on, cd_on, 0x20);
    c = _mm256_permute2f128_pd(ab, cd, 0x31);
    d = _mm256_permute2f128_pd(ab_on, cd_on, 0x31);
  }
  // NOLINTBEGIN(readability-function-size): four columns
  static DRAPE_INLINE void gather4(const double* p, const int* i, Avx2Lane& a, Avx2Lane& b, Avx2Lane& c,
                                   Avx2Lane& d) {
    a = load(p + 4 * i[0]), b = load(p + 4 * i[1]), c = load(p + 4 * i[2]), d = load(p + 4 * i[3]);
    transpose(a.v, b.v, c.v, d.v);
  }
  static DRAPE_INLINE void scatter4(double* p, const int* i, Avx2Lane a, Avx2Lane b, Avx2Lane c, Avx2Lane d) {
    transpose(a.v, b.v, c.v, d.v);
    store(p + 4 * i[0], a), store(p + 4 * i[1], b), store(p + 4 * i[2], c), store(p + 4 * i[3], d);
  }
  // NOLINTEND(readability-function-size)
  static DRAPE_INLINE void truncate(int* to, Avx2Lane a) {
    _mm_store_si128(reinterpret_cast<__m128i*>(to), _mm256_cvttpd_epi32(a.v));
  }
  // NOLINTNEXTLINE(readability-function-size): six columns
  static DRAPE_INLINE void columns(const double* const* rows, Avx2Lane& c0, Avx2Lane& c1, Avx2Lane& c2,
                                   Avx2Lane& c3, Avx2Lane& c4, Avx2Lane& c5) {
    c0 = load(rows[0]), c1 = load(rows[1]), c2 = load(rows[2]), c3 = load(rows[3]);
    transpose(c0.v, c1.v, c2.v, c3.v);
    const __m256d even = _mm256_set_m128d(_mm_load_pd(rows[2] + 4), _mm_load_pd(rows[0] + 4)),
                  odd = _mm256_set_m128d(_mm_load_pd(rows[3] + 4), _mm_load_pd(rows[1] + 4));
    c4 = _mm256_unpacklo_pd(even, odd);
    c5 = _mm256_unpackhi_pd(even, odd);
  }

  friend DRAPE_INLINE Avx2Lane operator+(Avx2Lane a, Avx2Lane b) { return _mm256_add_pd(a.v, b.v); }
  friend DRAPE_INLINE Avx2Lane operator-(Avx2Lane a, Avx2Lane b) { return _mm256_sub_pd(a.v, b.v); }
  friend DRAPE_INLINE Avx2Lane operator*(Avx2Lane a, Avx2Lane b) { return _mm256_mul_pd(a.v, b.v); }
  friend DRAPE_INLINE Avx2Lane operator/(Avx2Lane a, Avx2Lane b) { return _mm256_div_pd(a.v, b.v); }
  friend DRAPE_INLINE Avx2Lane fma(Avx2Lane a, Avx2Lane b, Avx2Lane c) {
    return _mm256_fmadd_pd(a.v, b.v, c.v);
  }
  friend DRAPE_INLINE Avx2Lane fms(Avx2Lane a, Avx2Lane b, Avx2Lane c) {
    return _mm256_fmsub_pd(a.v, b.v, c.v);
  }
  friend DRAPE_INLINE Avx2Lane sqrt(Avx2Lane a) { return _mm256_sqrt_pd(a.v); }
  friend DRAPE_INLINE Avx2Lane shifted(Avx2Lane a, Avx2Lane b) {
    return _mm256_shuffle_pd(_mm256_permute2f128_pd(a.v, b.v, 0x21), b.v, 0b0101);
  }
  friend DRAPE_INLINE Avx2Lane ahead(Avx2Lane a, Avx2Lane b) {
    return _mm256_shuffle_pd(a.v, _mm256_permute2f128_pd(a.v, b.v, 0x21), 0b0101);
  }
  friend DRAPE_INLINE Avx2Lane abs(Avx2Lane a) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a.v); }
  friend DRAPE_INLINE Avx2Lane max(Avx2Lane a, Avx2Lane b) { return _mm256_max_pd(a.v, b.v); }
  friend DRAPE_INLINE Avx2Lane min(Avx2Lane a, Avx2Lane b) { return _mm256_min_pd(a.v, b.v); }
  friend DRAPE_INLINE Avx2Lane kept(Avx2Lane a) {
    asm("" : "+x"(a.v));
    return a;
  }
  friend DRAPE_INLINE Mask ge(Avx2Lane a, Avx2Lane b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_GE_OQ)}; }
  friend DRAPE_INLINE Mask gt(Avx2Lane a, Avx2Lane b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_GT_OQ)}; }
  friend DRAPE_INLINE Avx2Lane bits_and(Avx2Lane a, Avx2Lane b) { return _mm256_and_pd(a.v, b.v); }
  friend DRAPE_INLINE Avx2Lane bits_xor(Avx2Lane a, Avx2Lane b) { return _mm256_xor_pd(a.v, b.v); }
  friend DRAPE_INLINE Avx2Lane select(Mask m, Avx2Lane a, Avx2Lane b) {
    return _mm256_blendv_pd(b.v, a.v, m.v);
  }
};

}  // namespace
}  // namespace drape::simd
