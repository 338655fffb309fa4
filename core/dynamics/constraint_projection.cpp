#include "dynamics/constraint_projection.h"

#include <algorithm>
#include <cmath>

#include "math/vector3.h"

namespace drape::dynamics {
namespace {

using namespace math::vector3;

// A projection of a step: the first one, or again, of what contact has added since.
struct StepProjection {
  const model::Scheme& scheme;
  bool again = false;
  const char* touched = nullptr;  // as in constraints_project_again
};

void load_add(const constraint::Constraints& c, const Array& arm, const constraint::Target& t,
              const Vec3& impulse, std::vector<math::Wrench>& load) {
  for (int p = t.first; p < t.first + t.count; ++p) {
    const constraint::TargetPart& part = c.parts[std::size_t(p)];
    math::Wrench& sum = load[std::size_t(part.pin)];
    sum.force += part.share * impulse;
    sum.torque += cross(at(arm, std::size_t(p)), impulse);
  }
}

Vec3 row_sum(const math::SparseRow& row, const model::Field& f) {
  Vec3 sum{0, 0, 0};
  for (std::size_t k = 0; k < row.node.size(); ++k) sum += row.weight[k] * at(f, row.node[k]);
  return sum;
}

// y <- (A M^-1 A^T)^-1 (A f - target) of a part
void part_solve(const constraint::RowPart& part, const model::Field& f, const double* target, double* y) {
  const constraint::RowTerm* t = part.term.data();
  for (std::size_t k = part.begin; k < part.end; ++k) {
    double sum[3] = {-target[3 * k], -target[3 * k + 1], -target[3 * k + 2]};
    for (const constraint::RowTerm* end = part.term.data() + part.last[k - part.begin]; t != end; ++t) {
      sum[0] += t->weight * f.x[t->node];
      sum[1] += t->weight * f.y[t->node];
      sum[2] += t->weight * f.z[t->node];
    }
    std::copy_n(sum, 3, y + 3 * k);
  }
  math::cholesky_solve(part.factor, y + 3 * part.begin);
}

// f <- f - M^-1 A^T y;  kRate: of v as well, by `rate` of it.
template <bool kRate>
void part_correct(const constraint::RowPart& part, const double* y, const model::Field& f,
                  const model::Field& v, double rate) {
  const constraint::RowTerm* t = part.term.data();
  for (std::size_t k = part.begin; k < part.end; ++k)
    for (const constraint::RowTerm* end = part.term.data() + part.last[k - part.begin]; t != end; ++t) {
      const double dx = t->pull * y[3 * k], dy = t->pull * y[3 * k + 1], dz = t->pull * y[3 * k + 2];
      f.x[t->node] -= dx, f.y[t->node] -= dy, f.z[t->node] -= dz;
      if constexpr (kRate) v.x[t->node] -= rate * dx, v.y[t->node] -= rate * dy, v.z[t->node] -= rate * dz;
    }
}

void rows_project(const constraint::Constraints& c, const double* target, Array& y, const model::Field& f) {
  for (const constraint::RowPart& part : c.part) {
    part_solve(part, f, target, y.data());
    part_correct<false>(part, y.data(), f, f, 0);
  }
}

bool is_hit(const constraint::RowPart& part, const char* hit) {
  return std::any_of(part.line.begin(), part.line.end(), [&](std::uint32_t l) { return hit[l] != 0; });
}

// m [v_{n-1/2} + h_o a/2 - (1 + c h_o/2) v_n] over m, from what the free step left.
Vec3 reported(const StepProjection& step, const Vec3& old, const Vec3& free, const Vec3& rate) {
  return step.scheme.decay_before * old +
         (step.scheme.half / step.scheme.kick) * (free - step.scheme.decay * old) -
         step.scheme.centred * rate;
}

// The same of a change of the velocity since.
Vec3 reported_change(const StepProjection& step, const Vec3& change) {
  return (step.scheme.half / step.scheme.kick) * change;
}

void fixed_apply(const System& system, const constraint::Constraints& c, const StepProjection& step,
                 HeldMotion& held, State& s) {
  const model::Field r{s.x.data(), s.y.data(), s.z.data()}, v{s.vx.data(), s.vy.data(), s.vz.data()};
  for (std::size_t k = 0; k < c.fixed.size(); ++k) {
    const std::size_t n = c.fixed[k].node;
    const Vec3 next = at(held.next, k), free = at(v, n),
               kept = (1 / step.scheme.drift) * (next - at(held.now, k));
    Vec3 impulse = (system.mass[n] * step.scheme.impulse) * (free - kept);
    if (held.moves) s.drive_work += impulse_work(impulse, step.scheme.decay_before * at(held.old, k), kept);
    if (step.scheme.begins_advance)
      impulse -= system.mass[n] * (step.again ? reported_change(step, free - kept)
                                              : reported(step, at(held.old, k), free, at(held.rate, k)));
    load_add(c, held.arm, c.fixed[k].target, impulse, s.pin_impulse);
    set(v, n, kept);
    set(r, n, next);
  }
}

void rows_apply(const constraint::Constraints& c, const StepProjection& step, HeldMotion& held, State& s) {
  const model::Field r{s.x.data(), s.y.data(), s.z.data()}, v{s.vx.data(), s.vy.data(), s.vz.data()};
  const std::size_t fixed = c.fixed.size();
  const bool reports = step.scheme.begins_advance && !step.again;
  std::size_t entry = fixed;
  const auto old_of = [&](const math::SparseRow& row) {
    Vec3 sum{0, 0, 0};
    for (double w : row.weight) sum += w * at(held.old, entry++);
    return sum;
  };
  if (reports) {
    for (std::size_t k = 0; k < c.rows.size(); ++k) {
      const math::SparseRow& row = c.rows[k].on;
      set(held.z, k, reported(step, old_of(row), row_sum(row, v), at(held.rate, fixed + k)));
    }
    for (const constraint::RowPart& part : c.part) math::cholesky_solve(part.factor, &held.z[3 * part.begin]);
  }
  for (const constraint::RowPart& part : c.part) {
    if (step.again && step.touched && !is_hit(part, step.touched)) {
      std::fill_n(&held.y[3 * part.begin], 3 * (part.end - part.begin), 0.0);
      continue;
    }
    part_solve(part, r, held.next.data() + 3 * fixed, held.y.data());
    part_correct<true>(part, held.y.data(), r, v, 1 / step.scheme.drift);
  }
  const auto impulse_of = [&](std::size_t k) {
    return (step.scheme.impulse / step.scheme.drift) * at(held.y, k);
  };
  entry = fixed;
  for (std::size_t k = 0; held.moves && k < c.rows.size(); ++k) {
    const math::SparseRow& row = c.rows[k].on;
    s.drive_work += impulse_work(impulse_of(k), step.scheme.decay_before * old_of(row), row_sum(row, v));
  }
  for (std::size_t k : c.rows_with_target) {
    Vec3 impulse = impulse_of(k);
    if (step.scheme.begins_advance)
      impulse -= reports ? at(held.z, k) : reported_change(step, (1 / step.scheme.drift) * at(held.y, k));
    load_add(c, held.arm, c.rows[k].target, impulse, s.pin_impulse);
  }
}

// Sets the right-hand side of the scalar rows: left(k) of row k, excess(k) of link k.
template <class Left, class Excess>
void rigid_right_hand_side(const constraint::Constraints& c, constraint::RigidNow& now, Left left,
                           Excess excess) {
  for (std::size_t k = 0; k < c.rows.size(); ++k) {
    const Vec3 v = left(k);
    std::copy(v.begin(), v.end(), &now.b[3 * k]);
  }
  for (std::size_t k = 0; k < c.rigid.link.size(); ++k) now.b[c.rigid.held + k] = excess(k);
}

double largest_excess(const constraint::Constraints& c, const model::Field& r) {  // over the length of a link
  double largest = 0;
  for (const constraint::RigidLink& link : c.rigid.link)
    largest = std::max(largest, std::abs(constraint::rigid_excess(link, r.x, r.y, r.z)) / link.length);
  return largest;
}

// Positions, and the velocities that change by 1/h of what positions do; null: none do.
struct MovedPositions {
  model::Field r;
  const model::Field* v = nullptr;
  double h = 1;  // s
};

// Projects positions onto rows and links by sweeps, with multipliers in now.y.
void rigid_project_positions(const System& system, const constraint::Constraints& c, const Array& target,
                             const MovedPositions& moved, constraint::RigidNow& now) {
  const model::Field &r = moved.r, *v = moved.v;
  const double h = moved.h;
  constexpr int kSweeps = 4;
  constexpr double kMet = 1e-9;
  const constraint::RigidField fields[] = {{r.x, r.y, r.z, 1},
                                           {v ? v->x : r.x, v ? v->y : r.y, v ? v->z : r.z, v ? 1 / h : 0}};
  std::fill(now.y.begin(), now.y.end(), 0.0);
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    if (sweep > 0 && largest_excess(c, r) <= kMet) break;
    rigid_right_hand_side(
        c, now, [&](std::size_t k) { return row_sum(c.rows[k].on, r) - at(target, c.fixed.size() + k); },
        [&](std::size_t k) { return constraint::rigid_excess(c.rigid.link[k], r.x, r.y, r.z); });
    constraint::rigid_correct(c.rigid, system.inverse_mass, now, fields, v ? 2 : 1);
  }
}

// Projects a field onto the rates of rows and links, with multipliers in held.y.
void rigid_project(const System& system, const constraint::Constraints& c, const model::Field& f,
                   HeldMotion& held) {
  constexpr int kSweeps = 4;
  constraint::RigidNow& now = held.rigid;
  const constraint::RigidField field{f.x, f.y, f.z, 1};
  std::fill(now.y.begin(), now.y.end(), 0.0);
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    rigid_right_hand_side(
        c, now, [&](std::size_t k) { return row_sum(c.rows[k].on, f) - at(held.rate, c.fixed.size() + k); },
        [&](std::size_t k) { return constraint::rigid_along(c.rigid, now, k, f.x, f.y, f.z) - now.rate[k]; });
    constraint::rigid_correct(c.rigid, system.inverse_mass, now, &field, 1);
  }
  std::copy_n(now.y.begin(), held.y.size(), held.y.begin());
}

