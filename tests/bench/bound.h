// The shortest time that the arithmetic ports allow for one particle's step.
#pragma once
#include "bench/cloths.h"
#include "bench/ports.h"

namespace drape::bench {

// Operations of one particle's step, each link and hinge once, whatever the order of work:
//
//   stretch and shear, 4 links:    12 differences of coordinates                    add 12
//     squares of lengths                                                            fma 12
//     lengths, and their inverses two at a time: 1/l0 = l1/(l0 l1)     sqrt 4, division 2, fma 6
//     strain, law, width and inverse, one product each                              fma 16
//     pulls 12; added up at both ends of 4 links, but the first           fma 12,   add 21
//   loads: place and velocity of the particle, its mass and share; shares of hinges              load 8 + 2
//   motion: F/m + g, v, r, by coordinate                                            fma 9
//   hinges, 2: units of 2 links                                                     fma 6
//     cosine 3, series 15, moment and arms 4; forces on two ends 6 + 6        2 x   fma 34
//     third node 3, added up at three nodes 9                                 2 x   add 12
struct Operations {
  int fma, add, sqrt, division, load;
};
inline constexpr Operations kStretchShearOperations{55, 33, 4, 2, 8},
    kHingesOperations{55 + 6 + 68, 33 + 24, 4, 2, 10};

// Million particle-steps per second. Multiplications, additions, the divider and loads use separate ports.
double port_bound(const Operations& operations, const Ports& ports);

}  // namespace drape::bench
