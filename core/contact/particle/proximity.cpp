// Which particles must look for their neighbours anew, and how long a step may be until they do.
#include <algorithm>
#include <cmath>

#include "contact/edge/elements.h"
#include "contact/particle/contact.h"
#include "math/vector3.h"
#include "model/body_pose.h"

namespace drape::contact {
namespace {

using namespace math::vector3;

void block_update(const System& system, ContactWorkspace& workspace, State& s, std::size_t b,
                  std::size_t node, double ahead) {
  const model::Body& body = system.bodies[b];
  const model::Lattice& l = model::system_lattice_of(system, node);
  const math::RigidMotion& motion = s.body[b].motion;
  NeighbourNodes nodes{node, l.piece, l.contact_law.distance, {}, {}};
  for (std::size_t i = 0; i < std::size_t(math::kRowUnit); ++i) {
    const std::size_t n = node + i;
    const Vec3 at{s.x[n], s.y[n], s.z[n]}, arm = at - motion.position;
    Vec3 v{s.vx[n], s.vy[n], s.vz[n]};
    if (body.moves) v = v - motion.velocity - cross(motion.angular_velocity, arm);
    nodes.place[i] = model::pose_inward(body, s.body[b], at);
    nodes.step[i] = model::pose_inward(body, s.body[b], at + ahead * v) - nodes.place[i];
  }
  update_neighbours(
      {body.mesh.surface, workspace.distance_grids[b], {body.sharp, edge_near(l), edge_margin(l)}}, nodes,
      workspace.neighbours, s.body[b]);
}

}  // namespace

double max_contact_distance(const System& system) {
  double largest = 0;
  for (const model::Lattice& l : system.lattices) largest = std::max(largest, l.contact_law.distance);
  return largest;
}

namespace {

constexpr double kMaxTravel = 0.5;  // of the distance beyond contact that triangles are listed for
constexpr double kLeft = 0.25;      // of a free distance

struct StepBound {
  double listed;      // m, that a step may move a particle by, whatever its free distance
  double body_speed;  // m/s, of the fastest point of the body
};
StepBound step_bound(const System& system, const State& s, std::size_t b) {
  const body::BodySurface& surface = system.bodies[b].mesh.surface;
  const double contact_distance = max_contact_distance(system);
  const math::RigidMotion& motion = s.body[b].motion;
  return {kMaxTravel * (search_reach(surface, contact_distance) - contact_distance),
          math::vector3::norm(motion.velocity) + math::vector3::norm(motion.angular_velocity) * surface.size};
}

double free_travel2_of(const StepBound& bound, const model::BodyContact& c, std::size_t n) {
  return std::max(bound.listed * bound.listed,
                  c.free_distance2.empty() ? 0 : kLeft * kLeft * c.free_distance2[n]);
}

double speed2_of(const State& s, std::size_t n) {
  return s.vx[n] * s.vx[n] + s.vy[n] * s.vy[n] + s.vz[n] * s.vz[n];
}

// Whether a particle of the block, whose neighbours have just been updated, would move farther in a step than
// the last check of the step limit could know.
bool outruns(const System& system, const State& s, std::size_t b, const StepBound& bound, std::size_t node,
             double step) {
  for (std::size_t n = node; n < node + std::size_t(math::kRowUnit); ++n)
    if (system.mass[n] > 0 && step * (std::sqrt(speed2_of(s, n)) + bound.body_speed) >
                                  std::sqrt(free_travel2_of(bound, s.body[b], n)))
      return true;
  return false;
}

}  // namespace

void invalidate_proximity(State& s) {
  for (model::BodyContact& c : s.body) std::fill(c.group_clearance.begin(), c.group_clearance.end(), 0.0);
}

void update_proximity(const System& system, const ContactKernel& kernel, ContactWorkspace& workspace,
                      State& s, double drift, double ahead) {
  for (std::size_t b = 0; b < s.body.size(); ++b) {
    std::size_t count = 0;
    for (const model::Lattice& l : system.lattices) {
      ProximityPass pass{&s.body[b],
                         {s.x.data(), s.y.data(), s.z.data()},
                         {s.vx.data(), s.vy.data(), s.vz.data()},
                         drift,
                         ahead,
                         l.first,
                         l.first + std::size_t(l.rows) * std::size_t(l.stride)};
      count += kernel.update_proximity[system.bodies[b].moves](pass, workspace.stale.data() + count);
      pass.begin = l.twin_first, pass.end = l.end();
      count += kernel.update_proximity[system.bodies[b].moves](pass, workspace.stale.data() + count);
    }
    const bool chosen = count > 0 && system.step_given == 0 && !system.fit;
    const StepBound bound = chosen ? step_bound(system, s, b) : StepBound{};
    for (std::size_t k = 0; k < count; ++k) {
      block_update(system, workspace, s, b, workspace.stale[k], ahead);
      if (chosen &&
          outruns(system, s, b, bound, workspace.stale[k], std::max(ahead, model::step_next(system, s))))
        s.steps_to_limit_check = 0;
    }
    edge_update_proximity(system, workspace.edge_scratch, s, b, ahead);
  }
}

double max_step(const System& system, const State& s) {
  double longest = INFINITY;
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const StepBound bound = step_bound(system, s, b);
    double smallest2 = INFINITY;  // s^2, of a body that stays
    for (std::size_t n : system.particle) {
      const double travel2 = free_travel2_of(bound, s.body[b], n), speed2 = speed2_of(s, n);
      if (bound.body_speed > 0)
        longest = std::min(longest, std::sqrt(travel2) / (std::sqrt(speed2) + bound.body_speed));
      else smallest2 = std::min(smallest2, travel2 / speed2);
    }
    longest = std::min(longest, std::sqrt(smallest2));
  }
  return std::min(longest, edge_max_step(system, s).step);
}

MaxStep max_step_setter(const System& system, const State& s) {
  MaxStep least;
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const StepBound bound = step_bound(system, s, b);
    for (std::size_t n : system.particle) {
      const double speed = std::sqrt(speed2_of(s, n)) + bound.body_speed;
      max_step_include(least, {std::sqrt(free_travel2_of(bound, s.body[b], n)) / speed, speed, b, n});
    }
  }
  max_step_include(least, edge_max_step(system, s));
  return least;
}

}  // namespace drape::contact
