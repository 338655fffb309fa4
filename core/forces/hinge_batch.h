// A batch of eight hinges of seams.
#pragma once
#include "math/aligned_array.h"

namespace drape::forces {

// Input: the arms a = x - p_a and c = p_b - x of each hinge, m, and its stiffness, N m. Output: the forces on
// p_a and p_b, N, which replace a and c.
struct alignas(math::kLine) HingeBatch {
  double a[3][math::kRowUnit], c[3][math::kRowUnit], stiffness[math::kRowUnit];
};
using HingeKernel = void (*)(HingeBatch&);

}  // namespace drape::forces
