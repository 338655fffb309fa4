// A panel of a GarmentCode pattern: a loop of edges between vertices, placed in space.
#pragma once
#include "command/garmentcode/json.h"

namespace drape::command {

struct Panel {
  std::string name, label;               // as in the file
  std::vector<Vec2> outline;             // [edges] m: where each edge starts
  std::vector<scene::CurveSpec> curves;  // m
  std::vector<std::string> edge_label;   // [edges]
  Vec3 origin{0, 0, 0}, axis_x{1, 0, 0}, axis_y{0, 1, 0};
};

struct PatternUnits {
  double per_metre = 100;
  bool absolute = false;  // true: control points are points of the panel; false: shares of their edge
};

// Edge i of the file becomes edge i of the panel. A panel with a fault has no outline.
Panel panel_read(const JsonFaults& faults, const Json& json, const std::string& name,
                 const PatternUnits& units);

// The first two columns of Rz Ry Rx. Angles are in degrees.
void panel_axes(const std::vector<double>& degrees, Vec3& axis_x, Vec3& axis_y);

}  // namespace drape::command
