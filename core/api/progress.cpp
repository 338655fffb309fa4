// How far an advance has come. What this reads are the state and constants, never the workspace of the step.
#include "api/cloth.h"
#include "math/plain_environment.h"
#include "math/vector3.h"
#include "model/node_sums.h"

using namespace drape;
using namespace drape::api;

namespace {

// As drape_seam.due and drape_seam.closed.
bool seam_is_open(const drape_cloth& c, const model::Seam& seam) {
  bool due = false, closed = true;
  for (std::size_t p = seam.first; p < seam.first + seam.count; ++p) {
    due = due || c.state.sewn[p] != model::Sewn::kOpen;
    closed = closed && c.state.sewn[p] == model::Sewn::kWelded &&
             math::vector3::norm(model::sum_value(c.system.seams.pair[p].gap, c.state)) <= seam.gap_tolerance;
  }
  return due && !closed;
}

}  // namespace

void drape_on_interval(drape_cloth* c, drape_interval_fn* call, void* user) {
  c->on_interval = call;
  c->on_interval_user = user;
}

drape_progress drape_progress_of(drape_cloth* c) {
  const math::PlainEnvironment plain;
  c->limit_link = c->system.fit ? "" : step_setter(*c, 0);
  drape_progress now{};
  now.time = model::state_time(c->state, c->system.communication);
  now.step_size = c->system.communication / double(c->state.steps_per_interval);
  now.set_by = c->limit_link.c_str();
  now.residual = c->state.relaxation.residual;
  for (const model::Seam& seam : c->system.seams.seam) now.seams_open += seam_is_open(*c, seam);
  return now;
}
