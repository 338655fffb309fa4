#include "assembly/pin_rows.h"

#include "piece/place.h"
#include "piece/support/support.h"

namespace drape::assembly {
namespace {

constraint::ConstraintRow row_at(const model::Lattice& l, const piece::GridPoint& at, const State& start) {
  constraint::ConstraintRow row{};
  for (int k = 0; k < 4; ++k) {
    if (at.weight[k] == 0) continue;
    const std::size_t n = l.node_of(at.node[k]);
    row.node.push_back(n);
    row.weight.push_back(at.weight[k]);
    row.target[0] += at.weight[k] * start.x[n];
    row.target[1] += at.weight[k] * start.y[n];
    row.target[2] += at.weight[k] * start.z[n];
  }
  return row;
}

}  // namespace

std::vector<constraint::PinBase> pins_make(const Scene& scene, const std::vector<piece::Grid>& grids) {
  std::vector<constraint::PinBase> pins;
  for (const scene::PinSpec& pin : scene.pins) {
    const piece::Support hold = piece::support_make(grids[std::size_t(pin.piece)], scene, pin);
    const Vec3 centre = piece::place_point(scene.pieces[std::size_t(pin.piece)].place, hold.centre);
    pins.push_back({pin.name, centre, pin.clamp, pin.drive});
  }
  return pins;
}

std::vector<constraint::ConstraintRow> pin_rows(const Scene& scene, const std::vector<piece::Grid>& grids,
                                                const System& system, const State& start) {
  std::vector<constraint::ConstraintRow> rows;
  for (std::size_t p = 0; p < scene.pins.size(); ++p) {
    const auto piece = std::size_t(scene.pins[p].piece);
    for (const piece::GridPoint& at : piece::support_make(grids[piece], scene, scene.pins[p]).at) {
      rows.push_back(row_at(system.lattices[piece], at, start));
      rows.back().pin = int(p);
    }
  }
  return rows;
}

}  // namespace drape::assembly
