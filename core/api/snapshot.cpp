// Copies of the whole state, within the process and as bytes.
#include "api/snapshot.h"

#include <algorithm>
#include <new>

#include "assembly/assemble.h"
#include "dynamics/seam_welding.h"
#include "math/plain_environment.h"
#include "state/encoding.h"
#include "state/sealed.h"
#include "state/validate.h"

namespace drape::api {
namespace {

void inputs_save(const drape_inputs& from, drape_snapshot::Inputs& to) {
  std::copy(from.wind, from.wind + 3, to.wind);
  to.pin.assign(from.pin, from.pin + from.pin_count);
  to.body.assign(from.body, from.body + from.body_count);
}

void inputs_restore(const drape_snapshot::Inputs& from, drape_inputs& to) {
  std::copy(from.wind, from.wind + 3, to.wind);
  std::copy(from.pin.begin(), from.pin.end(), to.pin);
  std::copy(from.body.begin(), from.body.end(), to.body);
}

// A number of the scene and of the meshes that it was read with.
std::uint64_t scene_hash_of(const drape_cloth& c) {
  std::uint64_t hash = state::bytes_hash(c.text.data(), c.text.size(), 0);
  for (const model::Body& body : c.system.bodies) {
    const body::BodySurface& surface = body.mesh.surface;
    hash = state::bytes_hash(surface.point.data(), surface.point.size() * sizeof(Vec3), hash);
    hash = state::bytes_hash(surface.corner.data(), surface.corner.size() * sizeof(surface.corner[0]), hash);
  }
  return hash;
}

std::uint64_t layout_hash() {
  constexpr std::uint64_t kFormat = 1;  // of encoding.h and sealed.h
  static const std::uint64_t hash = [] {
    state::Layout layout{kFormat};
    layout.type<drape_snapshot>();
    return layout.hash;
  }();
  return hash;
}

state::Seal seal_of(drape_cloth& c) {
  if (c.scene_hash == 0) c.scene_hash = scene_hash_of(c);
  return {layout_hash(), c.scene_hash};
}

// Where forces depend on velocity at the parameters that c.parameters holds.
bool parameters_have_rates(const drape_cloth& c) {
  const drape_parameters& p = c.parameters.c_view;
  bool rates = p.air_normal > 0 || p.air_tangential > 0;  // as parameters_apply gives them to the system
  for (const model::Lattice& l : c.system.lattices) rates = rates || p.fabric[l.fabric].damping > 0;
  return rates;
}

// Checks the tuned values that were read: as if each set were written and committed.
std::string snapshot_problem(drape_cloth& c, const drape_snapshot& read) {
  const ParameterValues written = parameters_read(c.parameters);
  std::vector<Problem> problems;
  for (const ParameterValues* values :
       {&read.tuning.in_force, &read.tuning.ramp.from, &read.tuning.ramp.to}) {
    parameters_write(c.parameters, *values);
    parameters_validate(c.parameters, c.scene, written, problems);
  }
  parameters_write(c.parameters, read.tuning.in_force);
  const bool rates = parameters_have_rates(c);
  if (problems.empty() && !(read.tuning.in_force == c.tuning.in_force)) {
    System trial = c.system;  // diagrams that are legal point by point may give no law
    assembly::system_retune(trial, parameters_fabrics(c.parameters, c.scene), problems);
  }
  parameters_write(c.parameters, written);
  if (!problems.empty()) return "tuned value " + scene::problem_text(problems[0]);
  return state::state_problem(c.system, rates, read.state);
}

}  // namespace
}  // namespace drape::api

using namespace drape;
using namespace drape::api;

drape_snapshot* drape_save(drape_cloth* c, drape_snapshot* into) {
  if (!into) into = new drape_snapshot;
  into->state = c->state;
  into->tuning = c->tuning;
  into->parameters = parameters_read(c->parameters);
  inputs_save(c->inputs, into->inputs);
  inputs_save(c->input_rates, into->input_rates);
  return into;
}

void drape_restore(drape_cloth* c, const drape_snapshot* from) {
  const math::PlainEnvironment plain;
  c->step_above_limit = false;
  c->state = from->state;
  dynamics::workspace_clear(c->motion.workspace);  // of values from the state before
  tuning_restore(*c, from->tuning);
  dynamics::seams_restore(c->system, c->motion, c->state);
  parameters_write(c->parameters, from->parameters);
  inputs_restore(from->inputs, c->inputs);
  inputs_restore(from->input_rates, c->input_rates);
}

void drape_snapshot_free(drape_snapshot* s) { delete s; }

void drape_snapshot_attach(drape_snapshot* s, const void* bytes, size_t size) {
  const auto* from = static_cast<const unsigned char*>(bytes);
  s->attached.assign(from, from + size);
}

const void* drape_snapshot_attached(const drape_snapshot* s, size_t* size) {
  *size = s->attached.size();
  return s->attached.data();
}

size_t drape_snapshot_size(const drape_snapshot* s) {
  state::Encoder<state::Counted> counter{{state::kHeaderSize}};
  counter.value(*s);
  return counter.bytes.size;
}

void drape_snapshot_write(drape_cloth* c, const drape_snapshot* s, void* bytes) {
  auto* begin = static_cast<unsigned char*>(bytes);
  state::Encoder<state::Written> writer{{begin + state::kHeaderSize}};
  writer.value(*s);
  state::seal_write(begin, std::size_t(writer.bytes.at - begin), seal_of(*c));
}

drape_snapshot* drape_snapshot_read(drape_cloth* c, const void* bytes, size_t size) {
  const math::PlainEnvironment plain;
  const auto* begin = static_cast<const unsigned char*>(bytes);
  std::string problem = state::seal_problem(begin, size, seal_of(*c), c->scene.name);
  if (problem.empty()) {
    auto read = std::make_unique<drape_snapshot>();
    try {
      inputs_save(c->inputs, read->inputs);  // for the names of pins and bodies
      inputs_save(c->input_rates, read->input_rates);
      state::Shape shape = state::shape_of(c->system);
      shape[state::Length::kParameters] = parameters_read(c->parameters).value.size();
      shape[state::Length::kDrivenPins] = c->pin_inputs.size();
      shape[state::Length::kMovingBodies] = c->body_inputs.size();
      state::Reader reader{begin + state::kHeaderSize, begin + size, shape, {}};
      reader.value(*read, state::Length::kAny, state::kFinite);
      problem = reader.problem;
      if (problem.empty() && reader.at != reader.end) problem = "has more bytes than fields";
      if (problem.empty()) problem = snapshot_problem(*c, *read);
      if (problem.empty()) return read.release();
      problem = "the saved state is damaged: " + problem;
    } catch (const std::bad_alloc&) {
      problem = "the saved state does not fit into this machine's memory";
    }
  }
  log_message(*c, DRAPE_LOG_ERROR, problem);
  return nullptr;
}
