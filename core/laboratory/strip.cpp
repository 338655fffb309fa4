#include "laboratory/strip.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "assembly/assemble.h"
#include "dynamics/advance.h"
#include "laboratory/equilibrium.h"
#include "model/elements.h"

namespace drape::laboratory {
namespace {

struct Specimen {
  System system;
  State state;
  dynamics::Motion motion;
};

Specimen specimen_make(const Scene& scene, std::vector<Problem>& problems) {
  Specimen s;
  s.system = assembly::system_assemble(scene, s.state, problems);
  if (problems.empty()) s.motion = dynamics::motion_make(s.system);
  return s;
}

// Between jaws. Each elongation starts from the previous equilibrium, stretched uniformly.
StripPull jaws_pull(const scene::FabricSpec& fabric, model::YarnDirection along, double cell,
                    const std::vector<double>& elongation, std::vector<Problem>& problems,
                    const fabric::LawOptions& options) {
  StripPull pull;
  Specimen strip = specimen_make(strip_scene(fabric, along, cell, options), problems);
  if (!problems.empty()) return pull;
  const EquilibriumSearchHandle search = equilibrium_search_make(strip.system, true);
  const double top = strip.state.pin_motion[1].position[1];
  double length = 1;
  for (double e : elongation) {
    for (std::size_t n : strip.system.particle) strip.state.y[n] *= (1 + e) / length;
    length = 1 + e;
    strip.state.pin_motion[1].position[1] = top + fabric.strip_gauge * e;
    const Equilibrium rest = equilibrium_find(*search, strip.system, strip.motion, strip.state);
    pull.steps += rest.steps;
    pull.residual = std::max(pull.residual, rest.residual);
    if (!rest.found) break;
    pull.force.push_back(-rest.force[1][1]);
    pull.strain.push_back(leading_strain(strip.system, strip.state, along));
  }
  return pull;
}

// A trellis of yarns of fixed length. Stretched by l1 = 1 + e along y, it shortens to l2 = sqrt(2 - l1^2)
// along x. The force follows from the virtual work of the forces of the lattice: F H dl1 = -sum f.dr, dr =
// (-X l1/l2, Y) dl1.
StripPull trellis_pull(const scene::FabricSpec& fabric, double cell, const std::vector<double>& elongation,
                       std::vector<Problem>& problems, const fabric::LawOptions& options) {
  StripPull pull;
  Scene scene = strip_scene(fabric, model::YarnDirection::kBias, cell, options);
  scene.pins.clear();
  Specimen strip = specimen_make(scene, problems);
  if (!problems.empty()) return pull;
  const State flat = strip.state;
  dynamics::Motion& motion = strip.motion;
  for (double e : elongation) {
    const double l1 = 1 + e, l2 = std::sqrt(2 - l1 * l1);
    for (std::size_t n : strip.system.particle) {
      strip.state.x[n] = l2 * flat.x[n];
      strip.state.y[n] = l1 * flat.y[n];
    }
    dynamics::kernel_forces(*motion.kernel, strip.system, strip.state, motion.workspace,
                            dynamics::motion_field(motion));
    double work = 0;
    for (std::size_t n : strip.system.particle)
      work -= motion.now_y[n] * flat.y[n] - motion.now_x[n] * flat.x[n] * l1 / l2;
    pull.force.push_back(work / fabric.strip_gauge);
    pull.strain.push_back(e);
  }
  return pull;
}

}  // namespace

double strip_cell(const scene::FabricSpec& fabric, model::YarnDirection along, double cell) {
  if (along != model::YarnDirection::kBias) return cell;
  const double width = fabric.strip_width / std::numbers::sqrt2;
  return width / std::max(1.0, std::round(width / cell));
}

Scene strip_scene(const scene::FabricSpec& fabric, model::YarnDirection along, double cell,
                  const fabric::LawOptions& options) {
  const double w = fabric.strip_width, h = fabric.strip_gauge, quarter = std::numbers::pi / 4;
  Scene scene;
  scene.name = "strip";
  scene.gravity = {0, 0, 0};
  scene.fabrics = {fabric};
  scene.fabrics[0].damping = 0;  // nothing moves
  scene.scaling = options.scaling;
  scene.bias_model = options.bias_model;
  scene.clamp_correction = options.clamp_correction;
  scene::PieceSpec piece;
  piece.name = "strip";
  piece.fabric = 0;
  piece.cell = strip_cell(fabric, along, cell);
  piece.outline = {{0, 0}, {w, 0}, {w, h}, {0, h}};
  piece.grain = along == model::YarnDirection::kWarp   ? 0
                : along == model::YarnDirection::kWeft ? 2 * quarter
                                                       : quarter;
  scene.pieces = {piece};
  for (int end : {0, 1}) {
    scene::PinSpec jaw;
    jaw.name = end ? "high" : "low";
    jaw.piece = 0;
    jaw.edges = {2 * end};
    if (end) jaw.drive = scene::Drive::kPosition;
    scene.pins.push_back(jaw);
  }
  return scene;
}

const scene::DiagramSpec& strip_diagram(const scene::FabricSpec& fabric, model::YarnDirection along) {
  return along == model::YarnDirection::kWarp   ? fabric.warp
         : along == model::YarnDirection::kWeft ? fabric.weft
                                                : fabric.bias;
}

double leading_strain(const System& system, const State& s, model::YarnDirection along) {
  double sum = 0, weight = 0;
  for (const model::Lattice& l : system.lattices)
    model::links_visit(system, l, [&](const model::Link& link) {
      if (link.along != along) return;
      const double e = std::abs(model::link_strain(s, link)), work = link.width * link.rest * std::pow(e, 8);
      sum += work * e;
      weight += work;
    });
  return weight > 0 ? sum / weight : 0;
}

StripPull strip_pull(const scene::FabricSpec& fabric, model::YarnDirection along, double cell,
                     const std::vector<double>& elongation, std::vector<Problem>& problems,
                     const fabric::LawOptions& options) {
  if (along == model::YarnDirection::kBias && !fabric.bias.jaws)
    return trellis_pull(fabric, cell, elongation, problems, options);
  return jaws_pull(fabric, along, cell, elongation, problems, options);
}

std::vector<double> strip_elongations(const scene::FabricSpec& fabric, model::YarnDirection along,
                                      double pull) {
  const double locked = std::numbers::sqrt2 - 1 - 1e-6;  // core/README.md, section 3
  std::vector<double> elongation;
  for (double e : strip_diagram(fabric, along).elongation)
    if (e > 0 && e <= pull * (1 + 1e-12) && (along != model::YarnDirection::kBias || e < locked))
      elongation.push_back(e);
  return elongation;
}

double strip_slope_path(const scene::FabricSpec& f, model::YarnDirection along,
                        const fabric::LawOptions& options) {
  std::vector<Problem> none;
  const fabric::Law law = fabric::law_make(f, options, 1, "", none);
  const math::Curve& curve = along == model::YarnDirection::kWarp   ? law.warp
                             : along == model::YarnDirection::kWeft ? law.weft
                                                                    : law.bias;
  return curve.segments > 0 ? math::curve_slope_path(curve) : 0;
}

StripExcess strip_excess(const scene::FabricSpec& fabric, model::YarnDirection along,
                         const fabric::LawOptions& options) {
  const scene::DiagramSpec& d = strip_diagram(fabric, along);
  if (d.elongation.empty()) return {};
  const std::vector<double> elongation = strip_elongations(fabric, along, d.elongation.back());
  const double cell = std::min(fabric.strip_width / kExcessCells, fabric.strip_gauge / kMinCells);
  if (fabric.strip_gauge > kMaxCells * cell) return {0, 0, "its strip is too long to be simulated"};
  std::vector<Problem> problems;
  const StripPull pull = strip_pull(fabric, along, cell, elongation, problems, options);
  StripExcess largest;
  for (std::size_t k = 0; k < pull.force.size(); ++k)
    if (const double f = d.force[k + 1]; f > 0)
      if (const double off = pull.force[k] / f - 1; std::abs(off) > std::abs(largest.excess))
        largest = {off, elongation[k], ""};
  if (pull.force.size() < elongation.size()) {
    char text[64];
    std::snprintf(text, sizeof text, "its simulated strip finds no rest at %.4g %%",
                  100 * elongation[pull.force.size()]);
    largest.why = text;
  }
  return largest;
}

}  // namespace drape::laboratory
