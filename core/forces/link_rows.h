// Links in lanes: from their ends to their forces.
//
//   square  = |r1 - r0|^2                    l = sqrt(square)
//   inverse = 1/l,  strain = l/l0 - 1
//   scale   = w p(e)/l                       pull on the first end: scale (r1 - r0)
//
// This is a long dependency chain with a root and a division, and a processor reorders over no more than two
// lanes of a whole slab. So the loop over lanes is pipelined by hand in stages: while one lane computes its
// forces, the next evaluates its laws, and so on. Between the stages only scalars of links are stored; edge
// vectors are recomputed, which is cheap.
#pragma once
#include "forces/tension.h"
#include "simd/vector_lanes.h"

namespace drape::forces {
namespace {

// A link whose ends coincide has no direction; some links outside the outline are such. Adding kTiny, m^2,
// under the root keeps its values finite and changes no other length.
inline constexpr double kTiny = 1e-200;

template <class L>
struct LinkLane {
  L inverse;  // 1/m
  L strain;
};

// Two links at a time: one division serves both, 1/l0 = l1/(l0 l1).
template <class L>
DRAPE_INLINE void links_measure(const L* square, L inverse_rest, LinkLane<L>* two) {
  const L length0 = sqrt(square[0]), length1 = sqrt(square[1]);
  const L inverse = L(1.0) / (length0 * length1);
  two[0] = {inverse * length1, fma(length0, inverse_rest, L(-1.0))};
  two[1] = {inverse * length0, fma(length1, inverse_rest, L(-1.0))};
}

}  // namespace
}  // namespace drape::forces
