// Panels of an imported pattern, placed near a body.
#include "command/garmentcode/place_near.h"

#include <gtest/gtest.h>

namespace drape::command {
namespace {

// 12 mm off the body: from afar, and where the body comes through a little.
TEST(ImportPlace, PutsPanelsNearTheBodyAndOutside) {
  for (const double belly : {0.1, 0.23}) {
    Scene scene;
    scene::PieceSpec front;
    front.outline = {{-0.2, 0}, {0.2, 0}, {0.2, 0.5}, {-0.2, 0.5}};
    front.place.origin = {0, 1, 0.2};
    scene.pieces = {front};
    std::vector<Vec3> body{{0.1, 1.2, belly}};
    for (const double y : {1.0, 1.25, 1.5})
      for (const double x : {-0.15, 0.15})
        for (const double z : {-0.1, 0.1}) body.push_back({x, y, z});
    garment_place_near(scene, body);
    EXPECT_NEAR(scene.pieces[0].place.origin[2], belly + 0.012, 1e-12);
  }
}

// A panel 0.4 m x 0.5 m across z, its lower edge at y = 1, and a box of points about the axis of y.
scene::PieceSpec panel_at(double x, double z, double width = 0.4, double height = 0.5) {
  scene::PieceSpec panel;
  panel.outline = {{-width / 2, 0}, {width / 2, 0}, {width / 2, height}, {-width / 2, height}};
  panel.place.origin = {x, 1, z};
  return panel;
}
std::vector<Vec3> box_points(double low, double high, double half) {  // of y; of z
  std::vector<Vec3> points;
  for (int k = 0; k <= 10; ++k)
    for (const double x : {-0.15, 0.0, 0.15})
      for (const double z : {-half, half}) points.push_back({x, low + k * (high - low) / 10, z});
  return points;
}
double placed(const scene::PieceSpec& panel, const std::vector<Vec3>& body) {
  Scene scene;
  scene.pieces = {panel};
  garment_place_near(scene, body);
  EXPECT_EQ(scene.pieces[0].place.origin[0], panel.place.origin[0]);
  EXPECT_EQ(scene.pieces[0].place.origin[1], panel.place.origin[1]);
  return scene.pieces[0].place.origin[2];
}

// The body's surface at z = 0.1 or -0.1: 12 mm off it on the side where most of the panel is.
TEST(ImportPlace, PutsAPanelOutsideWhereverItIs) {
  const std::vector<Vec3> whole = box_points(0.9, 1.6, 0.1), low = box_points(0.9, 1.2, 0.1);
  EXPECT_NEAR(placed(panel_at(0, 0.3), whole), 0.112, 1e-12);
  EXPECT_NEAR(placed(panel_at(0, -2), whole), -0.112, 1e-12) << "far off";
  EXPECT_NEAR(placed(panel_at(0, 0.105), whole), 0.105, 1e-12) << "near enough";
  EXPECT_NEAR(placed(panel_at(0, 0.05), low), 0.112, 1e-12) << "with its lower half in the body";
  EXPECT_NEAR(placed(panel_at(0, 0.05), whole), 0.112, 1e-12) << "wholly in it";
  EXPECT_NEAR(placed(panel_at(2, 0.3), whole), 0.3, 1e-12) << "beside it";
  EXPECT_NEAR(placed(panel_at(0, 0.1), {}), 0.1, 1e-12) << "no body";
  // in the middle of a body of which 0.25 m are on either side: left to the scene's own check
  EXPECT_NEAR(placed(panel_at(0, 0), box_points(0.9, 1.6, 0.25)), 0, 1e-12);
}

// A pocket on a panel, and a flap on both, stay over it in their order, 12 mm from one to the next. Panels
// beside each other stay in one plane. Front and back are independent.
TEST(ImportPlace, KeepsLayersApart) {
  const std::vector<Vec3> body = box_points(0.9, 1.6, 0.1);
  Scene scene;
  scene.pieces = {panel_at(0.05, 0.35, 0.08, 0.1), panel_at(0.05, 0.32, 0.1, 0.12), panel_at(0, 0.3),
                  panel_at(0, -0.3), panel_at(0.41, 0.3)};
  scene.pieces[4].outline[0][0] = scene.pieces[4].outline[3][0] = -0.3;  // 0.09 m over the front
  garment_place_near(scene, body);
  EXPECT_NEAR(scene.pieces[2].place.origin[2], 0.112, 1e-12);
  EXPECT_NEAR(scene.pieces[1].place.origin[2], 0.124, 1e-12);
  EXPECT_NEAR(scene.pieces[0].place.origin[2], 0.136, 1e-12);
  EXPECT_NEAR(scene.pieces[3].place.origin[2], -0.112, 1e-12);
  EXPECT_NEAR(scene.pieces[4].place.origin[2], 0.112, 1e-12);
}

}  // namespace
}  // namespace drape::command
