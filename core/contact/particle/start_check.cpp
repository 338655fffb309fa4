// Finds particles, links and cells that start in a body.
#include "body/closest_features.h"
#include "contact/particle/contact.h"
#include "model/body_pose.h"
#include "scene/diagnostics.h"

namespace drape::contact {
namespace {

double depth_at(const System& system, ContactWorkspace& workspace, const State& s, std::size_t b,
                const model::Lattice& l, std::size_t n) {
  const model::Body& body = system.bodies[b];
  const Vec3 x = model::pose_inward(body, s.body[b], {s.x[n], s.y[n], s.z[n]});
  body::DistanceGrid& grid = workspace.distance_grids[b];
  if (const body::Neighbourhood near = body::distance_grid_at(grid, x); near.triangle) {
    body::ClosestFeatures found;
    body::ClosestFeaturesScratch scratch;
    body::closest_features_find(body.mesh.surface, *near.triangle,
                                {x, l.contact_law.distance, grid.reach, grid.reach, near.listed, nullptr},
                                scratch, found);
    if (!found.feature.empty()) return l.contact_law.distance - found.feature[0].distance;
  }
  const double inside = body::distance_grid_depth(grid, x);
  return inside > 0 ? l.contact_law.distance + inside : 0;
}

}  // namespace

void check_start(const System& system, const Scene& scene, ContactWorkspace& workspace, const State& s,
                 std::vector<Problem>& problems) {
  for (std::size_t b = 0; b < system.bodies.size(); ++b)
    for (const model::Lattice& l : system.lattices) {
      std::size_t count = 0;
      Vec3 worst{0, 0, 0};
      double deepest = 0;
      for (std::size_t n : system.particle) {
        if (!l.owns(n)) continue;
        const double depth = depth_at(system, workspace, s, b, l, n);
        if (!(depth > kContactDeepest * l.contact_law.distance)) continue;
        ++count;
        if (depth > deepest) deepest = depth, worst = {s.x[n], s.y[n], s.z[n]};
      }
      const char* what = " particles inside the body ";
      if (count == 0) {
        const EdgeDepth deep = edge_deepest(system, s, b, l, workspace.distance_grids[b]);
        count = deep.count, deepest = deep.depth, worst = deep.at;
        what = " links or cells through sharp edges or tips of the body ";
      }
      if (count == 0) continue;
      problems.push_back({"piece." + scene.pieces[std::size_t(l.piece)].name + ".place",
                          "puts " + std::to_string(count) + what + scene::in_quotes(system.bodies[b].name) +
                              " or nearer to it than half the thickness, " +
                              scene::number_text(l.contact_law.distance) + " m; the deepest by " +
                              scene::number_text(deepest) + " m at (" + scene::number_text(worst[0]) + ", " +
                              scene::number_text(worst[1]) + ", " + scene::number_text(worst[2]) +
                              "); wanted: all outside"});
    }
}

}  // namespace drape::contact
