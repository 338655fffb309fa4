// The heavy elastica: a strip that leaves a clamp level and bends under its weight, theta its fall below the
// level at the share s of its length l, B its rigidity and rho its mass per area:
//
//     theta'' = -beta (1 - s) cos theta,   theta(0) = 0,   theta'(1) = 0,       beta = rho g l^3/B.
//
// With phi = pi/2 - theta and v = beta^(1/3) (1 - s), counted from the free end,
//
//     phi'' = v sin phi,   phi(0) = delta,   phi'(0) = 0,   phi = pi/2 at v = beta^(1/3):
//
// one integration for each delta gives beta and all the rest, and nothing is to be shot for.
#pragma once
#include <vector>

#include "scene/scene.h"

namespace drape {

struct Elastica {
  double beta = 0;
  double out = 0, down = 0;  // of the free end from the clamp, over l
};

Elastica elastica_of_load(double beta);    // 0 < beta < 1e6
Elastica elastica_of_drop(double drop);    // f/l, 0 < f/l < 0.995; its beta is A(f/l) of GOST 10550
Elastica elastica_of_slope(double angle);  // the line from the clamp to the end falls by the angle (rad)

// Out and down over l at n + 1 equal steps from the clamp on.
std::vector<Vec2> elastica_shape(double beta, int n);

}  // namespace drape
