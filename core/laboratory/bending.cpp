#include "laboratory/bending.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "assembly/assemble.h"
#include "dynamics/advance.h"
#include "laboratory/equilibrium.h"
#include "standards/cantilever.h"

namespace drape::laboratory {
namespace {

constexpr int kShapePoints = 512;
constexpr int kSecants = 12;
constexpr double kConverged = 1e-7;  // relative change of the overhang
constexpr double kMaxBeta = 1e5;     // largest beta of a wing; softer cloth hangs straight down

double weight_of(const scene::FabricSpec& f) { return f.areal_density * standards::kStandardGravity; }  // Pa

// B of the fabric's law, N m.
double rigidity_of(const scene::FabricSpec& f, bool warp) {
  return (warp ? f.bending_warp : f.bending_weft) / (1 - f.poisson * f.poisson);
}

// A horizontal strip whose warp or weft runs along y.
Scene bending_scene(const scene::FabricSpec& fabric, bool warp, double cell, double width, double length) {
  Scene scene;
  scene.name = "bending";
  scene.gravity = {0, 0, -standards::kStandardGravity};
  scene.mode = scene::Mode::kFit;
  scene.fabrics = {fabric};
  scene.fabrics[0].damping = 0;  // nothing moves
  scene::PieceSpec piece;
  piece.name = "strip";
  piece.fabric = 0;
  piece.cell = cell;
  piece.outline = {{0, 0}, {width, 0}, {width, length}, {0, length}};
  piece.grain = warp ? 0 : std::numbers::pi / 2;
  scene.pieces = {piece};
  scene::PinSpec pin;
  pin.piece = 0;
  pin.clamp = true;
  scene.pins = {pin};
  return scene;
}

// The equilibrium of a strip that is horizontal from y = low to y = high and hangs on either side. As first
// guess, each side follows the elastica of its length.
struct HangingStrip {
  bool found = false;
  std::vector<Vec3> probe;
};
HangingStrip hanging_strip(const Scene& scene, double low, double high, double wing, double beta,
                           std::vector<Problem>& problems) {
  State s;
  System system = assembly::system_assemble(scene, s, problems);
  if (!problems.empty()) return {};
  dynamics::Motion motion = dynamics::motion_make(system);
  const std::vector<std::array<double, 2>> shape = standards::cantilever_shape(beta, kShapePoints);
  for (std::size_t n : system.particle) {
    const double beyond = std::max(low - s.y[n], s.y[n] - high);
    if (beyond <= 0) continue;
    const double at = std::min(beyond / wing, 1.0) * kShapePoints;
    const auto k = std::min(std::size_t(at), std::size_t(kShapePoints - 1));
    const double u = at - double(k);
    const auto between = [&](std::size_t axis) {
      return wing * (shape[k][axis] + u * (shape[k + 1][axis] - shape[k][axis]));
    };
    s.y[n] = s.y[n] < low ? low - between(0) : high + between(0);
    s.z[n] -= between(1);
  }
  const EquilibriumSearchHandle search = equilibrium_search_make(system, false);
  HangingStrip hung;
  hung.found = equilibrium_find(*search, system, motion, s).found;
  for (const model::Probe& p : system.probes) {
    Vec3 r{0, 0, 0};
    for (int k = 0; k < 4; ++k)
      r = {r[0] + p.weight[k] * s.x[p.node[k]], r[1] + p.weight[k] * s.y[p.node[k]],
           r[2] + p.weight[k] * s.z[p.node[k]]};
    hung.probe.push_back(r);
  }
  return hung;
}

// The angle, rad, below the horizontal of the line from the edge to the end of an overhang of this length.
double overhang_angle(const scene::FabricSpec& fabric, bool warp, double cell, double length, bool& found,
                      std::vector<Problem>& problems) {
  const double beta = weight_of(fabric) * length * length * length / rigidity_of(fabric, warp);
  const HangingStrip hung =
      hanging_strip(overhang_scene(fabric, warp, cell, length), 0, 0, length, beta, problems);
  found = hung.found;
  return found ? std::atan2(-hung.probe[0][2], hung.probe[0][1]) : 0;
}

}  // namespace

Scene pt2_scene(const scene::FabricSpec& fabric, bool warp, double cell) {
  const double whole = 2 * kWing + kSupport, w = kWingWidth, high = kWing + kSupport;
  Scene scene = bending_scene(fabric, warp, cell, w, whole);
  scene.name = "pt2";
  scene.pieces[0].grid_origin = Vec2{0, kWing};
  scene.pins[0].name = "support";
  scene.pins[0].region = {{-w, kWing}, {2 * w, kWing}, {2 * w, high}, {-w, high}};
  scene.probes = {{"low", 0, {w / 2, 0}}, {"high", 0, {w / 2, whole}}};
  return scene;
}

Scene overhang_scene(const scene::FabricSpec& fabric, bool warp, double cell, double length) {
  const double width = std::min(kOverhangWidth, length);  // a narrow strip serves a short overhang as well
  Scene scene = bending_scene(fabric, warp, cell, width, length);
  scene.name = "overhang";
  scene.pins[0].name = "edge";
  scene.pins[0].edges = {0};
  scene.probes = {{"end", 0, {width / 2, length}}};
  return scene;
}

BendingTest pt2_test(const scene::FabricSpec& fabric, bool warp, double cell,
                     std::vector<Problem>& problems) {
  BendingTest test;
  const double load = weight_of(fabric) * kWing * kWing * kWing, beta = load / rigidity_of(fabric, warp);
  if (beta > kMaxBeta) return test;
  test.expected = kWing * standards::cantilever_of_load(beta).drop;
  const HangingStrip hung =
      hanging_strip(pt2_scene(fabric, warp, cell), kWing, kWing + kSupport, kWing, beta, problems);
  test.found = hung.found;
  if (!test.found) return test;
  test.reading = -(hung.probe[0][2] + hung.probe[1][2]) / 2;
  test.rigidity = load / standards::cantilever_with(test.reading / kWing).beta;
  return test;
}

BendingTest overhang_test(const scene::FabricSpec& fabric, bool warp, int cells,
                          std::vector<Problem>& problems) {
  BendingTest test;
  const double plane = kPlane * std::numbers::pi / 180, beta = standards::cantilever_of_slope(plane).beta;
  test.expected = std::cbrt(beta * rigidity_of(fabric, warp) / weight_of(fabric));
  const double cell = test.expected / cells;
  double length = test.expected, before = 0.98 * length;
  double off_before = overhang_angle(fabric, warp, cell, before, test.found, problems) - plane;
  for (int k = 0; k < kSecants && test.found && problems.empty(); ++k) {
    const double off = overhang_angle(fabric, warp, cell, length, test.found, problems) - plane;
    const double next = length - off * (length - before) / (off - off_before);
    before = length;
    off_before = off;
    length = next;
    if (std::abs(length - before) <= kConverged * length) break;
  }
  test.found = test.found && std::abs(length - before) <= 1e-3 * length;
  test.reading = length;
  test.rigidity = weight_of(fabric) * length * length * length / beta;
  return test;
}

}  // namespace drape::laboratory
