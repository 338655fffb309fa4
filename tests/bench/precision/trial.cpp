#include "bench/precision/trial.h"

namespace drape::bench {
namespace {

constexpr double kCell = 0.01;  // m

scene::DiagramSpec diagram(std::vector<double> percent, std::vector<double> force) {
  for (double& e : percent) e /= 100;
  return {std::move(percent), std::move(force), {}};
}

scene::FabricSpec fabric(const char* name, double areal_density, double gauge, double ei_warp,
                         double ei_weft) {
  scene::FabricSpec f;
  f.name = name;
  f.areal_density = areal_density;
  f.thickness = 5e-4;
  f.strip_gauge = gauge;
  f.bending_warp = ei_warp;
  f.bending_weft = ei_weft;
  return f;
}

// Diagrams of examples/fabrics/cotton.toml.
scene::FabricSpec cotton() {
  scene::FabricSpec f = fabric("cotton", 0.15, 0.2, 6.3e-6, 4e-6);
  f.warp = diagram({0, 0.5, 1, 1.5, 2, 3, 4, 5, 6, 7},
                   {0, 1.14, 2.8, 5.2, 8.53, 18.47, 33.6, 54.72, 82.55, 117.71});
  f.weft = diagram({0, 0.5, 1, 2, 3, 4, 6, 8, 10, 12},
                   {0, 0.52, 1.14, 2.79, 5.18, 8.48, 18.35, 33.34, 54.27, 81.84});
  f.bias = diagram({0, 0.5, 1, 2, 3, 4, 6, 8, 10, 12, 14},
                   {0, 0.049, 0.099, 0.203, 0.313, 0.43, 0.696, 1.019, 1.421, 1.932, 2.59});
  return f;
}

// Every third raw point of the diagrams of examples/fabrics/wool.toml.
scene::FabricSpec wool() {
  scene::FabricSpec f = fabric("wool", 0.15, 0.1, 4.567e-6, 4.567e-6);
  f.warp = diagram(
      {0.0, 0.14584, 0.29168, 0.43753, 0.58337, 0.72921, 0.87505, 1.02089, 1.16674, 1.31258, 1.36119},
      {0.0, 0.9985, 2.49252, 4.9776, 9.94036, 20.84367, 36.66997, 59.87135, 94.86166, 136.16182, 149.90138});
  f.weft = diagram(
      {0.0, 1.2234, 2.4468, 3.6702, 4.8936, 6.117, 7.3404, 8.5638, 9.7872, 11.0106, 11.4184},
      {0.0, 0.49407, 1.46484, 2.89575, 4.77099, 9.19811, 13.75933, 21.67897, 32.84672, 47.83394, 52.60791});
  f.bias = diagram({0.0, 1.48869, 2.95455, 4.39725, 5.81645, 6.74938},
                   {0.0, 0.50737, 1.75276, 3.03888, 4.74166, 6.46674});
  return f;
}

// A square of (side - 1) cells, horizontal, or hanging in the plane of x and z. It is held along edge
// `held`, or at the two corners of that edge.
Scene square(const char* name, const scene::FabricSpec& f, int side, int held, bool corners, bool hanging) {
  const double l = (side - 1) * kCell;
  Scene s;
  s.name = name;
  s.clamp_correction = false;
  s.fabrics = {f};
  scene::PieceSpec piece;
  piece.name = "cloth";
  piece.fabric = 0;
  piece.cell = kCell;
  piece.outline = {{0, 0}, {l, 0}, {l, l}, {0, l}};
  if (hanging) piece.place.axis_y = {0, 0, 1};
  s.pieces = {piece};
  scene::PinSpec pin;
  pin.name = "pin";
  pin.piece = 0;
  if (corners) pin.at = {piece.outline[std::size_t(held)], piece.outline[std::size_t(held + 1) % 4]};
  else pin.edges = {held};
  s.pins = {pin};
  return s;
}

}  // namespace

std::vector<Trial> trials(bool quick) {
  const int side = quick ? 5 : 15;
  const double share = quick ? 0.1 : 1;
  Scene soft = square("soft cotton", cotton(), side, 2, true, false);
  Scene stiff = square("stiff wool", wool(), side, 2, true, false);
  Scene flag = square("flag in wind", cotton(), side, 3, false, true);
  flag.has_air = true;
  flag.air_normal = 1.2;
  flag.air_tangential = 0.1;
  flag.wind = {3, 1, 0};
  Scene damped = square("strong damping", cotton(), side, 2, true, false);
  damped.damping = 100;
  return {{soft, 0.05 * share}, {stiff, 0.03 * share}, {flag, 0.05 * share}, {damped, 0.05 * share}};
}

}  // namespace drape::bench
