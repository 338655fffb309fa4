// Splitting methods of higher order: one step as several kicks and drifts.
//
//     kick k    v <- v + b_k h a(r, t)                             k = 1 .. s + 1
//     drift k   r <- r + v (1 - e^(-c a_k h))/c,  v <- e^(-c a_k h) v,  t <- t + a_k h     k = 1 .. s
//
// The drift is the exact motion under -m c v alone, so the kicks see a force of place and time only: [B, [B,
// [B, A]]] = 0 for the fields A of drifts and B of kicks, and methods made for r'' = f(r, t) (Runge, Kutta,
// Nystroem) keep their order with damping, and with pins that move. The last kick of a step and the first of
// the next are at one place: s forces a step.
#pragma once

namespace drape::model {

struct Composition {
  int order, stages;
  const double* kick;   // [stages + 1] b, sum 1
  const double* drift;  // [stages] a, sum 1
  double limit;         // h omega up to which a linear oscillator is bounded
};

// Of the orders above 2; null for order 2, which is plain leapfrog.
const Composition* composition_of(int order);

// c h at most, for which the limit holds with damping.
inline constexpr double kDampedStep = 10;

}  // namespace drape::model
