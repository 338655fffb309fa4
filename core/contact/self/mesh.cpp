#include "contact/self/mesh.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "contact/self/search.h"
#include "math/closest_points.h"
#include "math/vector3.h"
#include "model/elements.h"

namespace drape::contact {
namespace {

constexpr int kExclusionCells = 1;         // minimum, in cells along the cloth
constexpr double kExclusionThickness = 2;  // minimum, in thicknesses along the cloth
constexpr double kSamePlace = 1e-3;        // of a cell: sewn points nearer than that are one
constexpr double kTooNear = 1e-3;          // of the thickness: what starts nearer never touches
constexpr double kOnIt = 1e-6;             // weight of a node, above which a foot is on it

void cells_add(const System& system, model::SelfMesh& mesh) {
  for (const model::Lattice& l : system.lattices)
    model::cells_visit(system, l, [&](const std::size_t* corner, double) {
      model::SelfCell cell{};
      for (int k = 0; k < 4; ++k) cell.node[k] = model::NodeIndex(corner[k]);
      const auto [i, j] = l.place_of(corner[0]);
      cell.lattice = l.piece, cell.i = i, cell.j = j;
      mesh.cell.push_back(cell);
    });
}

// Assigns each particle and each edge to the first cell that has it.
void owners_assign(const System& system, model::SelfMesh& mesh) {
  constexpr int kEdges[5][2] = {{0, 1}, {0, 2}, {1, 3}, {2, 3}, {0, 3}};
  constexpr int kAcross[5][2] = {{3, -1}, {3, -1}, {0, -1}, {0, -1}, {1, 2}};
  std::vector<char> owned(system.nodes, 0);
  std::map<std::array<model::NodeIndex, 2>, std::size_t> seen;
  for (model::SelfCell& cell : mesh.cell) {
    cell.node_first = int(mesh.own_node.size());
    for (model::NodeIndex n : cell.node)
      if (!owned[n]) owned[n] = 1, mesh.own_node.push_back(n);
    cell.node_end = int(mesh.own_node.size());
    cell.edge_first = int(mesh.edge.size());
    for (int k = 0; k < 5; ++k) {
      const model::NodeIndex a = cell.node[kEdges[k][0]], b = cell.node[kEdges[k][1]];
      const auto [at, fresh] = seen.try_emplace({std::min(a, b), std::max(a, b)}, mesh.edge.size());
      const model::NodeIndex across = cell.node[kAcross[k][0]];
      if (!fresh) {
        mesh.edge[at->second].across[1] = across;
        continue;
      }
      const model::SelfBox &p = mesh.box[a], &q = mesh.box[b];
      mesh.edge.push_back({{std::min(a, b), std::max(a, b)},
                           {across, kAcross[k][1] < 0 ? model::kNoNode : cell.node[kAcross[k][1]]},
                           {{std::min(p.low[0], q.low[0]), std::min(p.low[1], q.low[1])},
                            {std::max(p.high[0], q.high[0]), std::max(p.high[1], q.high[1])}}});
    }
    cell.edge_end = int(mesh.edge.size());
  }
}

void spans_add(const System& system, model::SelfMesh& mesh) {
  for (std::size_t n : system.particle) {
    if (mesh.span.empty() || mesh.span.back().end != n ||
        mesh.lattice_of[mesh.span.back().begin] != mesh.lattice_of[n])
      mesh.span.push_back({n, n});
    mesh.span.back().end = n + 1;
  }
}

// A sewn point; x, y in m on the flat cloth.
struct SewnPoint {
  int lattice, place;
  double x, y;
};

// All sewn points. Pairs that share a point of the cloth have the same place, and so has all that is sewn
// there.
std::vector<SewnPoint> sewn_points(const System& system) {
  std::vector<SewnPoint> points;
  for (std::size_t p = 0; p < system.seams.pair.size(); ++p)
    for (const model::SeamPoint& side : system.seams.pair[p].side) {
      const model::Lattice& l = model::system_lattice_of(system, side.node[0]);
      SewnPoint at{l.piece, int(p), 0, 0};
      for (int k = 0; k < 4; ++k) {
        const auto [i, j] = l.place_of(side.node[k]);
        at.x += side.weight[k] * i * l.cell;
        at.y += side.weight[k] * j * l.cell;
      }
      points.push_back(at);
    }
  const auto replace = [&](int from, int to) {
    for (SewnPoint& p : points)
      if (p.place == from) p.place = to;
  };
  for (std::size_t a = 0; a < points.size(); ++a)
    for (std::size_t b = a + 1; b < points.size(); ++b) {
      if (points[a].lattice != points[b].lattice || points[a].place == points[b].place) continue;
      const double near = kSamePlace * system.lattices[std::size_t(points[a].lattice)].cell;
      if (std::hypot(points[a].x - points[b].x, points[a].y - points[b].y) <= near)
        replace(points[b].place, points[a].place);
    }
  return points;
}

void seams_near(const System& system, model::SelfMesh& mesh) {
  const std::vector<SewnPoint> points = sewn_points(system);
  for (const model::Lattice& l : system.lattices)
    mesh.seam_exclusion_distance =
        std::max(mesh.seam_exclusion_distance, (mesh.exclusion_cells[std::size_t(l.piece)] + 2) * l.cell);
  for (model::SelfCell& cell : mesh.cell) {
    cell.seam_first = int(mesh.near_seam.size());
    const double b = system.lattices[std::size_t(cell.lattice)].cell;
    for (const SewnPoint& p : points) {
      if (p.lattice != cell.lattice) continue;
      const double distance = std::hypot(p.x - (cell.i + 0.5) * b, p.y - (cell.j + 0.5) * b);
      if (distance <= mesh.seam_exclusion_distance) mesh.near_seam.push_back({p.place, distance});
    }
    cell.seam_end = int(mesh.near_seam.size());
  }
}

// [nodes] 1 on the border of the cloth
std::vector<char> border_of(const System& system, const model::SelfMesh& mesh) {
  std::vector<char> border(system.nodes, 0);
  for (const model::SelfEdge& e : mesh.edge)
    if (e.across[1] == model::kNoNode) border[e.node[0]] = border[e.node[1]] = 1;
  return border;
}

// Where layers start nearer to each other than their contact distance, that start is their largest contact
// distance. It grows where a particle lies over cloth. Beside a border it stays: cloth side by side in one
// plane, as on both sides of a slit, does not part.
void contact_distances_relax(const System& system, const State& start, model::SelfMesh& mesh) {
  mesh.max_contact_distance.assign(system.nodes, INFINITY);
  mesh.parts.assign(system.nodes, 0);
  const std::vector<char> border = border_of(system, mesh);
  const model::SelfPairs pairs = self_search(system, mesh, start, 0);
  Array largest = mesh.max_contact_distance;
  const auto limit = [&](model::NodeIndex n, double distance, double contact_distance) {
    largest[n] = std::min(largest[n], distance > kTooNear * contact_distance ? distance : 0);
  };
  const auto at = [&](model::NodeIndex n) { return Vec3{start.x[n], start.y[n], start.z[n]}; };
  for (const model::SelfPoint& p : pairs.point) {
    const math::TriangleClosest closest =
        math::triangle_closest(at(p.node[0]), at(p.node[1]), at(p.node[2]), at(p.node[3]));
    const double d = std::sqrt(closest.distance2);
    const double contact_distance =
        self_contact_distance(system, mesh.lattice_of[p.node[0]], mesh.lattice_of[p.node[1]]);
    if (d >= contact_distance) continue;
    limit(p.node[0], d, contact_distance);
    for (std::size_t k = 0; k < 3; ++k)
      if (closest.weight[k] > kOnIt && !border[p.node[k + 1]]) mesh.parts[p.node[0]] = 1;
  }
  for (const model::SelfCross& c : pairs.cross) {
    const math::EdgesClosest closest =
        math::edges_closest(at(c.node[0]), at(c.node[1]), at(c.node[2]), at(c.node[3]));
    const double contact_distance =
        self_contact_distance(system, mesh.lattice_of[c.node[0]], mesh.lattice_of[c.node[2]]);
    if (closest.distance2 < contact_distance * contact_distance)
      for (model::NodeIndex n : c.node) limit(n, std::sqrt(closest.distance2), contact_distance);
  }
  mesh.max_contact_distance = largest;
  for (std::size_t n = 0; n < system.nodes; ++n) {
    if (!mesh.parts[n]) mesh.parts[n] = largest[n] == INFINITY;
    else if (largest[n] == 0) mesh.same_place.push_back(model::NodeIndex(n));
  }
}

}  // namespace

model::SelfMesh self_mesh_make(const System& system, const State& start) {
  model::SelfMesh mesh;
  mesh.lattice_of.assign(system.nodes, 0);
  mesh.box.assign(system.nodes, {});
  for (std::size_t n : system.particle) {
    const model::Lattice& l = model::system_lattice_of(system, n);
    const auto [i, j] = l.place_of(n);
    mesh.lattice_of[n] = l.piece;
    mesh.box[n] = {{i, j}, {i, j}};
  }
  cells_add(system, mesh);
  owners_assign(system, mesh);
  spans_add(system, mesh);
  mesh.fixed.assign(system.nodes, 0);
  for (const constraint::FixedNode& f : system.constraints.fixed) mesh.fixed[f.node] = 1;
  mesh.min_cell = INFINITY;
  for (const model::Lattice& l : system.lattices) {
    mesh.contact_distance = std::max(mesh.contact_distance, 2 * l.contact_law.distance);
    mesh.min_cell = std::min(mesh.min_cell, l.cell);
    mesh.min_protrusion_sine.push_back(l.contact_law.distance / (4 * l.cell));
    mesh.exclusion_cells.push_back(
        std::max(kExclusionCells, int(std::ceil(kExclusionThickness * 2 * l.contact_law.distance / l.cell))));
  }
  seams_near(system, mesh);
  contact_distances_relax(system, start, mesh);
  return mesh;
}

bool self_cells_sewn(const model::SelfMesh& mesh, const model::SelfCell& a, const model::SelfCell& b) {
  for (int s = a.seam_first; s < a.seam_end; ++s)
    for (int t = b.seam_first; t < b.seam_end; ++t) {
      const model::NearSeam &from = mesh.near_seam[std::size_t(s)], &to = mesh.near_seam[std::size_t(t)];
      if (from.place == to.place && from.distance + to.distance <= mesh.seam_exclusion_distance) return true;
    }
  return false;
}

}  // namespace drape::contact
