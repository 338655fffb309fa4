// A dress form: a tailor's torso from the upper thigh to the neck, with smooth cross-sections.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace drape::command {

// Measures of the body. Girths are taken with a tape measure.
struct Measures {
  double bust = 0.88, waist = 0.68, hips = 0.94;  // m, girths
  double height = 1.66;                           // m
};

// The heights of the girths, as shares of the body's height.
constexpr double kBustHeight = 0.732, kWaistHeight = 0.6265, kHipsHeight = 0.5024;

// Appends a problem for every measure that is out of its range.
void measures_check(const Measures& measures, std::vector<Problem>& problems);

struct Mesh {
  std::vector<Vec3> vertices;                 // m, y up, z to the front, the floor at y = 0
  std::vector<std::array<int, 3>> triangles;  // counter-clockwise from outside
};

// A closed mesh. The girths of its sections at the three heights are those of the measures.
Mesh form_make(const Measures& measures);

std::string mesh_obj(const Mesh& mesh, const std::string& title);

// The length (m) of a tape round points of the plane: the length of their convex hull.
double tape_length(std::vector<Vec2> points);

}  // namespace drape::command
