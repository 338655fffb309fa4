#include "dynamics/seam_welding.h"

#include <algorithm>
#include <cmath>

#include "dynamics/energy_guard.h"
#include "model/node_sums.h"

namespace drape::dynamics {
namespace {

constraint::ConstraintRow weld_row(const model::NodeSum& gap) {
  constraint::ConstraintRow row{-1, {}, {}, {0, 0, 0}};
  for (const model::NodeTerm& t : gap) {
    if (t.weight == 0) continue;
    row.node.push_back(t.node);
    row.weight.push_back(t.weight);
  }
  return row;
}

bool is_welded(const State& s, std::size_t pair) { return s.sewn[pair] == model::Sewn::kWelded; }

}  // namespace

bool seams_pull_begin(const System& system, State& s) {
  const double time = model::state_time(s, system.communication), rounding = 1e-9 * system.communication;
  bool begins = false;
  for (const model::Seam& seam : system.seams.seam) {
    if (!seam.close && time < seam.closed_at - rounding) continue;
    for (std::size_t p = seam.first; p < seam.first + seam.count; ++p) {
      if (s.sewn[p] != model::Sewn::kOpen) continue;
      s.sewn[p] = model::Sewn::kPulled;
      const Vec3 rate = model::sum_value(system.seams.pair[p].gap, s.vx, s.vy, s.vz);
      std::copy(rate.begin(), rate.end(), &s.gap_rate[3 * p]);
      begins = true;
    }
  }
  return begins;
}

bool seams_to_close(const System& system, const State& s) {
  for (const model::Seam& seam : system.seams.seam)
    for (std::size_t p = seam.first; p < seam.first + seam.count; ++p)
      if (s.sewn[p] == model::Sewn::kPulled ||
          (s.sewn[p] == model::Sewn::kOpen && std::isfinite(seam.closed_at)))
        return true;
  return false;
}

std::vector<std::size_t> seams_within_tolerance(const System& system, const State& s) {
  std::vector<std::size_t> due;
  for (const model::Seam& seam : system.seams.seam)
    for (std::size_t p = seam.first; p < seam.first + seam.count; ++p)
      if (s.sewn[p] == model::Sewn::kPulled &&
          math::vector3::norm(model::sum_value(system.seams.pair[p].gap, s)) <= seam.gap_tolerance)
        due.push_back(p);
  return due;
}

void seams_weld(const System& system, Motion& motion, State& s, const std::vector<std::size_t>& pairs) {
  double moved = 0;
  for (const model::Seam& seam : system.seams.seam) moved = std::max(moved, seam.gap_tolerance);
  change_begin(system, motion, s, Change::kRare);
  const double lost = contact::edge_record_sides(system, motion.contact.edge_scratch, s, moved);
  if (system.energy) s.dissipated += lost;
  for (std::size_t p : pairs) s.sewn[p] = model::Sewn::kWelded;
  seams_restore(system, motion, s);
  held_follow(motion.constraints, s, motion.held);
  constraints_place(system, motion.constraints, motion.held, {s.x.data(), s.y.data(), s.z.data()});
  constraints_project(system, motion.constraints, motion.held, {s.vx.data(), s.vy.data(), s.vz.data()},
                      &s.pin_impulse);
  if (!s.wx.empty()) s.wx = s.vx, s.wy = s.vy, s.wz = s.vz;
  contact::invalidate_proximity(s);
  if (!s.body.empty())
    contact::update_proximity(system, motion.kernel->contact, motion.contact, s, 0,
                              model::step_next(system, s));
  contact::self_invalidate_proximity(system, s, moved);
}

void seams_restore(const System& system, Motion& motion, const State& s) {
  const std::size_t pairs = s.sewn.size();
  motion.welded.resize(pairs, 0);
  bool same = true;
  for (std::size_t p = 0; p < pairs; ++p) same = same && bool(motion.welded[p]) == is_welded(s, p);
  if (same) return;
  std::vector<constraint::ConstraintRow> rows = system.pin_rows;
  for (std::size_t p = 0; p < pairs; ++p) {
    motion.welded[p] = is_welded(s, p);
    if (is_welded(s, p)) rows.push_back(weld_row(system.seams.pair[p].gap));
  }
  std::vector<Problem> none;  // the pins were checked when the system was made
  motion.constraints =
      constraint::constraints_make(rows, system.inverse_mass, system.constraints.pins, none, system.links);
  motion.held = held_make(motion.constraints);
  contact::mark_tied(system, motion.constraints, motion.contact);
}

}  // namespace drape::dynamics
