// Links in lanes: from their ends to what they pull with.
//
//   square  = |r1 - r0|^2                    l = sqrt(square)
//   inverse = 1/l,  strain = l/l0 - 1
//   scale   = w p(e)/l                       pull on the first end: scale (r1 - r0)
//
// The way is long, a root and a division lie on it, and a processor looks ahead over no more than two lanes
// of a whole slab. So a loop over lanes takes each through the stages one by one: while one lane is at its
// pulls, the next is at its laws, and so on. Between the stages only numbers of links are kept; edges are
// made again, which is cheap.
#pragma once
#include "forces/tension.h"
#include "simd/vector_lanes.h"

namespace drape::forces {
namespace {

// Where the ends of a link are in one place, as some that are left out by the outline, it has no direction:
// the root of kTiny (m^2), which adds nothing to any other length, keeps its numbers finite.
inline constexpr double kTiny = 1e-200;

template <class L>
struct LinkLane {
  L inverse;  // 1/m
  L strain;
};

// Two links at a time: one division serves both lengths, 1/l0 = l1/(l0 l1).
template <class L>
DRAPE_INLINE void links_measure(const L* square, L inverse_rest, LinkLane<L>* two) {
  const L length0 = sqrt(square[0]), length1 = sqrt(square[1]);
  const L inverse = L(1.0) / (length0 * length1);
  two[0] = {inverse * length1, fma(length0, inverse_rest, L(-1.0))};
  two[1] = {inverse * length0, fma(length1, inverse_rest, L(-1.0))};
}

}  // namespace
}  // namespace drape::forces
