// Sequences of calls of the FMI, legal and illegal. All follows from the seed.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

#include "fmi_master.h"

namespace drape::fuzz {
namespace {

struct FmiScene {
  const char* name;
  bool touches = false;  // bodies or self-contact
};
constexpr FmiScene kScenes[] = {{"hanging"},
                                {"driven"},
                                {"order_4"},
                                {"order_6"},
                                {"sewn"},
                                {"fitted"},
                                {"paper"},
                                {"bodies", true},
                                {"self_contact", true},
                                {"bodies_and_self_contact", true}};

const FmiScene& scene_of(std::uint64_t seed, const std::string& name) {
  for (const FmiScene& scene : kScenes)
    if (name == scene.name) return scene;
  return kScenes[seed % std::size(kScenes)];
}

// A step can be made so short that an interval takes minutes, which is no fault: by its own limit, or by what
// moves in contact at a thousand metres per second and more. Such values are left out for the start value.
double value_quick(const Sequence& s, fmi2ValueReference reference, double value) {
  constexpr double kFastest = 1000;  // m/s
  if (reference == 0 || reference > s.resources.table.size()) return value;
  const description::Variable& v = s.resources.table[reference - 1];
  const double start = s.resources.start[reference - 1], q = s.resources.interval;
  const bool is_input = v.causality == description::Causality::kInput, is_length = !std::strcmp(v.unit, "m");
  const bool too_short = v.family == "step.max" && value < 0.05 * q,
             too_far = is_input && is_length && std::abs(value - start) > kFastest * q,
             too_fast = is_input && !is_length && std::abs(value) > kFastest;
  return too_short || too_far || too_fast ? start : value;
}

fmi2ValueReference reference_draw(Sequence& s) {
  const std::size_t count = s.resources.table.size();
  if (!s.random.chance(10)) return fmi2ValueReference(1 + s.random.below(count));
  const std::size_t odd[] = {0, count + 1, 0x7fffffff, 0x80000000, 0xffffffff};
  return fmi2ValueReference(s.random.pick(odd));
}

// Of one that may be set more often than not.
fmi2ValueReference setting_draw(Sequence& s) {
  fmi2ValueReference reference = reference_draw(s);
  for (int k = 0; k < 8 && reference > 0 && reference <= s.resources.table.size(); ++k) {
    if (s.resources.table[reference - 1].causality != description::Causality::kOutput) break;
    reference = reference_draw(s);
  }
  return reference;
}

double value_draw(Sequence& s) {
  if (s.random.chance(6)) return odd_value(s.random);
  const double scales[] = {1e-6, 1e-3, 0.1, 1, 10, 1000};
  return (double(s.random.below(2001)) / 1000 - (s.random.chance(2) ? 1 : 0)) * s.random.pick(scales);
}

void get_reals(Sequence& s, Slave& slave) {
  std::vector<fmi2ValueReference> references(s.random.below(6));
  for (fmi2ValueReference& r : references) r = reference_draw(s);
  std::vector<double> values(references.size());
  const bool missing = s.random.chance(40);
  CALL(fmi2GetReal, references.data(), references.size(), missing ? nullptr : values.data());
}

void set_reals(Sequence& s, Slave& slave) {
  std::vector<fmi2ValueReference> references(1 + s.random.below(s.random.chance(4) ? 12 : 2));
  std::vector<double> values(references.size());
  for (std::size_t k = 0; k < values.size(); ++k) {
    references[k] = setting_draw(s), values[k] = value_draw(s);
    const bool known = references[k] > 0 && references[k] <= s.resources.table.size();
    if (known && s.random.chance(2)) {  // within its range, as a master would
      const description::Range& range = s.resources.table[references[k] - 1].range;
      const double low = std::max(range.min, -1.0), high = std::min(range.max, std::max(1.0, low + 1));
      values[k] = low + (high - low) * double(s.random.below(1001)) / 1000;
      if (range.whole) values[k] = std::round(values[k]);
    }
    values[k] = value_quick(s, references[k], values[k]);
  }
  const bool missing = s.random.chance(60);
  if (s.random.chance(4)) {
    std::vector<fmi2Integer> orders(values.size(),
                                    s.random.chance(8) ? fmi2Integer(s.random.below(4)) - 1 : 1);
    CALL(fmi2SetRealInputDerivatives, references.data(), values.size(), missing ? nullptr : orders.data(),
         values.data());
  } else {
    CALL(fmi2SetReal, references.data(), values.size(), missing ? nullptr : values.data());
  }
}

void other_types(Sequence& s, Slave& slave) {
  const fmi2ValueReference reference = reference_draw(s);
  const std::size_t count = s.random.below(2);
  fmi2Integer integer = 1;
  fmi2String text = "x";
  switch (s.random.below(8)) {
    case 0:
      CALL(fmi2GetInteger, &reference, count, &integer);
      break;
    case 1:
      CALL(fmi2SetInteger, &reference, count, &integer);
      break;
    case 2:
      CALL(fmi2GetBoolean, &reference, count, &integer);
      break;
    case 3:
      CALL(fmi2SetBoolean, &reference, count, &integer);
      break;
    case 4:
      CALL(fmi2GetString, &reference, count, &text);
      break;
    case 5:
      CALL(fmi2SetString, &reference, count, &text);
      break;
    case 6:
      CALL(fmi2SetString, nullptr, 3, nullptr);
      break;
    default:
      CALL(fmi2GetInteger, nullptr, count, nullptr);
      break;
  }
}

// True where parameters within their ranges have made the cloth so stiff that more steps take minutes.
bool steps_used_up(Sequence& s, Slave& slave) {
  constexpr double kSteps = 1e5;
  double count = 0;
  const auto row = std::ranges::find(s.resources.table, "step.count", &description::Variable::family);
  const auto reference = fmi2ValueReference(row - s.resources.table.begin() + 1);
  return CALL(fmi2GetReal, &reference, 1, &count) == fmi2OK && count > kSteps;
}

void step(Sequence& s, Slave& slave) {
  if (steps_used_up(s, slave)) return;
  const double q = s.resources.interval;
  const double lengths[] = {q,       q,        q,        2 * q,     3 * q,          0.3 * q,
                            1.7 * q, 1e-3 * q, 1e-8 * q, 1e-10 * q, q * (1 + 1e-12)};
  double length = s.random.pick(lengths), time = slave.time;
  if (s.random.chance(12)) {
    const double odd[] = {0, -q, -0.0, NAN, INFINITY, -INFINITY, 1e300, 1e9, 5e-324, 1e-200};
    length = s.random.pick(odd);
  }
  if (s.random.chance(20)) time = s.random.chance(2) ? odd_value(s.random) : time + q;
  if (length <= 3 * q || !(length < 1e6)) {  // a valid length of 1e9 s would be computed
    if (CALL(fmi2DoStep, time, length, fmi2Boolean(s.random.below(2))) == fmi2OK) outputs_read(s, slave);
  }
  double now = 0;
  if (CALL(fmi2GetRealStatus, fmi2LastSuccessfulTime, &now) == fmi2OK) slave.time = now;
}

void setup(Sequence& s, Slave& slave) {
  const double q = s.resources.interval;
  double start = s.random.chance(3) ? 7 * q : 0, stop = s.random.chance(3) ? start + 40 * q : 1e9;
  if (s.random.chance(10)) start = odd_value(s.random);
  if (s.random.chance(10)) stop = odd_value(s.random);
  if (CALL(fmi2SetupExperiment, fmi2Boolean(s.random.below(2)), odd_value(s.random), start,
           fmi2Boolean(s.random.below(2)), stop) == fmi2OK)
    slave.time = start;
}

void states(Sequence& s, Slave& slave) {
  Slave& other = s.slave[slave.component == s.slave[0].component ? 1 : 0];
  const std::size_t at = s.random.below(slave.saved.size());
  switch (s.random.below(5)) {
    case 0:
    case 1: {
      Slave::Saved saved{nullptr, {}};
      const bool over = !slave.saved.empty() && s.random.chance(3);
      if (over) saved.state = slave.saved[at].state;
      if (CALL(fmi2GetFMUstate, s.random.chance(40) ? nullptr : &saved.state) != fmi2OK) break;
      saved.outputs = outputs_read(s, slave);
      if (over) slave.saved[at] = saved;
      else slave.saved.push_back(saved);
      break;
    }
    case 2:
    case 3: {
      fmi2FMUstate state = slave.saved.empty() ? nullptr : slave.saved[at].state;
      const bool foreign = s.random.chance(12) && !other.saved.empty();
      if (foreign) state = other.saved[0].state;
      if (CALL(fmi2SetFMUstate, state) != fmi2OK) break;
      if (foreign) s.outcome.faults.push_back("a state of another instance was restored");
      const std::vector<double> now = outputs_read(s, slave);
      if (!foreign && !slave.saved[at].outputs.empty() &&
          (now.size() != slave.saved[at].outputs.size() ||
           std::memcmp(now.data(), slave.saved[at].outputs.data(), now.size() * sizeof(double)) != 0))
        s.outcome.faults.push_back("a restored state has other outputs than when it was saved");
      if (fmi2GetRealStatus(slave.component, fmi2LastSuccessfulTime, &slave.time) != fmi2OK) slave.time = 0;
      break;
    }
    default:
      if (slave.saved.empty()) {
        CALL(fmi2FreeFMUstate, nullptr);
      } else if (CALL(fmi2FreeFMUstate, &slave.saved[at].state) == fmi2OK) {
        slave.saved.erase(slave.saved.begin() + std::ptrdiff_t(at));
      }
  }
}

// A saved state as bytes, whole or damaged, for this slave or the other. Restored, it gives the outputs that
// it was saved with.
void serialize(Sequence& s, Slave& slave) {
  if (slave.saved.empty()) return;
  const Slave::Saved saved = slave.saved[s.random.below(slave.saved.size())];
  std::size_t size = 0;
  if (CALL(fmi2SerializedFMUstateSize, saved.state, s.random.chance(40) ? nullptr : &size) != fmi2OK) return;
  const bool enough = !s.random.chance(12);
  std::vector<fmi2Byte> bytes(enough ? size : s.random.below(size));
  const bool missing = s.random.chance(40);
  const fmi2Status written =
      CALL(fmi2SerializeFMUstate, saved.state, missing ? nullptr : bytes.data(), bytes.size());
  if (written == fmi2OK && !enough) s.outcome.faults.push_back("a state was written to too small a place");
  bool damaged = written != fmi2OK;
  if (s.random.chance(3) && !bytes.empty()) {
    damaged = true;
    const unsigned bit = 1u << s.random.below(8);
    fmi2Byte& byte = bytes[s.random.below(bytes.size())];
    byte = fmi2Byte(unsigned(byte) ^ bit);
    if (s.random.chance(3)) bytes.resize(s.random.below(bytes.size()));
  }
  Slave& taker = s.slave[s.random.chance(2) ? 1 : 0];
  if (!taker.component) return;
  Slave::Saved read{nullptr, saved.outputs};
  const fmi2Status status =
      called(s, taker, "fmi2DeSerializeFMUstate",
             fmi2DeSerializeFMUstate(taker.component, bytes.data(), bytes.size(), &read.state));
  if (status == fmi2OK && damaged) s.outcome.faults.push_back("damaged bytes were taken for a state");
  if (status != fmi2OK && !damaged) s.outcome.faults.push_back("whole bytes were refused");
  if (status == fmi2OK) taker.saved.push_back(read);
}

// Calls that the FMU offers to nobody: each is an error, whatever bytes and places it is given.
void absent(Sequence& s, Slave& slave) {
  double value[4] = {NAN, 1, 2, 3};
  fmi2EventInfo info{};
  const fmi2ValueReference reference[2] = {reference_draw(s), reference_draw(s)};
  const auto refused = [&](fmi2Status status, const char* name) {
    if (called(s, slave, name, status) != fmi2Error)
      s.outcome.faults.push_back(std::string(name) + " is no error");
  };
  fmi2Component c = slave.component;
  switch (s.random.below(8)) {
    case 0:
      return refused(fmi2GetDirectionalDerivative(c, reference, 2, reference, 2, value, value), "derivative");
    case 1:
      return refused(fmi2CancelStep(c), "cancel");
    case 2:
      return refused(fmi2EnterEventMode(c), "event mode");
    case 3:
      return refused(fmi2NewDiscreteStates(c, &info), "discrete states");
    case 4:
      return refused(fmi2SetTime(c, NAN), "time");
    case 5:
      return refused(fmi2SetContinuousStates(c, value, 4), "continuous states");
    case 6:
      return refused(fmi2GetDerivatives(c, value, 4), "derivatives");
    default:
      return refused(fmi2GetContinuousStates(c, nullptr, 4), "states");
  }
}

void status_ask(Sequence& s, Slave& slave) {
  const fmi2StatusKind kind = fmi2StatusKind(s.random.below(4));
  double real;
  fmi2Integer integer;
  fmi2String text;
  fmi2Status status;
  switch (s.random.below(5)) {
    case 0:
      CALL(fmi2GetRealStatus, kind, s.random.chance(5) ? nullptr : &real);
      break;
    case 1:
      CALL(fmi2GetIntegerStatus, kind, &integer);
      break;
    case 2:
      CALL(fmi2GetBooleanStatus, kind, s.random.chance(5) ? nullptr : &integer);
      break;
    case 3:
      CALL(fmi2GetStringStatus, kind, &text);
      break;
    default:
      CALL(fmi2GetStatus, kind, &status);
  }
}

void logging(Sequence& s, Slave& slave) {
  const fmi2String names[] = {"logEvents", "logStability", "nothing", nullptr, "%s%n"};
  CALL(fmi2SetDebugLogging, fmi2Boolean(s.random.below(2)), s.random.below(6),
       s.random.chance(5) ? nullptr : names);
}

// Rarely, what ends the life of a slave or sets it back.
void life_end(Sequence& s, Slave& slave) {
  switch (s.random.below(12)) {
    case 0:
      CALL(fmi2Terminate);
      break;
    case 1:
      if (CALL(fmi2Reset) == fmi2OK) slave.time = 0;
      break;
    case 2:
      slave_free(s, slave);
      break;
    default:  // mostly, nothing ends
      break;
  }
}

void initialization_enter(Sequence& s, Slave& slave) { CALL(fmi2EnterInitializationMode); }
void initialization_exit(Sequence& s, Slave& slave) { CALL(fmi2ExitInitializationMode); }
void outputs_look(Sequence& s, Slave& slave) { outputs_read(s, slave); }

struct Action {
  void (*run)(Sequence& s, Slave& slave);
  std::size_t weight;
};
constexpr Action kActions[] = {{setup, 1},
                               {initialization_enter, 2},
                               {initialization_exit, 3},
                               {life_end, 2},
                               {get_reals, 2},
                               {set_reals, 6},
                               {other_types, 1},
                               {states, 3},
                               {serialize, 2},
                               {absent, 1},
                               {status_ask, 1},
                               {logging, 1},
                               {outputs_look, 1},
                               {step, 8}};

void call_one(Sequence& s) {
  Slave& slave = s.slave[s.random.chance(4)];
  if (!slave.component && !s.random.chance(10)) return slave_instantiate(s, slave);
  std::size_t weights = 0;
  for (const Action& action : kActions) weights += action.weight;
  std::size_t drawn = s.random.below(weights);
  for (const Action& action : kActions) {
    if (drawn < action.weight) return action.run(s, slave);
    drawn -= action.weight;
  }
}

}  // namespace

bool fmi_scene_touches(std::uint64_t seed, const std::string& scene) { return scene_of(seed, scene).touches; }

void fmi_sequence(const std::filesystem::path& work, std::uint64_t seed, const std::string& scene,
                  Outcome& outcome) {
  static std::map<std::string, Resources> known;
  const std::string name = scene_of(seed, scene).name;
  if (!known.contains(name)) known.emplace(name, resources_make(work, name));
  Sequence s{{std::mt19937_64(seed)}, known.at(name), outcome, {}, {}};
  s.callbacks = {s.random.chance(20) ? nullptr : fmi_logger, nullptr, nullptr, nullptr, &s};
  for (std::size_t k = 20 + s.random.below(60); k > 0; --k) call_one(s);
  for (Slave& slave : s.slave) slave_free(s, slave);
}

}  // namespace drape::fuzz
