#include "dynamics/prescribed_motion.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "math/vector3.h"
#include "model/system.h"

namespace drape::dynamics {
namespace {

using namespace math::vector3;

// Through the ends by `reach`, with the slopes a and b (all over z).
void cubic(Vec3 (&c)[3], const Vec3& reach, const Vec3& a, const Vec3& b) {
  c[0] = a;
  c[1] = 3 * reach - 2 * a - b;
  c[2] = a + b - 2 * reach;
}

// With the slopes a and b at the ends.
void parabola(Vec3 (&c)[3], const Vec3& a, const Vec3& b) {
  c[0] = a;
  c[1] = 0.5 * (b - a);
  c[2] = {0, 0, 0};
}

void line(Vec3 (&c)[3], const Vec3& reach) {
  c[0] = reach;
  c[1] = c[2] = {0, 0, 0};
}

Vec3 at(const Vec3 (&c)[3], double z) { return z * (c[0] + z * (c[1] + z * c[2])); }
Vec3 slope_at(const Vec3 (&c)[3], double z) { return c[0] + z * (2 * c[1] + (3 * z) * c[2]); }
Vec3 bend_at(const Vec3 (&c)[3], double z) { return 2 * c[1] + (6 * z) * c[2]; }

bool is_zero(const Vec3& v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }

math::Quaternion turned(const Vec3& f, const math::Quaternion& from) {
  return is_zero(f) ? from
                    : math::quaternion_normalised(math::quaternion_product(math::rotation_exp(f), from));
}

// H (w_0 + w_1)/2 + H^2 w_1 x w_0/12: the turn under an angular velocity along a line, to the fourth order in
// H (Magnus 1954). The cubic with these ends is the parabola where the axis stays.
void turn_by_velocity(PinPath& p) {
  const double h = p.length;
  const Vec3 reach = (h / 2) * (p.from.angular_velocity + p.to.angular_velocity) +
                     (h * h / 12) * cross(p.to.angular_velocity, p.from.angular_velocity);
  if (is_zero(cross(p.from.angular_velocity, p.to.angular_velocity)) || norm(reach) > std::numbers::pi)
    parabola(p.rotation, h * p.from.angular_velocity, h * p.to.angular_velocity);
  else
    cubic(p.rotation, reach, h * p.from.angular_velocity,
          h * math::rotation_vector_rate(reach, p.to.angular_velocity));
}

void pin_path_lay(PinPath& p, scene::Drive drive, bool clamp) {
  const double h = p.length;
  p.jumps = drive == scene::Drive::kPosition;
  if (!clamp) p.to.orientation = p.from.orientation, p.to.angular_velocity = {0, 0, 0};
  if (drive == scene::Drive::kVelocity) {
    parabola(p.translation, h * p.from.velocity, h * p.to.velocity);
    p.to.position = p.from.position + at(p.translation, 1);
    turn_by_velocity(p);
    p.to.orientation = turned(at(p.rotation, 1), p.from.orientation);
    p.uniform = p.from.velocity == p.to.velocity && p.from.angular_velocity == p.to.angular_velocity;
  } else {
    const Vec3 reach = p.to.position - p.from.position,
               f = math::rotation_vector_between(p.from.orientation, p.to.orientation);
    if (drive == scene::Drive::kPosition) {
      line(p.translation, reach);
      line(p.rotation, f);
      p.to.velocity = (1 / h) * reach;
    } else {
      cubic(p.translation, reach, h * p.from.velocity, h * p.to.velocity);
      cubic(p.rotation, f, h * p.from.angular_velocity,
            h * math::rotation_vector_rate(f, p.to.angular_velocity));
    }
  }
  const Vec3 f = at(p.rotation, 1), f1 = (1 / h) * slope_at(p.rotation, 1),
             f2 = (1 / (h * h)) * bend_at(p.rotation, 1);
  if (drive == scene::Drive::kPosition) p.to.angular_velocity = f1;
  if (drive == scene::Drive::kVelocity && !p.uniform && norm(f) > std::numbers::pi)
    p.to.angular_velocity = math::rotation_angular_velocity(f, f1);
  p.to.acceleration = (1 / (h * h)) * bend_at(p.translation, 1);
  p.to.angular_acceleration = math::rotation_angular_acceleration(f, f1, f2);
}

// Whether two velocities differ by more than rounding makes between two expressions of one, that of `size`
// over `length`.
bool jumps(const Vec3& a, const Vec3& b, double size, double length) {
  constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();
  return norm(a - b) > kRounding * (size / length + norm(a) + norm(b));
}

bool begins_with_jump(const PinPath& p) {
  const math::RigidMotion begin = path_frame(p, 0);
  return jumps(begin.velocity, p.from.velocity, norm(p.from.position) + norm(p.to.position), p.length) ||
         jumps(begin.angular_velocity, p.from.angular_velocity, 1, p.length);
}

}  // namespace

Inputs inputs_at(const State& s) {
  Inputs inputs{s.wind, s.pin_motion, {}};
  for (const model::BodyContact& b : s.body) inputs.body.push_back(b.motion);
  return inputs;
}

scene::Drive body_drive(const model::Body& body, const model::BodyContact& now, const math::RigidMotion& to) {
  if (body.drive != scene::Drive::kNone) return body.drive;
  const bool given = now.velocity_given || !is_zero(to.velocity) || !is_zero(to.angular_velocity);
  return given ? scene::Drive::kBoth : scene::Drive::kPosition;
}

Path path_make(const System& system, const State& s, const Inputs& inputs, double length) {
  Path path;
  path.wind_from = s.wind;
  path.wind_to = inputs.wind;
  for (std::size_t p = 0; p < system.constraints.pins.size(); ++p) {
    const constraint::PinBase& pin = system.constraints.pins[p];
    if (pin.drive == scene::Drive::kNone) continue;
    PinPath one;
    one.pin = int(p);
    one.length = length;
    one.from = s.pin_motion[p];
    one.to = inputs.pin[p];
    one.to.orientation = math::quaternion_normalised(one.to.orientation);
    pin_path_lay(one, pin.drive, pin.clamp);
    path.pins.push_back(one);
  }
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    if (!system.bodies[b].moves) continue;
    PinPath one;
    one.pin = int(b);
    one.length = length;
    one.from = s.body[b].motion;
    one.to = inputs.body[b];
    one.to.orientation = math::quaternion_normalised(one.to.orientation);
    pin_path_lay(one, body_drive(system.bodies[b], s.body[b], inputs.body[b]), true);
    path.bodies.push_back(one);
  }
  return path;
}

