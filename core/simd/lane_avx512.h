// The lane of eight doubles: AVX-512 F and DQ.
#pragma once
#include <immintrin.h>

#include <cstdint>

#include "simd/lane.h"

namespace drape::simd {
namespace {

// The eight words from the k-th of a, then b. Clang makes a two-table lookup of the intrinsic, which
// overwrites an operand and takes a table from memory.
template <int k>
DRAPE_INLINE __m512d words_shift(__m512d a, __m512d b) {
#ifdef __clang__
  __m512d words;
  asm("valignq %3, %2, %1, %0" : "=v"(words) : "v"(b), "v"(a), "i"(k));
  return words;
#else
  return _mm512_castsi512_pd(_mm512_alignr_epi64(_mm512_castpd_si512(b), _mm512_castpd_si512(a), k));
#endif
}

struct Avx512Lane {
  static constexpr int kWidth = 8;
  static constexpr bool kPermutes = true;
  struct Mask {
    __mmask8 m;
    friend DRAPE_INLINE bool any(Mask a) { return a.m != 0; }
  };
  __m512d v;

  Avx512Lane() = default;
  DRAPE_INLINE Avx512Lane(double a) : v(_mm512_set1_pd(a)) {}
  DRAPE_INLINE Avx512Lane(__m512d a) : v(a) {}
  static DRAPE_INLINE Avx512Lane load(const double* p) { return _mm512_load_pd(p); }
  static DRAPE_INLINE Avx512Lane loadu(const double* p) { return _mm512_loadu_pd(p); }
  static DRAPE_INLINE void store(double* p, Avx512Lane a) { _mm512_store_pd(p, a.v); }
  // one by one: processors gather no faster, and some far slower
  static DRAPE_INLINE Avx512Lane gather(const double* p, const int* i) {
    const __m256d low = _mm256_set_m128d(_mm_loadh_pd(_mm_load_sd(p + i[2]), p + i[3]),
                                         _mm_loadh_pd(_mm_load_sd(p + i[0]), p + i[1])),
                  high = _mm256_set_m128d(_mm_loadh_pd(_mm_load_sd(p + i[6]), p + i[7]),
                                          _mm_loadh_pd(_mm_load_sd(p + i[4]), p + i[5]));
    return _mm512_insertf64x4(_mm512_castpd256_pd512(low), high, 1);
  }
  // Exchanges rows and columns of four by four in both halves.
  static DRAPE_INLINE void transpose(__m512d& a, __m512d& b, __m512d& c, __m512d& d) {
    const __m512i low = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13),
                  high = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
    const __m512d ab = _mm512_unpacklo_pd(a, b), ab_on = _mm512_unpackhi_pd(a, b),
                  cd = _mm512_unpacklo_pd(c, d), cd_on = _mm512_unpackhi_pd(c, d);
    a = _mm512_permutex2var_pd(ab, low, cd);
    b = _mm512_permutex2var_pd(ab_on, low, cd_on);
    c = _mm512_permutex2var_pd(ab, high, cd);
    d = _mm512_permutex2var_pd(ab_on, high, cd_on);
  }
  static DRAPE_INLINE __m512d rows_load(const double* p, int first, int second) {
    return _mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_load_pd(p + 4 * first)),
                              _mm256_load_pd(p + 4 * second), 1);
  }
  static DRAPE_INLINE void rows_store(double* p, int first, int second, __m512d rows) {
    _mm256_store_pd(p + 4 * first, _mm512_castpd512_pd256(rows));
    _mm256_store_pd(p + 4 * second, _mm512_extractf64x4_pd(rows, 1));
  }
  // NOLINTBEGIN(readability-function-size): four columns
  static DRAPE_INLINE void gather4(const double* p, const int* i, Avx512Lane& a, Avx512Lane& b, Avx512Lane& c,
                                   Avx512Lane& d) {
    a.v = rows_load(p, i[0], i[4]), b.v = rows_load(p, i[1], i[5]);
    c.v = rows_load(p, i[2], i[6]), d.v = rows_load(p, i[3], i[7]);
    transpose(a.v, b.v, c.v, d.v);
  }
  static DRAPE_INLINE void scatter4(double* p, const int* i, Avx512Lane a, Avx512Lane b, Avx512Lane c,
                                    Avx512Lane d) {
    transpose(a.v, b.v, c.v, d.v);
    rows_store(p, i[0], i[4], a.v), rows_store(p, i[1], i[5], b.v);
    rows_store(p, i[2], i[6], c.v), rows_store(p, i[3], i[7], d.v);
  }
  // NOLINTEND(readability-function-size)
  static DRAPE_INLINE void truncate(int* to, Avx512Lane a) {
    _mm256_store_si256(reinterpret_cast<__m256i*>(to), _mm512_cvttpd_epi32(a.v));
  }
  // NOLINTNEXTLINE(readability-function-size): six columns
  static DRAPE_INLINE void columns(const double* const* rows, Avx512Lane& c0, Avx512Lane& c1, Avx512Lane& c2,
                                   Avx512Lane& c3, Avx512Lane& c4, Avx512Lane& c5) {
    __m512d even[4], odd[4];  // columns 0 2 4 6 and 1 3 5 7 of two rows, pair by pair
    for (int i = 0; i < 4; ++i) {
      const __m512d a = _mm512_load_pd(rows[2 * i]), b = _mm512_load_pd(rows[2 * i + 1]);
      even[i] = _mm512_unpacklo_pd(a, b);
      odd[i] = _mm512_unpackhi_pd(a, b);
    }
    constexpr int k02 = 0x88, k13 = 0xdd;  // pairs of either half
    const __m512d even04 = _mm512_shuffle_f64x2(even[0], even[1], k02),
                  even04_on = _mm512_shuffle_f64x2(even[2], even[3], k02),
                  even26 = _mm512_shuffle_f64x2(even[0], even[1], k13),
                  even26_on = _mm512_shuffle_f64x2(even[2], even[3], k13),
                  odd15 = _mm512_shuffle_f64x2(odd[0], odd[1], k02),
                  odd15_on = _mm512_shuffle_f64x2(odd[2], odd[3], k02),
                  odd37 = _mm512_shuffle_f64x2(odd[0], odd[1], k13),
                  odd37_on = _mm512_shuffle_f64x2(odd[2], odd[3], k13);
    c0 = _mm512_shuffle_f64x2(even04, even04_on, k02);
    c1 = _mm512_shuffle_f64x2(odd15, odd15_on, k02);
    c2 = _mm512_shuffle_f64x2(even26, even26_on, k02);
    c3 = _mm512_shuffle_f64x2(odd37, odd37_on, k02);
    c4 = _mm512_shuffle_f64x2(even04, even04_on, k13);
    c5 = _mm512_shuffle_f64x2(odd15, odd15_on, k13);
  }

  // Integers used as table indices; pick() reads their lowest bits.
  struct Places {
    __m512i v;
  };
  // a rounded to the nearest integer, independent of the rounding mode; a is above -1/2 and below 2^51.
  static DRAPE_INLINE Places places(Avx512Lane a) {
    constexpr double kWhole = 0x1.8p52;  // doubles this large have no fraction
    return {_mm512_castpd_si512(
        _mm512_add_round_pd(a.v, _mm512_set1_pd(kWhole), _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC))};
  }
  // m ? a + 1 : a
  static DRAPE_INLINE Places next(Places a, Mask m) {
    return {_mm512_mask_add_epi64(a.v, m.m, a.v, _mm512_set1_epi64(1))};
  }
  // table[at], for a table of 8 or 16 numbers
  template <int kSize>
  static DRAPE_INLINE Avx512Lane pick(const double (&table)[kSize], Places at) {
    if constexpr (kSize == 8) return _mm512_permutexvar_pd(at.v, _mm512_load_pd(table));
    else return _mm512_permutex2var_pd(_mm512_load_pd(table), at.v, _mm512_load_pd(table + 8));
  }
  template <int kSize>
  static DRAPE_INLINE Places pick(const std::int64_t (&table)[kSize], Places at) {
    if constexpr (kSize == 8) return {_mm512_permutexvar_epi64(at.v, _mm512_load_si512(table))};
    else return {_mm512_permutex2var_epi64(_mm512_load_si512(table), at.v, _mm512_load_si512(table + 8))};
  }

  friend DRAPE_INLINE Avx512Lane operator+(Avx512Lane a, Avx512Lane b) { return _mm512_add_pd(a.v, b.v); }
  friend DRAPE_INLINE Avx512Lane operator-(Avx512Lane a, Avx512Lane b) { return _mm512_sub_pd(a.v, b.v); }
  friend DRAPE_INLINE Avx512Lane operator*(Avx512Lane a, Avx512Lane b) { return _mm512_mul_pd(a.v, b.v); }
  friend DRAPE_INLINE Avx512Lane operator/(Avx512Lane a, Avx512Lane b) { return _mm512_div_pd(a.v, b.v); }
  friend DRAPE_INLINE Avx512Lane fma(Avx512Lane a, Avx512Lane b, Avx512Lane c) {
    return _mm512_fmadd_pd(a.v, b.v, c.v);
  }
  friend DRAPE_INLINE Avx512Lane fms(Avx512Lane a, Avx512Lane b, Avx512Lane c) {
    return _mm512_fmsub_pd(a.v, b.v, c.v);
  }
  friend DRAPE_INLINE Avx512Lane sqrt(Avx512Lane a) { return _mm512_sqrt_pd(a.v); }
  friend DRAPE_INLINE Avx512Lane shifted(Avx512Lane a, Avx512Lane b) { return words_shift<7>(a.v, b.v); }
  friend DRAPE_INLINE Avx512Lane ahead(Avx512Lane a, Avx512Lane b) { return words_shift<1>(a.v, b.v); }
  friend DRAPE_INLINE Avx512Lane abs(Avx512Lane a) { return _mm512_abs_pd(a.v); }
  friend DRAPE_INLINE Avx512Lane max(Avx512Lane a, Avx512Lane b) { return _mm512_max_pd(a.v, b.v); }
  friend DRAPE_INLINE Avx512Lane min(Avx512Lane a, Avx512Lane b) { return _mm512_min_pd(a.v, b.v); }
  friend DRAPE_INLINE Avx512Lane kept(Avx512Lane a) {
    asm("" : "+v"(a.v));
    return a;
  }
  friend DRAPE_INLINE Mask ge(Avx512Lane a, Avx512Lane b) {
    return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_GE_OQ)};
  }
  friend DRAPE_INLINE Mask gt(Avx512Lane a, Avx512Lane b) {
    return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_GT_OQ)};
  }
  friend DRAPE_INLINE Avx512Lane bits_and(Avx512Lane a, Avx512Lane b) { return _mm512_and_pd(a.v, b.v); }
  friend DRAPE_INLINE Avx512Lane bits_xor(Avx512Lane a, Avx512Lane b) { return _mm512_xor_pd(a.v, b.v); }
  friend DRAPE_INLINE Avx512Lane select(Mask m, Avx512Lane a, Avx512Lane b) {
    return _mm512_mask_blend_pd(m.m, b.v, a.v);
  }
};

}  // namespace
}  // namespace drape::simd
