#include "assembly/assemble.h"

#include <algorithm>
#include <cmath>

#include "assembly/bodies.h"
#include "assembly/pin_rows.h"
#include "assembly/seam_rows.h"
#include "assembly/weave.h"
#include "contact/edge/elements.h"
#include "contact/self/mesh.h"
#include "model/composition.h"
#include "piece/place.h"
#include "seam/particles.h"

namespace drape::assembly {
namespace {

// Reserves the rows of a lattice: a guard row below and above, and at least one unused node at the end of
// each row. The twins follow.
model::Lattice lattice_reserve(const piece::Grid& grid, const scene::PieceSpec& spec, int piece,
                               std::size_t& nodes) {
  const auto padded = [](int n) { return (n + math::kRowUnit - 1) / math::kRowUnit * math::kRowUnit; };
  model::Lattice l;
  l.columns = grid.columns;
  l.rows = grid.rows;
  l.stride = padded(grid.columns + 1);
  l.first = nodes + std::size_t(l.stride);
  l.cell = grid.cell;
  l.piece = piece;
  l.fabric = spec.fabric;
  nodes += std::size_t(l.rows + 2) * l.stride;
  l.twins = int(grid.twin.size());
  l.twin_place = grid.twin;
  l.twin_first = nodes;
  l.twin_stride = padded(l.twins);
  nodes += std::size_t(l.twin_stride);
  return l;
}

void node_place(State& state, std::size_t n, const Vec3& r) {
  state.x[n] = r[0];
  state.y[n] = r[1];
  state.z[n] = r[2];
}

// Gives unused nodes the positions of the flat grid, so that no link has length 0.
void lattice_flatten(const model::Lattice& l, const piece::Grid& grid, const scene::PlaceSpec& place,
                     State& state) {
  const auto at = [&](int i, int j) {
    const double x = grid.x0 + i * grid.cell, y = grid.y0 + j * grid.cell;
    return piece::place_point(place, {x * grid.cosine - y * grid.sine, x * grid.sine + y * grid.cosine});
  };
  for (int j = -1; j <= l.rows; ++j)
    for (int i = 0; i < l.stride; ++i)
      node_place(state, l.first + std::size_t(std::ptrdiff_t(j) * l.stride + i), at(i, j));
  for (int k = 0; k < l.twin_stride; ++k) node_place(state, l.twin_first + std::size_t(k), at(k, 0));
}

// Shares of cells; areas, positions and velocities of all particles.
void lattice_fill(const model::Lattice& l, const piece::Grid& grid, const Scene& scene, System& system,
                  State& state) {
  const scene::PieceSpec& spec = scene.pieces[std::size_t(l.piece)];
  const piece::Waves waves = piece::waves_make(scene, l.piece);
  lattice_flatten(l, grid, spec.place, state);
  for (int c = 0; c < grid.regular; ++c)
    system.share[l.node(grid.cells[std::size_t(c)].i, grid.cells[std::size_t(c)].j)] =
        grid.cells[std::size_t(c)].share;
  for (int k = 0; k < grid.nodes(); ++k) {
    if (grid.area[std::size_t(k)] == 0) continue;
    const std::size_t n = l.node_of(k);
    system.area[n] = grid.area[std::size_t(k)];
    node_place(state, n, piece::place_start(spec.place, waves, grid.place(k)));
    state.vx[n] = spec.velocity[0];
    state.vy[n] = spec.velocity[1];
    state.vz[n] = spec.velocity[2];
    system.particle.push_back(n);
  }
}

// For each row, the columns where it or a neighbouring row has particles.
std::vector<model::Columns> lattice_reach(const model::Lattice& l, const Array& area) {
  const auto used = [&](int i, int j) { return area[l.node(i, j)] > 0; };
  std::vector<model::Columns> row, reach;  // columns of each row; of each row with its neighbours
  for (int j = 0; j < l.rows; ++j) {
    model::Columns c{l.columns, 0};
    for (int i = 0; i < l.columns; ++i)
      if (used(i, j)) c = {std::min(c.begin, i), i + 1};
    row.push_back(c);
  }
  for (int j = 0; j < l.rows; ++j) {
    model::Columns c{l.columns, 0};
    for (int k = std::max(j - 1, 0); k <= std::min(j + 1, l.rows - 1); ++k)
      c = {std::min(c.begin, row[std::size_t(k)].begin), std::max(c.end, row[std::size_t(k)].end)};
    const int begin = c.begin / math::kRowUnit * math::kRowUnit,
              end = (c.end + math::kRowUnit) / math::kRowUnit * math::kRowUnit;
    reach.push_back({std::min(begin, end), end});
  }
  return reach;
}

// m = rho a
void masses_set(System& system) {
  for (const model::Lattice& l : system.lattices) {
    for (std::size_t n = l.first; n < l.end(); ++n) {
      system.mass[n] = l.law.areal_density * system.area[n];
      system.inverse_mass[n] = system.area[n] > 0 ? 1 / system.mass[n] : 0;
    }
  }
}

// The slopes that clamps prescribe on a piece.
std::vector<ClampSlopes> clamp_slopes(const Scene& scene, int piece, const piece::Grid& grid) {
  std::vector<ClampSlopes> clamps;
  for (std::size_t p = 0; p < scene.pins.size(); ++p)
    if (scene.pins[p].clamp && scene.pins[p].piece == piece)
      clamps.push_back({int(p), piece::support_make(grid, scene, scene.pins[p]).slopes});
  return clamps;
}

model::Probe probe_make(const model::Lattice& l, const piece::GridPoint& at) {
  model::Probe probe{};
  for (int k = 0; k < 4; ++k) {
    probe.node[k] = l.node_of(at.node[k]);
    probe.weight[k] = at.weight[k];
  }
  return probe;
}

// The penalty stiffness over mass is a small share of omega^2 of the flat lattice at rest. Fit mode uses a
// larger share, as its increased inertia permits.
model::ContactLaw contact_law_of(const model::Lattice& l, const scene::FabricSpec& fabric,
                                 double communication, bool fit) {
  constexpr double kShare = 0.05, kShareFit = 0.25;
  const fabric::Law& law = l.law;
  const double b2 = l.cell * l.cell,
               slope = std::max(math::curve_slope(law.warp, 0), math::curve_slope(law.weft, 0));
  const double rest = 4 * (slope + math::curve_slope(law.bias, 0)) / (law.areal_density * b2) +
                      32 * std::max(law.bending_warp, law.bending_weft) / (law.areal_density * b2 * b2);
  const double without_law = 1 / (communication * communication);
  return {fabric.thickness / 2, (fit ? kShareFit : kShare) * (rest > 0 ? rest : without_law),
          fabric.friction};
}

std::vector<fabric::Law> laws_make(const System& system, const std::vector<scene::FabricSpec>& fabrics,
                                   std::vector<Problem>& problems) {
  std::vector<fabric::Law> laws;
  for (const model::Lattice& l : system.lattices) {
    const scene::FabricSpec& fabric = fabrics[std::size_t(l.fabric)];
    laws.push_back(fabric::law_make(fabric, system.options, l.cell, "fabric." + fabric.name, problems));
  }
  return laws;
}

// The options of the scene that need no geometry.
void options_copy(const Scene& scene, System& system) {
  system.integrator = scene.integrator;
  system.composition = model::composition_of(scene.order);
  system.communication = scene.communication;
  system.step_given = scene.step;
  system.step_max = scene.communication;
  system.damping = scene.damping;
  system.gravity = scene.gravity;
  if (scene.has_air) system.air = {scene.air_density, scene.air_normal, scene.air_tangential};
  system.energy = scene.energy && scene.mode == scene::Mode::kDynamic;
  system.fit = scene.mode == scene::Mode::kFit;
  system.options = {scene.scaling, scene.bias_model, scene.clamp_correction};
}

// Reserves the nodes of all lattices, and the rigid links of the particles of seams. Returns the grids.
std::vector<piece::Grid> lattices_reserve(const Scene& scene, System& system) {
  std::vector<std::vector<seam::GridTie>> ties;
  std::vector<piece::Grid> grids = seam::grids_make(scene, &ties);
  system.nodes = math::kRowUnit;  // kernels read each row from one node before it to one node after it
  for (std::size_t p = 0; p < scene.pieces.size(); ++p) {
    system.lattices.push_back(lattice_reserve(grids[p], scene.pieces[p], int(p), system.nodes));
    model::Lattice& l = system.lattices.back();
    if (!ties[p].empty()) l.mass_kept = seam::kEdgeKeeps;
    for (const seam::GridTie& t : ties[p])
      system.links.push_back({{l.node_of(t.node[0]), l.node_of(t.node[1])}, t.pair, t.length});
  }
  system.nodes += math::kRowUnit;
  return grids;
}

void arrays_resize(const Scene& scene, System& system, State& start) {
  for (Array* a : {&system.share, &system.hinge_warp, &system.hinge_weft, &system.area, &system.mass,
                   &system.inverse_mass})
    a->assign(system.nodes, 0.0);
  model::state_resize(start, system.nodes, scene.pins.size());
  start.wind = scene.wind;
}

void lattices_fill(const Scene& scene, const std::vector<piece::Grid>& grids, System& system, State& start) {
  for (std::size_t p = 0; p < scene.pieces.size(); ++p) {
    lattice_fill(system.lattices[p], grids[p], scene, system, start);
    system.lattices[p].reach = lattice_reach(system.lattices[p], system.area);
    weave_lay(system, int(p), grids[p], clamp_slopes(scene, int(p), grids[p]), start);
  }
}

void bodies_add(const Scene& scene, System& system, State& start, std::vector<Problem>& problems) {
  system.bodies = bodies_make(scene, problems);
  for (const model::Body& body : system.bodies) {
    model::BodyContact& contact = start.body.emplace_back();
    contact.motion = body.start;
    contact.rotation = math::rotation_matrix(body.start.orientation);
  }
}

// The pairs of all seams, and with them the slots of irregular elements and seams.
void seams_add(const Scene& scene, const std::vector<piece::Grid>& grids, System& system, State& start) {
  seams_lay(scene, grids, system);
  slots_number(system);
  start.sewn.assign(system.seams.pair.size(), model::Sewn::kOpen);
  start.gap_rate.assign(3 * system.seams.pair.size(), 0.0);
  start.closing_integral.assign(system.seams.pair.size(), 0.0);
  start.closing_time.assign(system.seams.pair.size(), 0.0);
}

// An automatic pull needs a stiffness in some piece.
void seams_check(const Scene& scene, const System& system, std::vector<Problem>& problems) {
  for (std::size_t k = 0; k < scene.seams.size(); ++k)
    if (system.seams.seam[k].pull == 0)
      problems.push_back({"seam." + scene.seams[k].name + ".pull",
                          "= \"auto\" finds no stiffness in any piece; wanted: a number, 1/s"});
}

void pins_add(const Scene& scene, const std::vector<piece::Grid>& grids, System& system, State& start,
              std::vector<Problem>& problems) {
  system.pin_rows = pin_rows(scene, grids, system, start);
  system.constraints = constraint::constraints_make(system.pin_rows, system.inverse_mass,
                                                    pins_make(scene, grids), problems, system.links);
  for (std::size_t p = 0; p < scene.pins.size(); ++p)
    start.pin_motion[p].position = system.constraints.pins[p].centre;
}

void probes_add(const Scene& scene, const std::vector<piece::Grid>& grids, System& system) {
  for (const scene::ProbeSpec& probe : scene.probes) {
    const auto p = std::size_t(probe.piece);
    system.probes.push_back(probe_make(system.lattices[p], piece::grid_locate(grids[p], probe.at)));
  }
}

}  // namespace

System system_assemble(const Scene& scene, State& start, std::vector<Problem>& problems) {
  System system;
  options_copy(scene, system);
  const std::vector<piece::Grid> grids = lattices_reserve(scene, system);
  arrays_resize(scene, system, start);
  lattices_fill(scene, grids, system, start);
  bodies_add(scene, system, start, problems);
  if (!problems.empty()) return system;
  seams_add(scene, grids, system, start);
  system_retune(system, scene.fabrics, problems);
  if (!problems.empty()) return system;
  seams_check(scene, system, problems);
  if (!problems.empty()) return system;
  pins_add(scene, grids, system, start, problems);
  probes_add(scene, grids, system);
  if (scene.self_contact) system.self = contact::self_mesh_make(system, start);
  contact::edge_elements_make(system);
  return system;
}

void system_retune(System& system, const std::vector<scene::FabricSpec>& fabrics,
                   std::vector<Problem>& problems) {
  const std::size_t before = problems.size();
  std::vector<fabric::Law> laws = laws_make(system, fabrics, problems);
  if (problems.size() > before) return;
  for (std::size_t k = 0; k < laws.size(); ++k) {
    model::Lattice& l = system.lattices[k];
    l.law = laws[k];
    l.contact_law = contact_law_of(l, fabrics[std::size_t(l.fabric)], system.communication, system.fit);
  }
  masses_set(system);
  seams_retune(system);
}

}  // namespace drape::assembly
