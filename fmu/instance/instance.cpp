#include "instance/instance.h"

#include <algorithm>
#include <cmath>

#include "decimal.h"
#include "guid.h"
#include "instance/unfinished.h"

namespace drape::instance {
namespace {

// Times this close to the clock are the same. A master that adds up its own clock is off by half a unit in
// the last place for each step it has made, and may have rounded its own step.
double same_time(const Instance& instance, double clock, double length) {
  constexpr double kUlp = std::numeric_limits<double>::epsilon();
  return 1e-6 * length + double(4 + instance.steps) * kUlp * std::max(std::abs(clock), length);
}

bool log_passes(const LogFilter& filter, drape_log_kind kind) {
  switch (kind) {
    case DRAPE_LOG_ERROR:
      return true;
    case DRAPE_LOG_WARNING:
      return filter.warnings;
    case DRAPE_LOG_EVENT:
      return filter.events;
    case DRAPE_LOG_STABILITY:
      return filter.stability;
  }
  return true;
}

void log_write(Instance& instance, drape_status status, drape_log_kind kind, const std::string& message) {
  if (instance.log && log_passes(instance.filter, kind))
    instance.log(instance.log_user, status, kind, message);
}

void core_logged(void* user, drape_log_kind kind, const char* message) {
  static_cast<Instance*>(user)->pending_messages.emplace_back(kind, message);
}

// The choice of node variables under which the scene has this guid. Returns false if there is none.
bool nodes_of_guid(Instance& instance, const std::string& guid, description::Nodes& nodes) {
  const std::string content = description::guid_content(instance.cloth);
  for (const description::Nodes candidate :
       {description::Nodes::kNone, description::Nodes::kOutline, description::Nodes::kAll})
    if (description::guid_of(content, candidate) == guid) {
      nodes = candidate;
      return true;
    }
  instance_refuse(instance, DRAPE_ERROR,
                  "the guid is " + guid + ", but this scene, its meshes and version of Drape have " +
                      description::guid_of(content, description::Nodes::kNone) + ", " +
                      description::guid_of(content, description::Nodes::kOutline) + " or " +
                      description::guid_of(content, description::Nodes::kAll) +
                      " (node variables: none, outline, all)");
  return false;
}

std::string step_problem(const Instance& instance, double time, double length) {
  const double clock = drape_time(instance.cloth), same = same_time(instance, clock, length);
  if (!(length > 0) || !std::isfinite(length))
    return "the communication step is " + description::decimal_text(length) +
           " s; allowed: above 0 s, finite";
  if (!(std::abs(time - clock) <= same))
    return "the communication point is " + description::decimal_text(time) +
           " s; expected: the cloth's time, " + description::decimal_text(clock) + " s";
  if (clock + length > instance.stop_time + same)
    return "the communication step ends at " + description::decimal_text(clock + length) +
           " s; allowed: up to the stop time, " + description::decimal_text(instance.stop_time) + " s";
  return "";
}

}  // namespace

Instance* instance_open(const std::string& scene_file, const std::string& guid, LogFilter filter, LogFn* log,
                        void* user) {
  auto instance = std::make_unique<Instance>();
  instance->log = log;
  instance->log_user = user;
  instance->filter = filter;
  instance->cloth = drape_open(scene_file.c_str(), core_logged, instance.get());
  instance_flush(*instance, instance->cloth ? DRAPE_OK : DRAPE_ERROR);
  if (!instance->cloth) return nullptr;
  description::Nodes nodes = description::Nodes::kNone;
  if (!nodes_of_guid(*instance, guid, nodes)) {
    drape_close(instance->cloth);
    return nullptr;
  }
  instance->table = description::variables_of(instance->cloth, nodes);
  for (std::size_t row = 0; row < instance->table.size(); ++row)
    if (const description::Variable& v = instance->table[row];
        v.causality == description::Causality::kOutput && v.type == description::Type::kReal &&
        v.variability == description::Variability::kContinuous && !v.derivative &&
        !(v.needs & ~DRAPE_OUT_SCALARS))
      instance->recorded.push_back(row);
  instance->has_energy = std::any_of(instance->table.begin(), instance->table.end(),
                                     [](const auto& v) { return (v.needs & DRAPE_OUT_ENERGY) != 0; });
  instance->initial = instance_save(*instance, nullptr);
  return instance.release();
}

void instance_close(Instance* instance) {
  if (!instance) return;
  for (const auto& saved : instance->saved) drape_snapshot_free(saved->cloth);
  drape_close(instance->cloth);
  delete instance;
}

drape_status instance_refuse(Instance& instance, drape_status status, const std::string& sentence) {
  log_write(instance, status, DRAPE_LOG_ERROR, sentence);
  return status;
}

drape_status instance_flush(Instance& instance, drape_status status) {
  for (const auto& [kind, message] : instance.pending_messages)
    log_write(instance, kind == DRAPE_LOG_ERROR ? status : DRAPE_OK, kind, message);
  instance.pending_messages.clear();
  return status;
}

drape_status instance_setup(Instance& instance, double start_time, double stop_time) {
  if (std::isfinite(start_time) && !(stop_time > start_time))  // drape_start refuses others
    return instance_refuse(instance, DRAPE_DISCARD,
                           "the stop time is " + description::decimal_text(stop_time) +
                               " s; allowed: above the start time, " + description::decimal_text(start_time) +
                               " s");
  const drape_status status = instance_flush(instance, drape_start(instance.cloth, start_time));
  if (status == DRAPE_OK) instance.stop_time = stop_time;
  instance.read = 0;
  return status;
}

drape_status instance_exit_initialization(Instance& instance) {
  instance.read = 0;
  const drape_status status = instance_flush(instance, drape_commit(instance.cloth));
  if (status != DRAPE_OK) return status;
  instance.surprised = drape_surprised(instance.cloth);
  instance.phase = Phase::kStepComplete;
  if (instance.has_energy) instance_read_outputs(instance, DRAPE_OUT_ENERGY);
  if (instance.filter.stability) {
    const char* set_by = "";
    const double limit = drape_step_limit(instance.cloth, &set_by);
    log_write(instance, DRAPE_OK, DRAPE_LOG_STABILITY,
              "the step limit is " + description::decimal_text(limit) + " s, set by the " + set_by);
  }
  return status;
}

drape_status instance_step(Instance& instance, double time, double length) {
  if (const std::string problem = step_problem(instance, time, length); !problem.empty())
    return instance_refuse(instance, DRAPE_DISCARD, problem);
  History before = history_take(instance);
  const drape_status status = instance_flush(instance, drape_advance(instance.cloth, length));
  instance.read = 0;
  if (status == DRAPE_ERROR) instance.phase = Phase::kError;
  if (status != DRAPE_OK) return status;
  ++instance.steps;
  before.length = length;
  instance.history = std::move(before);
  instance.surprised = drape_surprised(instance.cloth);
  if (instance.has_energy) instance_read_outputs(instance, DRAPE_OUT_ENERGY);
  return status;
}

void instance_read_outputs(Instance& instance, int needs) {
  const int missing = needs & ~instance.read;
  if (missing == 0) return;
  const drape_outputs& outputs = *drape_get_outputs(instance.cloth, missing);
  instance.read |= missing;
  if (missing & DRAPE_OUT_ENERGY) balance_update(instance.balance, outputs, drape_time(instance.cloth));
}

void instance_terminate(Instance& instance) {
  for (const std::string& sentence : unfinished(instance.cloth))
    log_write(instance, DRAPE_OK, DRAPE_LOG_WARNING, sentence);
  const std::string missing = energy_problem(instance.balance, instance.cloth);
  if (!missing.empty()) log_write(instance, DRAPE_OK, DRAPE_LOG_WARNING, missing);
  instance.phase = Phase::kTerminated;
}

void instance_reset(Instance& instance) { instance_restore(instance, instance.initial); }

}  // namespace drape::instance
