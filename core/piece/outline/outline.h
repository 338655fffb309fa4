// The outline of a piece as straight segments, and what can be wrong with one. core/README.md, section 1.
#pragma once
#include <string>
#include <vector>

#include "scene/scene.h"

namespace drape::piece {

// Closed: segment k runs from point k to the next, the last one back to point 0. The cloth lies to its left.
struct OutlineLoop {
  std::vector<Vec2> points;
  std::vector<int> edge;  // [points] the edge, as the scene counts them, of which segment k is a part
};

// The rim, counter-clockwise, then the holes, clockwise.
std::vector<OutlineLoop> outline_flatten(const scene::PieceSpec& piece);

// Points of one edge of the rim from its start to its end, both included.
std::vector<Vec2> outline_edge(const scene::PieceSpec& piece, int edge);

double outline_area(const std::vector<OutlineLoop>& loops);                  // m^2
bool outline_contains(const std::vector<OutlineLoop>& loops, Vec2 point);    // by even-odd crossings
double outline_distance(const std::vector<OutlineLoop>& loops, Vec2 point);  // m; 0 within the piece
double outline_touch(const scene::PieceSpec& piece);  // m: what lies closer than that touches

// The same for a polygon as the scene gives it: a region, a hole.
double polygon_area(const std::vector<Vec2>& polygon);  // > 0 if counter-clockwise
double polygon_distance(const std::vector<Vec2>& polygon, Vec2 point);
Vec2 polygon_centre(const std::vector<Vec2>& polygon);  // of its area
double polygons_distance(const std::vector<std::vector<Vec2>>& rim_and_holes, Vec2 point);

// All geometrical faults of a piece; `path` names it, "piece.sheet". A piece without one can be laid out by
// grid_make.
void outline_problems(const scene::PieceSpec& piece, const std::string& path, std::vector<Problem>& problems);

// The same for a polygon alone, "pin.rim.region": fewer than 3 points, repeated ones, no area, crossings.
void polygon_problems(const std::vector<Vec2>& polygon, const std::string& path,
                      std::vector<Problem>& problems);

}  // namespace drape::piece
