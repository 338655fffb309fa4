// What a cloth tells of itself: fills drape_outputs from System and State. Reads the motion, never changes
// it.
#pragma once
#include "drape/drape.h"
#include "dynamics/advance.h"

namespace drape::outputs {

// The struct handed to users and what it points to.
struct Outputs {
  drape_outputs c_view{};
  std::vector<drape_probe> probes;
  std::vector<drape_pin> pins;
  std::vector<drape_seam> seams;
  std::vector<drape_body> bodies;
  std::vector<double> node_position, node_velocity;  // empty until they are wanted
  Array velocity[3];                                 // [nodes] m/s, at the present time
  std::vector<math::Wrench> pin_load;
  dynamics::HalfKick half_kick;
};

// Room and names; the scene's names must outlive the result, which must not move afterwards.
void outputs_make(Outputs& outputs, const Scene& scene, const System& system);

// mask: which groups to fill, bits DRAPE_OUT_POSITION and so on. The others keep what they held.
void outputs_fill(Outputs& outputs, const System& system, dynamics::Motion& motion, const State& state,
                  int mask);

}  // namespace drape::outputs
