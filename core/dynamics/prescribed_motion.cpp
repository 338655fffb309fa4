#include "dynamics/prescribed_motion.h"

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
  const Vec3 reach = (h / 2) * (p.from.spin + p.to.spin) + (h * h / 12) * cross(p.to.spin, p.from.spin);
  if (is_zero(cross(p.from.spin, p.to.spin)) || norm(reach) > std::numbers::pi)
    parabola(p.turn, h * p.from.spin, h * p.to.spin);
  else cubic(p.turn, reach, h * p.from.spin, h * math::rotation_rate(reach, p.to.spin));
}

void pin_path_lay(PinPath& p, scene::Drive drive, bool clamp) {
  const double h = p.length;
  p.jumps = drive == scene::Drive::kPosition;
  if (!clamp) p.to.turn = p.from.turn, p.to.spin = {0, 0, 0};
  if (drive == scene::Drive::kVelocity) {
    parabola(p.shift, h * p.from.velocity, h * p.to.velocity);
    p.to.position = p.from.position + at(p.shift, 1);
    turn_by_velocity(p);
    p.to.turn = turned(at(p.turn, 1), p.from.turn);
    p.uniform = p.from.velocity == p.to.velocity && p.from.spin == p.to.spin;
  } else {
    const Vec3 reach = p.to.position - p.from.position, f = math::rotation_between(p.from.turn, p.to.turn);
    if (drive == scene::Drive::kPosition) {
      line(p.shift, reach);
      line(p.turn, f);
      p.to.velocity = (1 / h) * reach;
    } else {
      cubic(p.shift, reach, h * p.from.velocity, h * p.to.velocity);
      cubic(p.turn, f, h * p.from.spin, h * math::rotation_rate(f, p.to.spin));
    }
  }
  const Vec3 f = at(p.turn, 1), f1 = (1 / h) * slope_at(p.turn, 1), f2 = (1 / (h * h)) * bend_at(p.turn, 1);
  if (drive == scene::Drive::kPosition) p.to.spin = f1;
  if (drive == scene::Drive::kVelocity && !p.uniform && norm(f) > std::numbers::pi)
    p.to.spin = math::rotation_spin(f, f1);
  p.to.acceleration = (1 / (h * h)) * bend_at(p.shift, 1);
  p.to.spin_rate = math::rotation_spin_rate(f, f1, f2);
}

// Differences that rounding makes between two ways to tell the same velocity: `size` over `length`.
bool jumps(const Vec3& a, const Vec3& b, double size, double length) {
  constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();
  return norm(a - b) > kRounding * (size / length + norm(a) + norm(b));
}

}  // namespace

Inputs inputs_at(const State& s) {
  Inputs inputs{s.wind, s.pin_frame, {}};
  for (const model::BodyContact& b : s.body) inputs.body.push_back(b.frame);
  return inputs;
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
    one.from = s.pin_frame[p];
    one.to = inputs.pin[p];
    one.to.turn = math::quaternion_normalised(one.to.turn);
    pin_path_lay(one, pin.drive, pin.clamp);
    path.pins.push_back(one);
  }
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    if (!system.bodies[b].moves) continue;
    PinPath one;
    one.pin = int(b);
    one.length = length;
    one.from = s.body[b].frame;
    one.to = inputs.body[b];
    one.to.turn = math::quaternion_normalised(one.to.turn);
    pin_path_lay(one, scene::Drive::kBoth, true);
    path.bodies.push_back(one);
  }
  return path;
}

bool path_moves(const Path& path) {
  const auto still = [](const Vec3(&c)[3]) { return norm(c[0]) == 0 && norm(c[1]) == 0 && norm(c[2]) == 0; };
  for (const std::vector<PinPath>* paths : {&path.pins, &path.bodies})
    for (const PinPath& p : *paths)
      if (!still(p.shift) || !still(p.turn)) return true;
  return path.wind_from != path.wind_to;
}

bool path_jumps(const Path& path, const State& s) {
  for (const PinPath& p : path.pins) {
    const math::Frame begin = path_frame(p, 0);
    const math::Frame& now = s.pin_frame[std::size_t(p.pin)];
    if (jumps(begin.velocity, now.velocity, norm(p.from.position) + norm(p.to.position), p.length) ||
        jumps(begin.spin, now.spin, 1, p.length))
      return true;
  }
  return false;
}

void path_interval(Path& path, const State& s, std::int64_t k, double length) {
  path.interval = k;
  for (PinPath& p : path.pins) {
    if (!p.uniform) continue;
    p.from = s.pin_frame[std::size_t(p.pin)];
    p.length = length;
    pin_path_lay(p, scene::Drive::kVelocity, true);
  }
}

math::Frame path_frame(const PinPath& p, double z) {
  if (z == 1) return p.to;
  const double h = p.length;
  const Vec3 f = at(p.turn, z), f1 = (1 / h) * slope_at(p.turn, z), f2 = (1 / (h * h)) * bend_at(p.turn, z);
  math::Frame frame{p.from.position + at(p.shift, z),    turned(f, p.from.turn),
                    (1 / h) * slope_at(p.shift, z),      math::rotation_spin(f, f1),
                    (1 / (h * h)) * bend_at(p.shift, z), math::rotation_spin_rate(f, f1, f2)};
  if (z == 0 && !p.jumps) frame.velocity = p.from.velocity, frame.spin = p.from.spin;  // not h v/h
  return frame;
}

namespace {
double share_of(const Path& path, double u) { return (double(path.interval) + u) / double(path.intervals); }
}  // namespace

void path_follow(const Path& path, double u, State& s) {
  const double z = share_of(path, u);
  s.wind = z == 1 ? path.wind_to : path.wind_from + z * (path.wind_to - path.wind_from);
  for (const PinPath& p : path.pins) {
    math::Frame& frame = s.pin_frame[std::size_t(p.pin)];
    frame = path_frame(p, p.uniform ? u : z);
    s.pin_turn[std::size_t(p.pin)] = math::rotation_matrix(frame.turn);
  }
}

void bodies_follow(const Path& path, double u, State& s) {
  for (const PinPath& p : path.bodies) {
    model::BodyContact& body = s.body[std::size_t(p.pin)];
    body.frame = path_frame(p, share_of(path, u));
    body.turn = math::rotation_matrix(body.frame.turn);
  }
}

}  // namespace drape::dynamics
