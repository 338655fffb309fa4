// The cross-sections of a dress form.
#pragma once
#include <array>
#include <vector>

#include "command/dress_form/form.h"

namespace drape::command {

constexpr int kAround = 72;  // points of a ring
constexpr int kColumns = 6;  // y, w, f, b, p, l
using Section = std::array<double, kColumns>;

struct Breasts {
  double y, x, width, height, depth;  // m
};

struct Torso {
  Breasts breasts;
  std::vector<Section> sections;  // of all rings, from below
};

// The sections that have the girths of the measures at their heights.
Torso torso_fit(const Measures& measures);

// The points (x, z) of a section, in m, counter-clockwise seen from below.
std::vector<Vec2> section_ring(const Section& section, const Breasts& breasts);

}  // namespace drape::command
