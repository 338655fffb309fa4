// Contact and the constraints of pins, welds and links act on the same particles. They respond in turns until
// no turn changes a velocity any more: block Gauss-Seidel on one complementarity problem.
#pragma once

namespace drape::dynamics {

struct Agreement {
  double tolerance;  // of the first change of a velocity by contact
  int turns;         // at most
};
inline constexpr Agreement kAgreeInMotion{1e-4, 10}, kAgreeInFit{1e-4, 100}, kAgreeAtRest{1e-9, 1000};

// `contact` responds to what the constraints have left and returns the largest change of a velocity;
// `constraints` projects what it has changed. `first`: the largest change by contact before.
template <class Contact, class Constraints>
void agree(Agreement within, double first, Contact contact, Constraints constraints) {
  for (int turn = 0; turn < within.turns; ++turn) {
    const double change = contact();
    if (change > 0) constraints();
    if (!(change > within.tolerance * first)) return;
  }
}

}  // namespace drape::dynamics
