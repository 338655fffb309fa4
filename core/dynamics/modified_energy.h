// Leapfrog keeps an energy that differs from T + U by O(h^2), but for O(h^4), whatever the laws are (Hairer,
// Lubich, Wanner 2003, Acta Numerica 12, section 3.2, the modified Hamiltonian):
//
//     H = T + U + (h^2/12) v.(U'' v) - (h^2/24) F.(F/m).
//
// In linear cloth m v-.v+/2 + U is constant too, v- and v+ half a step before and after; but where energy
// moves into stiff vibrations, it falls by (h omega)^2/6 of what moves. What H differs by is the energy of
// the step. It grows with h^2, so a change of the step changes the constant, and so does a jump of v. Pins
// that move count as particles of infinite mass.
//
// The paper's scheme V' = V + h a, r' = r + h V' is leapfrog with V = v_{n-1/2}: its H is that of
// v = V + h a/2. From T + U, with the T of V as in outputs, it differs by O(h).
#pragma once
#include <array>

#include "drape/drape.h"
#include "dynamics/advance.h"

namespace drape::dynamics {

// J, the parts of the energy of the step that grow with h (in the paper's scheme alone), h^2 and h^4.
struct StepEnergy {
  double first = 0, second = 0, fourth = 0;
  double sum() const { return first + second + fourth; }
};

// At t_n, for steps of h (s).
struct ModifiedEnergy {
  drape_energy energy{};   // T and U, as in outputs
  StepEnergy step;         // 0 above order 2
  double h_less_work = 0;  // J, H less the work of pins and closing seams since the start
};
ModifiedEnergy modified_energy(const System& system, Motion& motion, State& state, double h);

// The parts of motion at the velocities v (m/s), by h U'' v = (F(x - h v) - F(x + h v))/2.
StepEnergy step_energy_of_motion(const System& system, Motion& motion, State& state,
                                 const std::array<Array, 3>& v, double h);

// True while seams are pulled shut. Forces that pull seams shut belong to no energy, and H changes by more
// than their work. What can be refined is compared by T + U, as outputs show it. At a given step that would
// be too strict: there it is m v-.v+/2 + U, which changes by their work alone in linear cloth. Every weld
// begins a new balance.
bool is_pulled(const State& state);

bool is_paper(const System& system);

}  // namespace drape::dynamics