// As rows_apply, with links.
void rigid_apply(const System& system, const constraint::Constraints& c, const StepProjection& step,
                 HeldMotion& held, State& s) {
  const model::Field r{s.x.data(), s.y.data(), s.z.data()}, v{s.vx.data(), s.vy.data(), s.vz.data()};
  const std::size_t fixed = c.fixed.size();
  constraint::RigidNow& now = held.rigid;
  std::size_t entry = fixed;
  const bool reports = step.scheme.begins_advance && !step.again;
  std::vector<Vec3> old;
  for (const constraint::HeldRow& row : c.rows) {
    Vec3 sum{0, 0, 0};
    for (double w : row.on.weight) sum += w * at(held.old, entry++);
    old.push_back(sum);
  }
  if (reports) {
    rigid_right_hand_side(
        c, now,
        [&](std::size_t k) {
          return reported(step, old[k], row_sum(c.rows[k].on, v), at(held.rate, fixed + k));
        },
        [&](std::size_t k) {
          Vec3 sum{0, 0, 0};
          for (std::size_t end : {0u, 1u}) {
            const Vec3 was = at(held.old, entry + 2 * k + end), is = at(v, c.rigid.link[k].node[end]);
            sum += (end == 0 ? -1.0 : 1.0) * reported(step, was, is, {0, 0, 0});
          }
          const double* u = &now.weight[c.rigid.begin[c.rigid.held + k] + 3];
          return u[0] * sum[0] + u[1] * sum[1] + u[2] * sum[2];
        });
    constraint::rigid_factor(c.rigid, system.inverse_mass, now);
    math::cholesky_solve_scalar(now.factor, now.b.data());
    std::copy_n(now.b.begin(), held.z.size(), held.z.begin());
  }
  rigid_project_positions(system, c, held.next, {r, &v, step.scheme.drift}, now);
  for (std::size_t k = 0; k < c.rows.size(); ++k) {
    Vec3 impulse = (step.scheme.impulse / step.scheme.drift) * at(now.y, k);
    if (held.moves)
      s.drive_work += impulse_work(impulse, step.scheme.decay_before * old[k], row_sum(c.rows[k].on, v));
    if (step.scheme.begins_advance)
      impulse -= reports ? at(held.z, k) : reported_change(step, (1 / step.scheme.drift) * at(now.y, k));
    load_add(c, held.arm, c.rows[k].target, impulse, s.pin_impulse);
  }
}

