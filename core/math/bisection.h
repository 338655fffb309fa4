// The root of a monotone function.
#pragma once

namespace drape::math {

// The x in [low, high] at which the increasing function `value` passes `target`. The interval is halved until
// no double lies inside it.
template <class Function>
double bisect_rising(Function value, double target, double low, double high) {
  for (;;) {
    const double middle = low + (high - low) / 2;
    if (!(middle > low && middle < high)) return middle;
    (value(middle) < target ? low : high) = middle;
  }
}

}  // namespace drape::math
