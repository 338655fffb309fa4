// Bending: hinges between consecutive edges of a thread [P section 2; core/README.md, section 3].
//
//              o x2        u = (x1 - x0)/|a|,  v = (x2 - x1)/|c|,  y = u.v = cos theta
//        v    /
//            / theta       E = kappa theta^2/2,  dE/dy = -kappa psi(y),  psi = theta/sin theta
//   o-------o
//   x0  u   x1             force on x2 = kappa psi (u - y v)/|c|,  on x0 = -kappa psi (v - y u)/|a|,  on x1
//   minus both
//
// The force is normal to each edge and shorter by its present length: no net force, no net torque. The share
// of a missing hinge is 0.
//
// psi without trigonometry: with h = cos(theta/2) = sqrt((1 + y)/2), psi(y) = Q(h)/h, Q(h) = acos(h)/sqrt(1 -
// h^2). Q is analytic but at h = -1; on h in [1/2, 1], theta up to 120 degrees, its Chebyshev series in 4h -
// 3 falls as (7 + sqrt(48))^-n: degree 13 is exact to 6e-17. Beyond 120 degrees psi goes on by its
// second-order Taylor polynomial.
#pragma once
#include "forces/bending_constants.h"
#include "forces/rows.h"

namespace drape {
namespace {

inline constexpr double kPsiSeries[] = {
    1.0926714764020715,     -0.10314079582768367,    0.011743165282346662,   -0.001434957734289709,
    0.0001819779796087013,  -2.3612156859992877e-05, 3.11163578297139e-06,   -4.1467602308018345e-07,
    5.5733945603696164e-08, -7.54052908486172e-09,   1.0237755548669992e-09, -1.3986077184953492e-10,
    2.0541559585752153e-11, -2.8263080717976547e-12};

template <class L>
DRAPE_INLINE L bending_psi(L y) {
  const L h = sqrt(fma(max(y, L(kSharp)), L(0.5), L(0.5)));
  const L z = fma(h, L(4.0), L(-3.0));
  const L z2 = z * z;  // two short chains instead of a long one
  L even = kPsiSeries[12], odd = kPsiSeries[13];
  for (int k = 10; k >= 0; k -= 2) {
    even = fma(even, z2, L(kPsiSeries[k]));
    odd = fma(odd, z2, L(kPsiSeries[k + 1]));
  }
  const L q = fma(odd, z, even);
  const L d = y - L(kSharp);
  const L sharp = fma(d, fma(d, L(kSharpPsi2 / 2), L(kSharpPsi1)), L(kSharpPsi));
  return select(ge(y, L(kSharp)), q / h, sharp);
}

// Forces on the two ends of a hinge of stiffness kappa between links (u, 1/|a|) and (v, 1/|c|).
template <class L>
struct HingeForces {
  Vec<L> first, last;
};
template <class L>
DRAPE_INLINE HingeForces<L> bending_hinge(Vec<L> u, L inverse_a, Vec<L> v, L inverse_c, L kappa) {
  const L y = dot(u, v);
  const L moment = kappa * bending_psi(y);
  return {(u * y - v) * (moment * inverse_a), (u - v * y) * (moment * inverse_c)};
}

// Hinges across the warp links below and above a row; kappa = rigidity share[i].
template <class L>
DRAPE_INLINE void bending_warp_add(int n, const LinkRow& below, const LinkRow& above, const double* share,
                                   double rigidity, Row force_below, Row force, Row force_above) {
  for (int i = 0; i < n; i += L::kWidth) {
    const auto f =
        bending_hinge(vec_load<L>(below.unit, i), L::load(below.inverse + i), vec_load<L>(above.unit, i),
                      L::load(above.inverse + i), L(rigidity) * L::load(share + i));
    vec_add(force_below, i, f.first);
    vec_add(force_above, i, f.last);
    vec_store(force, i, vec_load<L>(force, i) - (f.first + f.last));
  }
}

// Hinges along a row of weft links: hinge i lies between links i - 1 and i.
template <class L>
DRAPE_INLINE void bending_weft_add(int n, const LinkRow& links, const double* share, double rigidity,
                                   Row first, Row last, Row force) {
  for (int i = 0; i < n; i += L::kWidth) {
    const auto f = bending_hinge(vec_load<L>(links.unit, i - 1), L::loadu(links.inverse + i - 1),
                                 vec_load<L>(links.unit, i), L::load(links.inverse + i),
                                 L(rigidity) * L::load(share + i));
    vec_store(first, i, f.first);
    vec_store(last, i, f.last);
  }
  for (int i = 0; i < n; i += L::kWidth) {
    const Vec<L> ends = vec_load<L>(first, i + 1) + vec_load<L>(last, i - 1);
    vec_add(force, i, ends - (vec_load<L>(first, i) + vec_load<L>(last, i)));
  }
}

}  // namespace
}  // namespace drape