void step_project(const System& system, const constraint::Constraints& c, const StepProjection& step,
                  HeldMotion& held, State& s) {
  fixed_apply(system, c, step, held, s);
  if (!c.rigid.link.empty()) rigid_apply(system, c, step, held, s);
  else if (!c.rows.empty()) rows_apply(c, step, held, s);
}

}  // namespace

void constraints_project_step(const System& system, const constraint::Constraints& c,
                              const model::Scheme& scheme, HeldMotion& held, State& s) {
  if (held.moves)
    targets_visit(c, [&](std::size_t k, const constraint::Target& t) {
      if (t.moves) set(held.next, k, held_target(c, s, t));
    });
  step_project(system, c, {scheme}, held, s);
}

void constraints_project_again(const System& system, const constraint::Constraints& c,
                               const model::Scheme& scheme, const char* touched, HeldMotion& held, State& s) {
  step_project(system, c, {scheme, true, touched}, held, s);
}

void constraints_end_step(const constraint::Constraints& c, const State& s, HeldMotion& held) {
  constraint::rigid_aim(c.rigid, s.x.data(), s.y.data(), s.z.data(), held.rigid);
  if (!held.moves) return;
  held.now.swap(held.next);
  held.next = held.now;
  held_arms_set(c, s, held);
}

