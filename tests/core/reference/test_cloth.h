// Small cloths for the tests of the reference solver, and the errors that its error control allows.
#pragma once
#include <random>

#include "reference/lattice.h"

namespace drape::reference {

constexpr double kG = 9.81;  // m/s^2, the default gravity

inline scene::DiagramSpec diagram(std::vector<double> elongation, std::vector<double> force) {
  return {std::move(elongation), std::move(force), {}};
}

// A straight law of the given slope per width (N/m) on a 50 mm strip.
inline scene::DiagramSpec straight(double slope) { return diagram({0, 1}, {0, slope * 0.05}); }

// A warp-only fabric with a straight law of k (N/m).
inline scene::FabricSpec threads(double k) {
  scene::FabricSpec fabric;
  fabric.name = "threads";
  fabric.areal_density = 0.15;
  fabric.warp = straight(k);
  return fabric;
}

// Curved laws with widely spaced points, so that they are smooth over differences of a micrometre. Bending
// differs between warp and weft.
inline scene::FabricSpec curved_fabric() {
  scene::FabricSpec fabric;
  fabric.name = "curved";
  fabric.areal_density = 0.15;
  fabric.thickness = 4e-4;
  fabric.warp = diagram({0, 0.1, 0.25, 0.4}, {0, 4, 18, 45});
  fabric.weft = diagram({0, 0.15, 0.3}, {0, 2, 9});
  fabric.bias = diagram({0, 0.05, 0.1, 0.15}, {0, 0.3, 1, 2.5});
  fabric.bending_warp = 4e-6;
  fabric.bending_weft = 7e-6;
  fabric.poisson = 0.2;
  fabric.compression = 0.5;
  fabric.compression_blend = 0.05;
  return fabric;
}

// A rectangle of a fabric in the horizontal plane, or hanging (y up); width along the weft.
inline Scene rectangle(const scene::FabricSpec& fabric, double width, double height, double cell,
                       bool hanging = false) {
  Scene scene;
  scene.name = "rectangle";
  scene.fabrics = {fabric};
  scene::PieceSpec piece;
  piece.name = "sheet";
  piece.fabric = 0;
  piece.cell = cell;
  piece.outline = {{0, 0}, {width, 0}, {width, height}, {0, height}};
  if (hanging) piece.place.axis_y = {0, 0, 1};
  scene.pieces = {piece};
  return scene;
}

inline scene::PinSpec pin_edges(const std::string& name, std::vector<int> edges) {
  return {name, 0, {}, std::move(edges)};
}
inline scene::PinSpec pin_at(const std::string& name, std::vector<Vec2> at) {
  return {name, 0, std::move(at), {}};
}

// Straight, soft laws are smooth in the positions, so every method shows its own order.
inline Scene smooth_scene() {
  scene::FabricSpec fabric = threads(8);
  fabric.weft = straight(5);
  fabric.bias = straight(2);
  fabric.bending_warp = 2e-6;
  fabric.bending_weft = 1e-6;
  Scene scene = rectangle(fabric, 0.03, 0.03, 0.01);
  scene.damping = 3;
  scene.bias_model = scene::BiasModel::kPaper;
  scene.pins = {pin_at("corner", {{0, 0}}), pin_at("middle", {{0.017, 0.024}})};
  return scene;
}

// Every particle moved by up to `amplitude` (m) along each axis.
inline Eigen::VectorXd crumpled(const Lattice& lattice, double amplitude, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-amplitude, amplitude);
  Eigen::VectorXd r = lattice.position;
  for (double& x : r) x += shift(random);
  return r;
}

// The largest error that the error control allows while errors do not grow. Each step adds rtol (|v| + 1
// m/s) to a velocity and rtol (|r| + cell) to a position, which then moves with the wrong velocity.
inline double velocity_slack(long steps, double rtol, double v) { return double(steps) * rtol * (v + 1); }
inline double position_slack(long steps, double rtol, double r, double cell, double v, double time) {
  return double(steps) * rtol * (r + cell) + velocity_slack(steps, rtol, v) * time;
}

}  // namespace drape::reference
