// Bending: hinges between consecutive links of a yarn [P section 2; core/README.md, section 3].
//
//              o x2        u = (x1 - x0)/|a|,  v = (x2 - x1)/|c|,  y = u.v = cos theta
//        v    /
//            / theta       E = kappa theta^2/2,  dE/dy = -kappa psi(y),  psi = theta/sin theta
//   o-------o
//   x0  u   x1             force on x2 = kappa psi (u - y v)/|c|,  on x0 = -kappa psi (v - y u)/|a|,
//                          on x1 minus the sum of both
//
// Each force is normal to its link and inversely proportional to the link's present length. So there is no
// net force and no net torque. A missing hinge has the share 0.
//
// psi without trigonometry: psi(y) = acos(y)/sqrt(1 - y^2) is analytic except at y = -1. On y in [1/2, 1],
// folds of up to 60 degrees, its Chebyshev series in 4y - 3 decreases as (7 + sqrt(48))^-n; degree 13 is
// exact to 6e-17. With h = cos(theta/2) = sqrt((1 + y)/2), psi(y) = psi(h)/h, so the same series serves up to
// 120 degrees. Beyond, psi continues as its second-order Taylor polynomial.
#pragma once
#include <numbers>

#include "forces/bending_constants.h"
#include "simd/vector_lanes.h"

namespace drape::forces {
namespace {

inline constexpr double kPsiSeries[] = {
    1.0926714764020715,     -0.10314079582768367,    0.011743165282346662,   -0.001434957734289709,
    0.0001819779796087013,  -2.3612156859992877e-05, 3.11163578297139e-06,   -4.1467602308018345e-07,
    5.5733945603696164e-08, -7.54052908486172e-09,   1.0237755548669992e-09, -1.3986077184953492e-10,
    2.0541559585752153e-11, -2.8263080717976547e-12};

// psi(y) for y in [1/2, 1]
template <class L>
DRAPE_INLINE L bending_series(L y) {
  const L z = fma(y, L(4.0), L(-3.0));
  const L z2 = z * z;  // two short dependency chains instead of a long one
  L even = kPsiSeries[12], odd = kPsiSeries[13];
  for (int k = 10; k >= 0; k -= 2) {
    even = fma(even, z2, L(kPsiSeries[k]));
    odd = fma(odd, z2, L(kPsiSeries[k + 1]));
  }
  return fma(odd, z, even);
}

// psi(y) for y below 1/2
template <class L>
DRAPE_INLINE L bending_folded(L y) {
  const L h = sqrt(fma(max(y, L(kSharp)), L(0.5), L(0.5)));
  const L d = y - L(kSharp);
  const L sharp = fma(d, fma(d, L(kSharpPsi2 / 2), L(kSharpPsi1)), L(kSharpPsi));
  return select(ge(y, L(kSharp)), bending_series(h) / h, sharp);
}

template <class L>
DRAPE_INLINE L bending_psi(L y) {
  const L psi = bending_series(y);
  const auto folded = gt(L(0.5), y);
  return any(folded) ? select(folded, bending_folded(y), psi) : psi;
}

// theta^2/2 = psi^2 sin^2 theta/2 from the cosine and the square of the sine; beyond 120 degrees the
// continuation that belongs to psi.
template <class L>
DRAPE_INLINE L bending_energy(L cosine, L sine2) {
  constexpr double kTheta = 2 * std::numbers::pi / 3;
  const L psi = bending_psi(max(cosine, L(kSharp))), d = L(kSharp) - cosine;
  const L sharp =
      fma(d, fma(d, fma(d, L(kSharpPsi2 / 6), L(-kSharpPsi1 / 2)), L(kSharpPsi)), L(kTheta * kTheta / 2));
  return select(ge(cosine, L(kSharp)), L(0.5) * (psi * psi) * sine2, sharp);
}

// Forces on the two ends of a hinge of stiffness kappa between links (u, 1/|a|) and (v, 1/|c|).
template <class L>
struct HingeForces {
  simd::Vec<L> first, last;
};
template <class L>
DRAPE_INLINE HingeForces<L> bending_hinge(simd::Vec<L> u, L inverse_a, simd::Vec<L> v, L inverse_c, L kappa) {
  const L y = select(gt(kappa, L(0.0)), dot(u, v), L(1.0));  // no hinge: no fold
  const L moment = kappa * bending_psi(y);
  const auto turned = [&](L a, L b) DRAPE_INLINE_LAMBDA { return fms(a, y, b); };
  const simd::Vec<L> first{turned(u.x, v.x), turned(u.y, v.y), turned(u.z, v.z)},
      last{turned(v.x, u.x), turned(v.y, u.y), turned(v.z, u.z)};
  return {first * (moment * inverse_a), last * (L(0.0) - moment * inverse_c)};
}

// A link, for its hinges: unit vector and inverse length.
template <class L>
struct HingeLink {
  simd::Vec<L> unit;
  L inverse;  // 1/m
};
template <class L>
DRAPE_INLINE HingeLink<L> hinge_link(simd::Vec<L> from, simd::Vec<L> to, L inverse) {
  return {(to - from) * inverse, inverse};
}

// Hinges along a row of weft links, in the order of i. Hinge i + 1 lies between links i and i + 1 and acts on
// nodes i, i + 1 and i + 2. Its forces on the later two are passed on to the next lane:
//
//   F_i += f_i - g_(i-1),   g_i = f_i + l_i - l_(i-1);   f, l of hinge i + 1 on its first and last node
template <class L>
struct WeftHinges {
  HingeLink<L> links;         // links i, i + 1, ...
  simd::Vec<L> last, passed;  // l and g of the previous lane
};
template <class L>
DRAPE_INLINE simd::Vec<L> bending_weft(const HingeLink<L>& next, L kappa, WeftHinges<L>& w) {
  const auto f = bending_hinge(w.links.unit, w.links.inverse, ahead(w.links.unit, next.unit),
                               ahead(w.links.inverse, next.inverse), kappa);
  const simd::Vec<L> passed = f.first + (f.last - shifted(w.last, f.last));
  const simd::Vec<L> force = f.first - shifted(w.passed, passed);
  w = {next, f.last, passed};
  return force;
}

}  // namespace
}  // namespace drape::forces
