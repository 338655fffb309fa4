// sum m v^2/2 of the particles, J.
#pragma once
#include "model/system.h"

namespace drape::model {

inline double kinetic_energy(const System& system, const Array& vx, const Array& vy, const Array& vz) {
  double sum = 0;
  for (std::size_t n : system.particle)
    sum += system.mass[n] * (vx[n] * vx[n] + vy[n] * vy[n] + vz[n] * vz[n]);
  return sum / 2;
}
inline double kinetic_energy(const System& system, const State& s) {
  return kinetic_energy(system, s.vx, s.vy, s.vz);
}

}  // namespace drape::model
