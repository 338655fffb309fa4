// Rows of a lattice as the force laws read them, and 3-vectors of lanes.
//
// A row has `n` doubles (a multiple of kRowUnit) for each coordinate, with kRowUnit readable doubles before
// and after them. Cells outside the outline have share 0, so their links have width 0 and exert no force.
#pragma once
#include <algorithm>

#include "simd/lane.h"

namespace drape::simd {

struct ConstRow {
  const double *x, *y, *z;
};

struct Row {
  double *x, *y, *z;
  DRAPE_INLINE operator ConstRow() const { return {x, y, z}; }
};

// Coordinate k of a 3-vector or row: 0 x, 1 y, 2 z.
template <class T>
DRAPE_INLINE auto coordinate(const T& v, int k) {
  return k == 0 ? v.x : k == 1 ? v.y : v.z;
}

namespace {

template <class L>
struct Vec {
  L x, y, z;
};

template <class L>
DRAPE_INLINE Vec<L> vec_load(ConstRow r, long i) {
  return {L::loadu(r.x + i), L::loadu(r.y + i), L::loadu(r.z + i)};
}
template <class L>
DRAPE_INLINE void vec_store(Row r, long i, Vec<L> v) {
  L::store(r.x + i, v.x);
  L::store(r.y + i, v.y);
  L::store(r.z + i, v.z);
}
template <class L>
DRAPE_INLINE Vec<L> operator+(Vec<L> a, Vec<L> b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class L>
DRAPE_INLINE Vec<L> operator-(Vec<L> a, Vec<L> b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class L>
DRAPE_INLINE Vec<L> operator*(Vec<L> a, L s) {
  return {a.x * s, a.y * s, a.z * s};
}
template <class L>
DRAPE_INLINE L dot(Vec<L> a, Vec<L> b) {
  return fma(a.x, b.x, fma(a.y, b.y, a.z * b.z));
}
template <class L>
DRAPE_INLINE Vec<L> cross(Vec<L> a, Vec<L> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class L>
DRAPE_INLINE Vec<L> shifted(Vec<L> a, Vec<L> b) {
  return {shifted(a.x, b.x), shifted(a.y, b.y), shifted(a.z, b.z)};
}

template <class L>
DRAPE_INLINE Vec<L> ahead(Vec<L> a, Vec<L> b) {
  return {ahead(a.x, b.x), ahead(a.y, b.y), ahead(a.z, b.z)};
}

// The index of the lane to the right of that at i. At the end of a row it is i again, whose values are not
// used.
template <class L>
DRAPE_INLINE int lane_after(int i, int end) {
  return i + L::kWidth < end ? i + L::kWidth : i;
}

// A row stored as x, y and z of kRowUnit nodes in turn: one address serves all three coordinates.
struct PackedRow {
  double* p;
  template <class L>
  DRAPE_INLINE double* at(int i, int k) const {
    if constexpr (L::kWidth == 8) return p + 3 * i + 8 * k;
    else return p + i / 8 * 24 + 8 * k + i % 8;
  }
};
template <class L>
DRAPE_INLINE Vec<L> packed_load(PackedRow r, int i) {
  return {L::load(r.at<L>(i, 0)), L::load(r.at<L>(i, 1)), L::load(r.at<L>(i, 2))};
}
template <class L>
DRAPE_INLINE void packed_store(PackedRow r, int i, Vec<L> v) {
  for (int k = 0; k < 3; ++k) L::store(r.at<L>(i, k), coordinate(v, k));
}

// Largest and smallest over the lanes.
template <class L>
double largest_of(L a) {
  alignas(math::kLine) double lane[L::kWidth];
  L::store(lane, a);
  return *std::max_element(lane, lane + L::kWidth);
}
template <class L>
double smallest_of(L a) {
  alignas(math::kLine) double lane[L::kWidth];
  L::store(lane, a);
  return *std::min_element(lane, lane + L::kWidth);
}

}  // namespace
}  // namespace drape::simd
