// Pieces that are not rectangles: slanted and round, with holes, darts and slits that split cells. Cells of
// 1 cm.
#pragma once
#include <cmath>
#include <numbers>

#include "reference/test_cloth.h"

namespace drape::tests {

enum class Shape { kRectangle, kTriangle, kDiscWithHole, kDart, kSlits };
inline constexpr Shape kCutShapes[] = {Shape::kTriangle, Shape::kDiscWithHole, Shape::kDart, Shape::kSlits};

inline const char* shape_name(Shape shape) {
  const char* names[] = {"rectangle", "triangle", "disc_with_hole", "dart", "slits"};
  return names[int(shape)];
}

inline std::vector<Vec2> circle(Vec2 centre, double radius, int corners) {
  std::vector<Vec2> points;
  for (int k = 0; k < corners; ++k) {
    const double f = 2 * std::numbers::pi * k / corners;
    points.push_back({centre[0] + radius * std::cos(f), centre[1] + radius * std::sin(f)});
  }
  return points;
}

inline Scene cut_piece(const scene::FabricSpec& fabric, Shape shape) {
  Scene scene = reference::rectangle(fabric, 0.074, 0.0522, 0.01);
  scene::PieceSpec& piece = scene.pieces[0];
  switch (shape) {
    case Shape::kRectangle:
      break;
    case Shape::kTriangle:
      piece.outline = {{0, 0}, {0.083, 0.011}, {0.027, 0.071}};
      piece.grain = 0.3;
      break;
    case Shape::kDiscWithHole:
      piece.outline = circle({0.04, 0.04}, 0.038, 32);
      piece.holes = {circle({0.043, 0.037}, 0.013, 16)};
      break;
    case Shape::kDart:  // narrow, across grid lines
      piece.outline = {{0, 0},           {0.08, 0},      {0.08, 0.06}, {0.0475, 0.06},
                       {0.0431, 0.0213}, {0.0433, 0.06}, {0, 0.06}};
      break;
    case Shape::kSlits:  // one along the warp, one along the weft
      piece.outline = {{0, 0},       {0.08, 0},      {0.08, 0.0246},   {0.0423, 0.0247}, {0.08, 0.0248},
                       {0.08, 0.06}, {0.0352, 0.06}, {0.0351, 0.0263}, {0.035, 0.06},    {0, 0.06}};
      break;
  }
  return scene;
}

}  // namespace drape::tests
