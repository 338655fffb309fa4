// Splitting methods of higher order: one step is a sequence of kicks and drifts.
//
//     kick k    v <- v + b_k h a(r, t)                             k = 1 .. s + 1
//     drift k   r <- r + v (1 - e^(-c a_k h))/c,  v <- e^(-c a_k h) v,  t <- t + a_k h     k = 1 .. s
//
// The drift is the exact motion under the damping force -m c v alone. The kicks then see a force of position
// and time only: [B, [B, [B, A]]] = 0 for the vector fields A of drifts and B of kicks. So methods for
// r'' = f(r, t) (Runge, Kutta, Nystroem) keep their order with damping and with moving pins. The last kick of
// a step and the first of the next act at the same positions: one step takes s forces.
#pragma once

namespace drape::model {

struct Composition {
  int order, stages;
  const double* kick;   // [stages + 1] b, sum 1
  const double* drift;  // [stages] a, sum 1
  double limit;         // 1, largest h omega for which a linear oscillator stays bounded
};

// The method of order 4 or 6; null for order 2, which is plain leapfrog.
const Composition* composition_of(int order);

// 1, largest c h for which the limit holds with damping.
inline constexpr double kDampedStep = 10;

}  // namespace drape::model
