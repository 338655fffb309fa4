// Hinges of seams, eight at a time.
#pragma once
#include "math/aligned_array.h"

namespace drape::forces {

// In: the arms a = x - p_a, c = p_b - x of each, m, and its stiffness, N m. Out: the forces on p_a and p_b,
// N, in their places.
struct alignas(math::kLine) HingeBatch {
  double a[3][math::kRowUnit], c[3][math::kRowUnit], stiffness[math::kRowUnit];
};
using HingeKernel = void (*)(HingeBatch&);

}  // namespace drape::forces
