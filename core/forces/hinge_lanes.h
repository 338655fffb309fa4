// The forces of a batch of hinges, lane by lane.
#pragma once
#include "forces/bending.h"
#include "forces/hinge_batch.h"

namespace drape::forces {
namespace {

template <class L>
void hinges_bend(HingeBatch& b) {
  for (int i = 0; i < math::kRowUnit; i += L::kWidth) {
    const simd::Vec<L> a{L::load(b.a[0] + i), L::load(b.a[1] + i), L::load(b.a[2] + i)},
        c{L::load(b.c[0] + i), L::load(b.c[1] + i), L::load(b.c[2] + i)};
    const L inverse_a = L(1.0) / sqrt(dot(a, a)), inverse_c = L(1.0) / sqrt(dot(c, c));
    const HingeForces<L> f =
        bending_hinge(a * inverse_a, inverse_a, c * inverse_c, inverse_c, L::load(b.stiffness + i));
    simd::vec_store(simd::Row{b.a[0], b.a[1], b.a[2]}, i, f.first);
    simd::vec_store(simd::Row{b.c[0], b.c[1], b.c[2]}, i, f.last);
  }
}

}  // namespace
}  // namespace drape::forces