namespace {
bool still(const Vec3 (&c)[3]) { return norm(c[0]) == 0 && norm(c[1]) == 0 && norm(c[2]) == 0; }
}  // namespace

bool path_rotates(const Path& path) {
  return std::any_of(path.pins.begin(), path.pins.end(), [](const PinPath& p) { return !still(p.rotation); });
}

bool path_moves(const Path& path) {
  for (const std::vector<PinPath>* paths : {&path.pins, &path.bodies})
    for (const PinPath& p : *paths)
      if (!still(p.translation) || !still(p.rotation)) return true;
  return path.wind_from != path.wind_to;
}

bool pins_jump(const Path& path) { return std::any_of(path.pins.begin(), path.pins.end(), begins_with_jump); }

bool bodies_jump(const Path& path) {
  return std::any_of(path.bodies.begin(), path.bodies.end(), begins_with_jump);
}

void path_interval(Path& path, const State& s, std::int64_t k, double length) {
  path.interval = k;
  const auto restart = [&](PinPath& p, const math::RigidMotion& now) {
    if (!p.uniform) return;
    p.from = now;
    p.length = length;
    pin_path_lay(p, scene::Drive::kVelocity, true);
  };
  for (PinPath& p : path.pins) restart(p, s.pin_motion[std::size_t(p.pin)]);
  for (PinPath& p : path.bodies) restart(p, s.body[std::size_t(p.pin)].motion);
}

math::RigidMotion path_frame(const PinPath& p, double z) {
  if (z == 1) return p.to;
  const double h = p.length;
  const Vec3 f = at(p.rotation, z), f1 = (1 / h) * slope_at(p.rotation, z),
             f2 = (1 / (h * h)) * bend_at(p.rotation, z);
  math::RigidMotion frame{
      p.from.position + at(p.translation, z),    turned(f, p.from.orientation),
      (1 / h) * slope_at(p.translation, z),      math::rotation_angular_velocity(f, f1),
      (1 / (h * h)) * bend_at(p.translation, z), math::rotation_angular_acceleration(f, f1, f2)};
  if (z == 0 && !p.jumps)
    frame.velocity = p.from.velocity, frame.angular_velocity = p.from.angular_velocity;  // not h v/h
  return frame;
}

namespace {
double share_of(const Path& path, double u) { return (double(path.interval) + u) / double(path.intervals); }
}  // namespace

void path_follow(const Path& path, double u, State& s) {
  const double z = share_of(path, u);
  s.wind = z == 1 ? path.wind_to : path.wind_from + z * (path.wind_to - path.wind_from);
  for (const PinPath& p : path.pins) {
    math::RigidMotion& frame = s.pin_motion[std::size_t(p.pin)];
    frame = path_frame(p, p.uniform ? u : z);
    s.pin_rotation[std::size_t(p.pin)] = math::rotation_matrix(frame.orientation);
  }
}

void bodies_follow(const Path& path, double u, State& s) {
  for (const PinPath& p : path.bodies) {
    model::BodyContact& body = s.body[std::size_t(p.pin)];
    body.motion = path_frame(p, p.uniform ? u : share_of(path, u));
    body.rotation = math::rotation_matrix(body.motion.orientation);
  }
}

}  // namespace drape::dynamics
