// Sums over the nodes of a row, place by place of kRowUnit nodes: every lane width gives the same bits.
#pragma once
#include "math/aligned_array.h"
#include "simd/lane.h"

namespace drape::simd {
namespace {

struct PlaceSums {
  alignas(math::kLine) double at[math::kRowUnit] = {};
  template <class L>
  DRAPE_INLINE void add(int i, L value) {
    double* const sum = at + i % math::kRowUnit;
    L::store(sum, L::load(sum) + value);
  }
  double total() const {
    double sum = 0;
    for (double one : at) sum += one;
    return sum;
  }
};

}  // namespace
}  // namespace drape::simd