void constraints_place(const System& system, const constraint::Constraints& c, HeldMotion& held,
                       model::Field r) {
  for (std::size_t k = 0; k < c.fixed.size(); ++k) set(r, c.fixed[k].node, at(held.now, k));
  if (!c.rigid.link.empty()) {
    rigid_project_positions(system, c, held.now, {r}, held.rigid);
    constraint::rigid_aim(c.rigid, r.x, r.y, r.z, held.rigid);
    return;
  }
  rows_project(c, held.now.data() + 3 * c.fixed.size(), held.y, r);
}

void constraints_project(const System& system, const constraint::Constraints& c, HeldMotion& held,
                         model::Field field, std::vector<math::Wrench>* load) {
  const std::size_t fixed = c.fixed.size();
  for (std::size_t k = 0; k < fixed; ++k) {
    const std::size_t n = c.fixed[k].node;
    set(held.out, k, system.mass[n] * (at(field, n) - at(held.rate, k)));
    set(field, n, at(held.rate, k));
  }
  if (!c.rigid.link.empty()) {
    rigid_project(system, c, field, held);
  } else {
    rows_project(c, held.rate.data() + 3 * fixed, held.y, field);
  }
  for (std::size_t k = 0; k < c.rows.size(); ++k) set(held.out, fixed + k, at(held.y, k));
  for (std::size_t k = 0; k < held.out.size(); ++k) held.taken[k] += held.out[k];
  if (load)
    targets_visit(c, [&](std::size_t k, const constraint::Target& t) {
      load_add(c, held.arm, t, at(held.out, k), *load);
    });
}

}  // namespace drape::dynamics
