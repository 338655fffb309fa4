// Checks that involve several keys. Values that the reader could not store are empty, 0 or -1. They have been
// reported already, and are skipped here.
#include "validation/checks.h"

#include <algorithm>

#include "piece/outline/outline.h"
#include "piece/support/support.h"
#include "scene/diagnostics.h"
#include "validation/load.h"

namespace drape::validation {

namespace {

void motion_check(const Scene& scene, Problems& problems) {
  const Vec3& w = scene.wind;
  if (!scene.has_air && (w[0] != 0 || w[1] != 0 || w[2] != 0))
    problems.push_back({"scene.wind", "= [" + scene::number_text(w[0]) + ", " + scene::number_text(w[1]) +
                                          ", " + scene::number_text(w[2]) +
                                          "] m/s moves nothing without air; wanted: air.normal or "
                                          "air.tangential, or no wind"});
  if (scene.mode == scene::Mode::kFit && scene.integrator == scene::Integrator::kPaper)
    problems.push_back(
        {"scene.mode", "= \"fit\" does not go with integrator = \"paper\"; wanted: \"leapfrog\""});
}

// Schemes of higher order have substeps that go back in time, where damping would accelerate the cloth.
void order_check(const Scene& scene, Problems& problems) {
  if (scene.order == 2) return;
  const std::string order = "= " + std::to_string(scene.order) + " does not go with ";
  if (scene.integrator == scene::Integrator::kPaper)
    problems.push_back({"scene.order", order + "integrator = \"paper\"; wanted: order = 2, or \"leapfrog\""});
  if (scene.mode == scene::Mode::kFit)
    problems.push_back({"scene.order", order + "mode = \"fit\"; wanted: order = 2, or \"dynamic\""});
  if (!scene.seams.empty())
    problems.push_back({"scene.order", order + "seams, whose pull is damped; wanted: order = 2, or no seam"});
  if (scene.self_contact)
    problems.push_back({"scene.order", order + "self_contact, which is damped; wanted: order = 2, or "
                                               "self_contact = false"});
  if (!scene.bodies.empty())
    problems.push_back(
        {"scene.order", order + "bodies, whose contact is damped and rubs; wanted: order = 2, or no body"});
  const auto damping_check = [&](const std::string& place, double value, const char* unit) {
    if (value > 0)
      problems.push_back(
          {place, "= " + scene::number_text(value) + unit + "; allowed: " + order_allows(scene.order)});
  };
  damping_check("air.normal", scene.air_normal, "");
  damping_check("air.tangential", scene.air_tangential, "");
  for (const scene::FabricSpec& f : scene.fabrics)
    damping_check("fabric." + f.name + ".damping", f.damping, " s");
}

}  // namespace

std::string order_allows(int order) {
  return "0 with scene.order = " + std::to_string(order) +
         ", whose steps go partly back in time, where it would speed the cloth up";
}

void scene_check(const Scene& scene, std::vector<Problem>& problems) {
  motion_check(scene, problems);
  order_check(scene, problems);
  for (const scene::FabricSpec& f : scene.fabrics) fabric_check(scene, f, problems);
  std::vector<bool> valid;
  for (const scene::PieceSpec& piece : scene.pieces) {
    const std::string path = "piece." + piece.name;
    std::vector<Problem> found;
    piece::outline_problems(piece, path, found);
    // A faulty cell size does not affect straight edges.
    const bool of_cell =
        piece.curves.empty() &&
        std::all_of(found.begin(), found.end(), [&](const Problem& p) { return p.place == path + ".cell"; });
    valid.push_back(!piece.outline.empty() && (of_cell || (piece.cell > 0 && found.empty())));
    problems.insert(problems.end(), found.begin(), found.end());
  }
  seams_check(scene, valid, problems);
  pins_check(scene, valid, problems);
}

void scene_check_layout(const Scene& scene, std::vector<Problem>& problems) {
  for (std::size_t p = 0; p < scene.pieces.size(); ++p) {
    const scene::PieceSpec& piece = scene.pieces[p];
    std::vector<const scene::PinSpec*> regions;
    for (const scene::PinSpec& pin : scene.pins)
      if (pin.piece == int(p) && !pin.region.empty()) regions.push_back(&pin);
    if (scene.outline != scene::OutlineModel::kPaper && regions.empty()) continue;
    const piece::Grid grid = piece::grid_make(scene, int(p));
    if (grid.cells.empty()) {
      problems.push_back(
          {"piece." + piece.name + ".cell",
           "= " + scene::number_text(piece.cell) +
               " m leaves no whole cell inside the outline; options.outline = \"paper\" takes at "
               "least one"});
      continue;
    }
    for (const scene::PinSpec* pin : regions)
      if (piece::support_make(grid, scene, *pin).points.empty())
        problems.push_back({"pin." + pin->name + ".region",
                            "holds nothing: no particle of the piece " + scene::in_quotes(piece.name) +
                                " lies in it; its cells are " + scene::number_text(piece.cell) + " m"});
  }
}

}  // namespace drape::validation
