// Seams at the beginning of a communication interval: pulling begins, and what has come together is welded.
// Either changes the system in an instant; what that adds to the energies is work of the seams.
#include "cloth.h"
#include "motion/weld.h"
#include "outputs/energy.h"

namespace drape {
namespace {

// Tells of seams that pairs of `due` have closed.
void closed_tell(const drape_cloth& c, const std::vector<std::size_t>& due) {
  const std::vector<Seam>& seams = c.system.seams.seam;
  for (std::size_t k = 0; k < seams.size(); ++k) {
    const std::size_t first = seams[k].first, end = first + seams[k].count;
    bool closed = true, now = false;
    for (std::size_t p = first; p < end; ++p) closed = closed && c.state.sewn[p] == Sewn::kWelded;
    for (std::size_t p : due) now = now || (p >= first && p < end);
    if (closed && now)
      say(c, DRAPE_LOG_EVENT,
          "at " + number(state_time(c.state, c.system.communication), 9) + " s the seam '" +
              c.scene.seams[k].name + "' is closed");
  }
}

}  // namespace

bool sewing_go(drape_cloth& c) {
  if (c.system.seams.seam.empty()) return false;
  bool changed = seams_pull_begin(c.system, c.state);
  const std::vector<std::size_t> due = seams_due(c.system, c.state);
  if (!due.empty()) {
    leapfrog_complete(c.system, c.motion, c.state);
    const double before = balance_error(c);
    seams_weld(c.system, c.motion, c.state, due);
    if (c.state.steps == 0) energy_begin(c.system, c.state);
    c.state.input += balance_error(c) - before;
    closed_tell(c, due);
    changed = true;
  }
  if (changed) leapfrog_retuned(c.system, c.motion, c.state);
  return changed;
}

}  // namespace drape
