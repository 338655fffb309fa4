// Parts of scene_check, and what their messages share.
#pragma once
#include <cstdio>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace drape {

using Problems = std::vector<Problem>;

inline std::string rounded(double value) {  // for numbers that have been computed
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

inline std::string point_text(Vec2 p) { return "[" + rounded(p[0]) + ", " + rounded(p[1]) + "] m"; }

inline std::string entry(const std::string& path, std::size_t i) {
  return path + "[" + std::to_string(i) + "]";
}

// Diagrams, and what they are worked up from.
void fabric_check(const Scene& scene, const FabricSpec& fabric, Problems& problems);

// Seams against their pieces and each other; `sound` as below.
void seams_check(const Scene& scene, const std::vector<bool>& sound, Problems& problems);

// What is allowed of a force that depends on velocity, above order 2.
std::string order_allows(int order);

// Pins and probes against their pieces and each other; `sound[p]`: piece p has an outline without fault.
void pins_check(const Scene& scene, const std::vector<bool>& sound, Problems& problems);

}  // namespace drape
