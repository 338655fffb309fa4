#include "bench/cloths.h"

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include "assembly/assemble.h"
#include "dynamics/step_size/step_limit.h"

namespace drape::bench {
namespace {

constexpr double kCell = 0.01;      // m
constexpr double kCrumple = 0.003;  // of a cell
constexpr double kStep = 0.4;       // of the limit

// A diagram of slope k at zero (N/m on a 50 mm strip), three times as steep at 10 %; straight with one
// point.
scene::DiagramSpec diagram(double k, int points) {
  scene::DiagramSpec d{{0}, {0}, {}};
  for (int i = 1; i <= points; ++i) {
    const double e = 0.1 * i / points;
    d.elongation.push_back(e);
    d.force.push_back(0.05 * k * e * (points == 1 ? 1 : 1 + 10 * e));
  }
  return d;
}

}  // namespace

Scene scene_of(const Features& features, int side) {
  scene::FabricSpec fabric;
  fabric.name = "bench";
  fabric.areal_density = 0.15;
  fabric.thickness = 5e-4;
  fabric.warp = diagram(100, features.points);
  fabric.weft = diagram(80, features.points);
  fabric.bias = diagram(20, features.points);
  if (features.bending) fabric.bending_warp = 4e-6, fabric.bending_weft = 2e-6;
  fabric.damping = features.springs;

  Scene scene;
  scene.name = features.name;
  scene.fabrics = {fabric};
  scene.clamp_correction = false;
  scene.damping = features.damping;
  scene.energy = features.energy;
  if (features.air) scene.has_air = true, scene.air_normal = 1.2, scene.air_tangential = 0.05;
  scene::PieceSpec piece;
  piece.name = "cloth";
  piece.fabric = 0;
  piece.cell = kCell;
  const int of_layer = features.layers == 2 ? int(side / std::numbers::sqrt2) : side;
  const double length = (of_layer - 1) * kCell;
  if (features.cut) {
    constexpr int kCorners = 48;
    const double radius = length / std::sqrt(std::numbers::pi);
    piece.grain = 20 * std::numbers::pi / 180;
    for (int k = 0; k < kCorners; ++k) {
      const double at = 2 * std::numbers::pi * k / kCorners;
      piece.outline.push_back({radius * std::cos(at), radius * std::sin(at)});
    }
  } else {
    piece.outline = {{0, 0}, {length, 0}, {length, length}, {0, length}};
  }
  scene.pieces = {piece};
  scene.self_contact = features.layers > 0;
  if (features.layers == 2) {
    piece.name = "upper";
    piece.place.origin = {0.37 * kCell, 0.41 * kCell, fabric.thickness};
    scene.pieces.push_back(piece);
  }
  return scene;
}

Ready ready_at_start(const Scene& scene, int threads) {
  Ready r;
  std::vector<Problem> problems;
  r.system = assembly::system_assemble(scene, r.state, problems);
  for (const Problem& p : problems) throw std::runtime_error(scene::problem_text(p));
  r.system.threads = threads;
  r.motion = dynamics::motion_make(r.system);
  dynamics::leapfrog_begin(r.system, r.motion, r.state);
  return r;
}

Ready ready(const Scene& scene, int threads) {
  Ready r = ready_at_start(scene, threads);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> shift(-kCrumple * kCell, kCrumple * kCell);
  for (std::size_t n : r.system.particle)
    for (Array* a : {&r.state.x, &r.state.y, &r.state.z}) (*a)[n] += shift(random);
  dynamics::leapfrog_begin(r.system, r.motion, r.state);
  r.step = kStep * dynamics::step_limit_of(r.system, r.state.omega2);
  return r;
}

}  // namespace drape::bench
