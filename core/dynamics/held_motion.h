// Where held points are, where they are to be, and how they move.
#pragma once
#include "math/vector3.h"
#include "model/scheme.h"
#include "model/system.h"

namespace drape::dynamics {

// Held points at t_n and t_{n+1}. "held" counts the fixed nodes, then the rows.
struct HeldMotion {
  Array now, next;  // [held x 3] m, targets at t_n and t_{n+1}
  Array rate;       // [held x 3] prescribed velocities (or accelerations)
  Array arm;        // [parts x 3] m, R (start - share p_0) at t_n
  Array old;        // [entries x 3] m/s, v_{n-1/2} of fixed nodes and of the rows' and links' nodes in order
  Array y, z;       // [rows x 3]
  Array out;        // [held x 3] m times what the last projection took out
  Array taken;      // [held x 3] the sum of these since it was 0
  constraint::RigidNow rigid;  // links
  bool moves = false;          // a target moves
};
HeldMotion held_make(const constraint::Constraints& constraints);

// Sets targets and arms from the motions of the pins of a state.
void held_refresh(const constraint::Constraints& constraints, const State& state, HeldMotion& held);

// The velocities that held points are to have, or their accelerations.
void held_rates(const constraint::Constraints& constraints, const State& state, model::Pass pass,
                HeldMotion& held);

// Both at the present time, for synchronous velocities.
void held_follow(const constraint::Constraints& constraints, const State& state, HeldMotion& held);

// Stores v_{n-1/2} of the held nodes.
void held_store_velocities(const constraint::Constraints& constraints, const State& state, HeldMotion& held);

// The work of the pins on the cloth while a projection of `centred` m v turned `before` v_{n-1/2} into v_n.
double held_work(const constraint::Constraints& constraints, const State& state, double before,
                 double centred, const HeldMotion& held);

inline Vec3 at(const Array& a, std::size_t k) { return {a[3 * k], a[3 * k + 1], a[3 * k + 2]}; }
inline void set(Array& a, std::size_t k, const Vec3& v) {
  a[3 * k] = v[0], a[3 * k + 1] = v[1], a[3 * k + 2] = v[2];
}

// Visits the targets of fixed nodes and rows by their number: visit(k, target).
template <class Visit>
void targets_visit(const constraint::Constraints& c, Visit visit) {
  std::size_t k = 0;
  for (const constraint::FixedNode& f : c.fixed) visit(k++, f.target);
  for (const constraint::HeldRow& r : c.rows) visit(k++, r.target);
}

// A target at the motions of the pins of a state, m.
Vec3 held_target(const constraint::Constraints& constraints, const State& state,
                 const constraint::Target& target);

// Sets held.arm from the motions of the pins of a state.
void held_arms_set(const constraint::Constraints& constraints, const State& state, HeldMotion& held);

// The work of an impulse on the outside world while what it acts on goes from one velocity to the next.
inline double impulse_work(const Vec3& impulse, const Vec3& old, const Vec3& now) {
  return -0.5 * math::vector3::dot(impulse, math::vector3::operator+(old, now));
}

}  // namespace drape::dynamics
