#include "assembly/pin_rows.h"

#include "piece/support/support.h"
#include "piece/place.h"

namespace drape {
namespace {

ConstraintRow row_at(const Lattice& l, const GridPoint& at, const State& start) {
  ConstraintRow row{};
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

std::vector<PinBase> pins_make(const Scene& scene, const std::vector<Grid>& grids) {
  std::vector<PinBase> pins;
  for (const PinSpec& pin : scene.pins) {
    const Hold hold = hold_make(grids[std::size_t(pin.piece)], scene, pin);
    const Vec3 centre = place_point(scene.pieces[std::size_t(pin.piece)].place, hold.centre);
    pins.push_back({pin.name, centre, pin.clamp, pin.drive});
  }
  return pins;
}

std::vector<ConstraintRow> pin_rows(const Scene& scene, const std::vector<Grid>& grids, const System& system,
                                    const State& start) {
  std::vector<ConstraintRow> rows;
  for (std::size_t p = 0; p < scene.pins.size(); ++p) {
    const auto piece = std::size_t(scene.pins[p].piece);
    for (const GridPoint& at : hold_make(grids[piece], scene, scene.pins[p]).at) {
      rows.push_back(row_at(system.lattices[piece], at, start));
      rows.back().pin = int(p);
    }
  }
  return rows;
}

}  // namespace drape
