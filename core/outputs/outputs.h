// Fills drape_outputs from System and State. Reads the motion, never changes it.
#pragma once
#include "drape/drape.h"
#include "dynamics/advance.h"

namespace drape::outputs {

// The struct that users see, and the arrays that it points to.
struct Outputs {
  drape_outputs c_view{};
  std::vector<drape_probe> probes;
  std::vector<drape_pin> pins;
  std::vector<drape_seam> seams;
  std::vector<drape_body> bodies;
  std::vector<double> node_position, node_velocity;  // [particles x 3] m, m/s; empty until first asked for
  Array velocity[3];                                 // [nodes] m/s, at the present time
  std::vector<math::Wrench> pin_load;                // [pins] N, N m
  dynamics::HalfKick half_kick;                      // of the same call as `velocity`
};

// Allocates the outputs and sets their names. The scene's names must outlive the result, and the result must
// not move in memory.
void outputs_make(Outputs& outputs, const Scene& scene, const System& system);

// Fills the groups of `mask`, bits DRAPE_OUT_POSITION and so on. The other groups keep their values.
void outputs_fill(Outputs& outputs, const System& system, dynamics::Motion& motion, const State& state,
                  int mask);

}  // namespace drape::outputs
