// The inputs of the C interface: their checks, and how they become the end of the paths of the next advance.
#include <algorithm>
#include <cmath>
#include <utility>

#include "api/cloth.h"
#include "math/vector3.h"
#include "scene/limits.h"

namespace drape::api {
namespace {

using namespace math::vector3;

bool all_zero(const double* q) { return q[0] == 0 && q[1] == 0 && q[2] == 0 && q[3] == 0; }

// One vector input: its value and rate as written, and the present value.
struct VectorInput {
  std::string name;
  const scene::Quantity* limits;
  int size;
  double *value, *rate;
  const double* now;  // null: an invalid number becomes 0
};

// Sets `reached` [size], the value after `length`, s. An invalid number is a problem, and is reset to the
// present value.
void vector_apply(const VectorInput& v, double length, double* reached, std::vector<Problem>& problems) {
  for (int k = 0; k < v.size; ++k) {
    const std::string name = v.name + "[" + std::to_string(k + 1) + "]";
    reached[k] = v.rate[k] == 0 ? v.value[k] : v.value[k] + length * v.rate[k];
    if (scene::quantity_fits(*v.limits, v.value[k]) && scene::quantity_fits(*v.limits, reached[k])) continue;
    const bool by_rate = scene::quantity_fits(*v.limits, v.value[k]);
    problems.push_back({name, (by_rate ? "+ its derivative times the length of the advance " : "") +
                                  limits_text(*v.limits, by_rate ? reached[k] : v.value[k])});
    v.value[k] = v.now ? v.now[k] : 0;
    v.rate[k] = 0;
  }
}

// An orientation that comes to length 0 by its derivative is a problem, and is reset to the present one.
void orientation_validate(const VectorInput& v, double* reached, std::vector<Problem>& problems) {
  if (!all_zero(reached)) return;
  problems.push_back({v.name, "has the length 0; allowed: any length above 0"});
  for (int k = 0; k < 4; ++k) v.value[k] = v.now[k], v.rate[k] = 0;
}

// The inputs of a driven pin or a moving body, `name`, and its present motion.
struct MotionInput {
  std::string name;
  drape_pin_input *value, *rate;
  const math::RigidMotion* now;
  bool velocity_given = true;  // false: its velocities have not been given so far, and stay 0
};

void motion_apply(const MotionInput& input, double length, math::RigidMotion& to,
                  std::vector<Problem>& problems) {
  drape_pin_input &in = *input.value, &rate = *input.rate;
  const math::RigidMotion& now = *input.now;
  const auto apply = [&](VectorInput v, double* reached) {
    v.name = input.name + "." + v.name;
    const std::size_t before = problems.size();
    vector_apply(v, length, reached, problems);
    if (v.size == 4 && problems.size() == before) orientation_validate(v, reached, problems);
  };
  if (in.drive & DRAPE_DRIVE_POSITION) {
    apply({"position", &scene::kPinPosition, 3, in.position, rate.position, now.position.data()},
          to.position.data());
    if (in.clamp)
      apply({"orientation", &scene::kPinOrientation, 4, in.orientation, rate.orientation,
             now.orientation.data()},
            to.orientation.data());
  }
  if (in.drive & DRAPE_DRIVE_VELOCITY) {
    apply({"velocity", &scene::kPinVelocity, 3, in.velocity, rate.velocity,
           input.velocity_given ? now.velocity.data() : nullptr},
          to.velocity.data());
    if (in.clamp)
      apply({"angular_velocity", &scene::kPinAngularVelocity, 3, in.angular_velocity, rate.angular_velocity,
             input.velocity_given ? now.angular_velocity.data() : nullptr},
            to.angular_velocity.data());
  }
}

int drive_bits(scene::Drive drive) {
  return drive == scene::Drive::kPosition   ? DRAPE_DRIVE_POSITION
         : drive == scene::Drive::kVelocity ? DRAPE_DRIVE_VELOCITY
                                            : DRAPE_DRIVE_POSITION | DRAPE_DRIVE_VELOCITY;
}

// How fast an advance moves by what it reaches, and by the mean of the rates at its ends.
struct Speeds {
  double by_reach, by_rates;
  bool contradict;
};
Speeds speeds_of(const Vec3& reach, const Vec3& rate_from, const Vec3& rate_to, double slow) {
  constexpr double kShare = 0.6;  // of the faster of both; from rest to v at once it is 0.5
  const Vec3 mean = 0.5 * (rate_from + rate_to);
  const Speeds s{norm(reach), norm(mean), false};
  return {s.by_reach, s.by_rates,
          norm(reach - mean) > std::max(slow, kShare * std::max(s.by_reach, s.by_rates))};
}

// Warns once of a pin or body whose positions and velocities, or orientations and angular velocities, are of
// two different motions over this advance.
void contradiction_report(const drape_cloth& c, const MotionInput& input, const math::RigidMotion& to,
                          double length, ToldContradiction& told) {
  constexpr double kSlow = 1e-3, kSlowTurn = 1e-2;  // m/s; rad/s, that of 0.1 m from the axis
  const math::RigidMotion& now = *input.now;
  const auto report = [&](const std::string& positions, const char* velocities, const char* unit,
                          const Speeds& s) {
    log_message(c, DRAPE_LOG_WARNING,
                input.name + ": its " + positions + " it at " + number(s.by_reach) + unit + ", its " +
                    velocities + " at " + number(s.by_rates) + unit +
                    "; give both of one motion, or set drive = \"position\" or \"velocity\"");
    return true;
  };
  const Vec3 reach = (1 / length) * (to.position - now.position);
  const Speeds moves = speeds_of(reach, now.velocity, to.velocity, kSlow);
  if (moves.contradict && !told.position)
    told.position = report("positions move", "velocities", " m/s", moves);
  if (!input.value->clamp) return;
  const Vec3 turn = (1 / length) * math::rotation_vector_between(now.orientation,
                                                                 math::quaternion_normalised(to.orientation));
  const Speeds turns = speeds_of(turn, now.angular_velocity, to.angular_velocity, kSlowTurn);
  if (turns.contradict && !told.orientation)
    told.orientation = report("orientations turn", "angular velocities", " rad/s", turns);
}

MotionInput pin_input(drape_cloth& c, std::size_t k) {
  return {std::string("pin.") + c.pin_inputs[k].name, &c.pin_inputs[k], &c.pin_rates[k],
          &c.state.pin_motion[c.driven[k]]};
}

MotionInput body_input(drape_cloth& c, std::size_t k) {
  const model::BodyContact& now = c.state.body[c.moving[k]];
  return {std::string("body.") + c.body_inputs[k].name, &c.body_inputs[k], &c.body_rates[k], &now.motion,
          c.system.bodies[c.moving[k]].drive != scene::Drive::kNone || now.velocity_given};
}

void contradictions_report(drape_cloth& c, const dynamics::Inputs& to, double length) {
  for (std::size_t k = 0; k < c.driven.size(); ++k)
    if (c.scene.pins[c.driven[k]].drive == scene::Drive::kBoth)
      contradiction_report(c, pin_input(c, k), to.pin[c.driven[k]], length, c.pin_told[k]);
  for (std::size_t k = 0; k < c.moving.size(); ++k) {
    const std::size_t b = c.moving[k];
    if (dynamics::body_drive(c.system.bodies[b], c.state.body[b], to.body[b]) == scene::Drive::kBoth)
      contradiction_report(c, body_input(c, k), to.body[b], length, c.body_told[k]);
  }
}

}  // namespace

void inputs_make(drape_cloth& c) {
  for (std::size_t p = 0; p < c.scene.pins.size(); ++p) {
    const scene::PinSpec& pin = c.scene.pins[p];
    if (pin.drive == scene::Drive::kNone) continue;
    drape_pin_input in{};
    in.name = pin.name.c_str();
    in.drive = drive_bits(pin.drive);
    in.clamp = pin.clamp;
    c.pin_rates.push_back(in);
    for (std::size_t k = 0; k < 3; ++k) in.position[k] = c.state.pin_motion[p].position[k];
    in.orientation[0] = 1;
    c.pin_inputs.push_back(in);
    c.pin_told.emplace_back();
    c.driven.push_back(p);
  }
  for (std::size_t b = 0; b < c.system.bodies.size(); ++b) {
    const model::Body& body = c.system.bodies[b];
    if (!body.moves) continue;
    drape_pin_input in{};
    in.name = body.name.c_str();
    in.drive = drive_bits(body.drive);
    in.clamp = 1;
    c.body_rates.push_back(in);
    std::copy(body.start.position.begin(), body.start.position.end(), in.position);
    std::copy(body.start.orientation.begin(), body.start.orientation.end(), in.orientation);
    c.body_inputs.push_back(in);
    c.body_told.emplace_back();
    c.moving.push_back(b);
  }
  for (drape_inputs* inputs : {&c.inputs, &c.input_rates}) {
    inputs->has_wind = c.scene.has_air;
    inputs->body_count = int(c.moving.size());
    inputs->pin_count = int(c.driven.size());
  }
  for (std::size_t k = 0; k < 3; ++k) c.inputs.wind[k] = c.scene.wind[k];
  c.inputs.pin = c.pin_inputs.data();
  c.input_rates.pin = c.pin_rates.data();
  c.inputs.body = c.body_inputs.data();
  c.input_rates.body = c.body_rates.data();
}

// Some masters write 0 to what is not connected: the orientation stays as it is. Told once, until another
// value is given.
void inputs_validate(drape_cloth& c) {
  const auto validate = [&](const char* kind, drape_pin_input& in, const drape_pin_input& rate,
                            const math::RigidMotion& now, ToldContradiction& told) {
    if (!in.clamp || !(in.drive & DRAPE_DRIVE_POSITION) || !all_zero(rate.orientation)) return;
    const bool zero = all_zero(in.orientation);
    if (zero) std::copy(now.orientation.begin(), now.orientation.end(), in.orientation);
    if (zero && !told.zero) {
      c.surprised = true;
      log_message(c, DRAPE_LOG_WARNING,
                  std::string(kind) + in.name +
                      ".orientation is four zeros, and no rotation: the orientation stays as it is");
    }
    told.zero = zero;
  };
  for (std::size_t k = 0; k < c.driven.size(); ++k)
    validate("pin.", c.pin_inputs[k], c.pin_rates[k], c.state.pin_motion[c.driven[k]], c.pin_told[k]);
  for (std::size_t k = 0; k < c.moving.size(); ++k)
    validate("body.", c.body_inputs[k], c.body_rates[k], c.state.body[c.moving[k]].motion, c.body_told[k]);
}

bool inputs_apply(drape_cloth& c, double length, std::vector<Problem>& problems) {
  dynamics::Inputs to = dynamics::inputs_at(c.state);
  const std::size_t before = problems.size();
  if (c.inputs.has_wind)
    vector_apply({"wind", &scene::kWind, 3, c.inputs.wind, c.input_rates.wind, c.state.wind.data()}, length,
                 to.wind.data(), problems);
  for (std::size_t k = 0; k < c.driven.size(); ++k)
    motion_apply(pin_input(c, k), length, to.pin[c.driven[k]], problems);
  for (std::size_t k = 0; k < c.moving.size(); ++k)
    motion_apply(body_input(c, k), length, to.body[c.moving[k]], problems);
  if (problems.size() > before) return false;
  contradictions_report(c, to, length);
  c.motion.inputs = std::move(to);
  return true;
}

void inputs_clear_rates(drape_cloth& c) {
  for (double& rate : c.input_rates.wind) rate = 0;
  for (std::vector<drape_pin_input>* rates : {&c.pin_rates, &c.body_rates})
    for (drape_pin_input& rate : *rates) {
      for (double* v : {rate.position, rate.velocity, rate.angular_velocity})
        for (int k = 0; k < 3; ++k) v[k] = 0;
      for (double& q : rate.orientation) q = 0;
    }
}

}  // namespace drape::api
