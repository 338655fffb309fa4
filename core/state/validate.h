// What must hold between the fields of a state that has been read, so that a step can go on from it.
#pragma once
#include <string>

#include "model/system.h"
#include "state/field.h"

namespace drape::state {

// The lengths of the lists in a state of this system.
Shape shape_of(const System& system);

// Empty, or the first problem. Each field alone has been checked. `rates`: forces depend on velocity.
std::string state_problem(const System& system, bool rates, const State& state);

}  // namespace drape::state
