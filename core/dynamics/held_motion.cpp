#include "dynamics/held_motion.h"

namespace drape::dynamics {
namespace {

using namespace math::vector3;

// The target of a part less its start: share (p - p_0) + (R - 1)(start - share p_0), exactly 0 before the pin
// moves.
Vec3 part_shift(const constraint::PinBase& base, const math::RigidMotion& frame,
                const constraint::TargetPart& part) {
  const Vec3 reach = part.start - part.share * base.centre;
  return part.share * (frame.position - base.centre) + math::rotation_displacement(frame.orientation, reach);
}

// share v + w x arm; share a + w' x arm + w x (w x arm)
Vec3 part_rate(const math::RigidMotion& f, double share, const Vec3& arm, model::Pass pass) {
  if (pass != model::Pass::kAcceleration) return share * f.velocity + cross(f.angular_velocity, arm);
  return share * f.acceleration + cross(f.angular_acceleration, arm) +
         cross(f.angular_velocity, cross(f.angular_velocity, arm));
}

// The acceleration along a link: of its rotation, and of what a step does against its error of length. In a
// fit a step moves by h^2 times the inverse mass scale.
double link_acceleration(const constraint::RigidLink& link, const State& s) {
  const auto [a, b] = link.node;
  const Vec3 turns = Vec3{s.vx[b], s.vy[b], s.vz[b]} - Vec3{s.vx[a], s.vy[a], s.vz[a]};
  const double turning = -dot(turns, turns) / link.length;
  if (s.h_old == 0) return turning;
  const double step2 = s.h_old * s.h_old * (s.inverse_mass_scale.empty() ? 1 : s.inverse_mass_scale[a]);
  return turning - constraint::rigid_excess(link, s.x.data(), s.y.data(), s.z.data()) / step2;
}

}  // namespace

Vec3 held_target(const constraint::Constraints& c, const State& s, const constraint::Target& t) {
  Vec3 sum = t.start;
  for (int p = t.first; p < t.first + t.count; ++p) {
    const constraint::TargetPart& part = c.parts[std::size_t(p)];
    sum += part_shift(c.pins[std::size_t(part.pin)], s.pin_motion[std::size_t(part.pin)], part);
  }
  return sum;
}

void held_arms_set(const constraint::Constraints& c, const State& s, HeldMotion& held) {
  for (std::size_t p = 0; p < c.parts.size(); ++p) {
    const constraint::TargetPart& part = c.parts[p];
    const Vec3 reach = part.start - part.share * c.pins[std::size_t(part.pin)].centre;
    set(held.arm, p,
        reach + math::rotation_displacement(s.pin_motion[std::size_t(part.pin)].orientation, reach));
  }
}

HeldMotion held_make(const constraint::Constraints& c) {
  HeldMotion held;
  std::size_t entries = c.fixed.size();
  for (const constraint::HeldRow& row : c.rows) entries += row.on.node.size();
  entries += 2 * c.rigid.link.size();
  held.rigid = constraint::rigid_now(c.rigid);
  for (Array* a : {&held.now, &held.next, &held.rate, &held.out, &held.taken})
    a->assign(3 * (c.fixed.size() + c.rows.size()), 0.0);
  for (Array* a : {&held.y, &held.z}) a->assign(3 * c.rows.size(), 0.0);
  held.arm.assign(3 * c.parts.size(), 0.0);
  held.old.assign(3 * entries, 0.0);
  targets_visit(c, [&](std::size_t k, const constraint::Target& t) {
    set(held.now, k, t.start);
    set(held.next, k, t.start);
    held.moves = held.moves || t.moves;
  });
  return held;
}

void held_refresh(const constraint::Constraints& c, const State& s, HeldMotion& held) {
  held_arms_set(c, s, held);
  constraint::rigid_aim(c.rigid, s.x.data(), s.y.data(), s.z.data(), held.rigid);
  targets_visit(c, [&](std::size_t k, const constraint::Target& t) {
    if (t.moves) set(held.now, k, held_target(c, s, t));
  });
}

void held_rates(const constraint::Constraints& c, const State& s, model::Pass pass, HeldMotion& held) {
  targets_visit(c, [&](std::size_t k, const constraint::Target& t) {
    Vec3 sum{0, 0, 0};
    for (int p = t.first; t.moves && p < t.first + t.count; ++p) {
      const constraint::TargetPart& part = c.parts[std::size_t(p)];
      sum += part_rate(s.pin_motion[std::size_t(part.pin)], part.share, at(held.arm, std::size_t(p)), pass);
    }
    set(held.rate, k, sum);
  });
  for (std::size_t k = 0; k < c.rigid.link.size(); ++k)
    held.rigid.rate[k] = pass != model::Pass::kAcceleration ? 0 : link_acceleration(c.rigid.link[k], s);
}

void held_follow(const constraint::Constraints& c, const State& s, HeldMotion& held) {
  held_refresh(c, s, held);
  held_rates(c, s, model::Pass::kSynchronous, held);
}

void held_store_velocities(const constraint::Constraints& c, const State& s, HeldMotion& held) {
  std::size_t entry = 0;
  const auto keep = [&](std::size_t n) { set(held.old, entry++, {s.vx[n], s.vy[n], s.vz[n]}); };
  for (const constraint::FixedNode& f : c.fixed) keep(f.node);
  for (const constraint::HeldRow& row : c.rows)
    for (std::size_t n : row.on.node) keep(n);
  for (const constraint::RigidLink& link : c.rigid.link)
    for (std::size_t n : link.node) keep(n);
}

double held_work(const constraint::Constraints& c, const State& s, double before, double centred,
                 const HeldMotion& held) {
  double sum = 0;
  for (std::size_t k = 0; k < c.fixed.size(); ++k) {
    const std::size_t n = c.fixed[k].node;
    sum +=
        impulse_work(centred * at(held.taken, k), before * Vec3{s.vx[n], s.vy[n], s.vz[n]}, at(held.rate, k));
  }
  for (std::size_t r = 0; r < c.rows.size(); ++r) {
    const math::SparseRow& row = c.rows[r].on;
    Vec3 old{0, 0, 0};
    for (std::size_t k = 0; k < row.node.size(); ++k)
      old += row.weight[k] * Vec3{s.vx[row.node[k]], s.vy[row.node[k]], s.vz[row.node[k]]};
    sum += impulse_work(centred * at(held.taken, c.fixed.size() + r), before * old,
                        at(held.rate, c.fixed.size() + r));
  }
  return sum;
}

}  // namespace drape::dynamics
