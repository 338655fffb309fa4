// The outline of a piece as straight segments, and the checks of outlines. core/README.md, section 1.
#pragma once
#include <string>
#include <vector>

#include "scene/scene.h"

namespace drape::piece {

// A closed loop. Segment k runs from point k to the next point, the last one back to point 0. The cloth is to
// the left.
struct OutlineLoop {
  std::vector<Vec2> points;
  std::vector<int> edge;  // [points] the edge of the scene of which segment k is a part
};

// The outer boundary, counter-clockwise, then the holes, clockwise. Curves become chords.
std::vector<OutlineLoop> outline_flatten(const scene::PieceSpec& piece);

// Points (m) of one edge of the outer boundary from its start to its end, both included.
std::vector<Vec2> outline_edge(const scene::PieceSpec& piece, int edge);

double outline_area(const std::vector<OutlineLoop>& loops);                  // m^2
bool outline_contains(const std::vector<OutlineLoop>& loops, Vec2 point);    // by even-odd crossings
double outline_distance(const std::vector<OutlineLoop>& loops, Vec2 point);  // m; 0 inside the piece
double outline_touch(const scene::PieceSpec& piece);  // m; points closer than this touch

// The same for a polygon as given in the scene: a region or a hole.
double polygon_area(const std::vector<Vec2>& polygon);  // > 0 if counter-clockwise
double polygon_distance(const std::vector<Vec2>& polygon, Vec2 point);
Vec2 polygon_centre(const std::vector<Vec2>& polygon);  // centroid of its area
double polygons_distance(const std::vector<std::vector<Vec2>>& rim_and_holes, Vec2 point);

// Appends all geometrical faults of a piece. `path` names it, "piece.sheet". grid_make accepts a piece
// without faults.
void outline_problems(const scene::PieceSpec& piece, const std::string& path, std::vector<Problem>& problems);

// Appends the faults of a single polygon, "pin.rim.region": fewer than 3 points, repeated points, no area,
// crossings.
void polygon_problems(const std::vector<Vec2>& polygon, const std::string& path,
                      std::vector<Problem>& problems);

}  // namespace drape::piece
