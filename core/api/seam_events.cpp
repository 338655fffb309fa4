// Events of seams at the beginning of a communication interval: closing starts, and pairs that have met are
// welded. Either event changes the system instantly. What it adds to the energies is work of the seams.
#include <algorithm>

#include "api/cloth.h"
#include "dynamics/energy_guard.h"
#include "dynamics/potential_energy.h"
#include "dynamics/seam_welding.h"
#include "math/vector3.h"
#include "model/node_sums.h"

namespace drape::api {
namespace {

// Logs the seams whose last open pairs are among `welded`.
void log_closed(const drape_cloth& c, const std::vector<std::size_t>& welded) {
  const std::vector<model::Seam>& seams = c.system.seams.seam;
  for (std::size_t k = 0; k < seams.size(); ++k) {
    const std::size_t first = seams[k].first, end = first + seams[k].count;
    bool closed = true, just_now = false;
    for (std::size_t p = first; p < end; ++p) closed = closed && c.state.sewn[p] == model::Sewn::kWelded;
    for (std::size_t p : welded) just_now = just_now || (p >= first && p < end);
    if (!closed || !just_now) continue;
    const std::string place = "at " + number(model::state_time(c.state, c.system.communication), 9) +
                              " s the seam '" + c.scene.seams[k].name + "' is ";
    double gap = 0;  // m
    for (std::size_t p = first; p < end; ++p)
      gap = std::max(gap, math::vector3::norm(model::sum_value(c.system.seams.pair[p].gap, c.state)));
    if (gap <= seams[k].gap_tolerance / 100) log_message(c, DRAPE_LOG_EVENT, place + "closed");
    else
      log_message(c, DRAPE_LOG_WARNING,
                  place + "sewn but held open: pins or other seams leave a gap of " + number(gap, 3) +
                      " m; allowed: pins that let both sides meet, or a seam.gap_tol above the gap");
  }
}

}  // namespace

bool seam_events_advance(drape_cloth& c) {
  if (c.system.seams.seam.empty()) return false;
  bool changed = dynamics::seams_pull_begin(c.system, c.state);
  const std::vector<std::size_t> pairs = dynamics::seams_within_tolerance(c.system, c.state);
  if (!pairs.empty()) {
    dynamics::change_begin(c.system, c.motion, c.state, dynamics::Change::kRare);
    const double before = balance_error(c);
    dynamics::seams_weld(c.system, c.motion, c.state, pairs);
    if (c.state.steps == 0) dynamics::energy_begin(c.system, c.state);
    c.state.input += balance_error(c) - before;
    log_closed(c, pairs);
    changed = true;
  }
  if (!pairs.empty()) dynamics::leapfrog_welded(c.system, c.motion, c.state);
  else if (changed) dynamics::leapfrog_retuned(c.system, c.motion, c.state);
  return changed;
}

}  // namespace drape::api
