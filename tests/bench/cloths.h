// The cloths of the benchmark: squares of any number of particles, with the features that a step may have to
// compute.
#pragma once
#include <string>

#include "dynamics/advance.h"

namespace drape::bench {

// What a cloth's step computes beside stretch, shear and gravity.
struct Features {
  const char* name;
  int points = 1;        // of each diagram; 1 = straight
  bool bending = false;  // along warp and weft, of different rigidity
  bool cut = false;      // a disc whose outline cuts cells all round, at a grain of 20 degrees
  double damping = 0;    // c, 1/s
  double springs = 0;    // beta, s
  bool air = false;
  bool energy = false;  // the energy balance is computed
  int layers =
      0;  // with self-contact: 1, alone; 2, two squares that lie on each other, of half the particles
};

inline constexpr Features kStretchShear{"stretch and shear"};
inline constexpr Features kHinges{"with hinges", 1, true};
inline constexpr Features kFull{"full model", 16, true, true, 2};

// About `side` squared particles in cells of 1 cm.
Scene scene_of(const Features& features, int side);

// A cloth that is ready to step.
struct Ready {
  System system;
  State state;
  dynamics::Motion motion;
  double step = 0;  // s
};
Ready ready_at_start(const Scene& scene, int threads = 1);  // as in the scene, with the automatic step

// The same, crumpled a little, in steps of a fixed size.
Ready ready(const Scene& scene, int threads = 1);

}  // namespace drape::bench
