#include "contact/particle/contact.h"

#include <algorithm>
#include <cmath>

#include "contact/edge/elements.h"
#include "contact/particle/update_neighbours.h"
#include "contact/self/self_contact.h"
#include "math/vector3.h"
#include "model/body_pose.h"

namespace drape::contact {
namespace {

using namespace math::vector3;

ContactPass contact_pass_of(const System& system, ContactWorkspace& workspace, const State& s, std::size_t b,
                            double* sum, bool on = false) {
  ContactPass pass{};
  workspace.law.clear();
  for (const model::Lattice& l : system.lattices)
    workspace.law.push_back(current_law(system, s, system.bodies[b], l));
  pass.body = &s.body[b];
  pass.r[0] = s.x.data(), pass.r[1] = s.y.data(), pass.r[2] = s.z.data();
  pass.old = workspace.old[b].data();
  pass.mass = system.mass.data();
  if (!workspace.tied.empty()) pass.tied = workspace.tied.data(), pass.touched = workspace.touched.data();
  pass.law = workspace.law.data();
  pass.damping = system.bodies[b].damping;
  pass.sum = sum;
  if (system.energy && !on) {
    workspace.given[b].assign(kGivenRows * math::kRowUnit * s.body[b].blocks.order.size(), 0.0);
  }
  if (system.energy) pass.given = workspace.given[b].data();
  workspace.response[b].resize(kResponseRows * math::kRowUnit * s.body[b].blocks.order.size());
  pass.response = workspace.response[b].data();
  pass.on = on;
  return pass;
}

math::Wrench load_of(const double* sum) { return {{sum[0], sum[1], sum[2]}, {sum[3], sum[4], sum[5]}}; }

EdgeField field_of(State& s) {
  return {{s.vx.data(), s.vy.data(), s.vz.data()},
          {s.x.data(), s.y.data(), s.z.data()},
          s.inverse_mass_scale.empty() ? nullptr : s.inverse_mass_scale.data()};
}

EdgeField field_of(const SynchronousPass& of) { return {{of.field.x, of.field.y, of.field.z}, {}, nullptr}; }

double rate_of(double time) { return time > 0 ? 1 / time : kContactUnbound; }

}  // namespace

model::ContactLaw current_law(const System& system, const State& s, const model::Body& body,
                              const model::Lattice& l) {
  model::ContactLaw law = l.contact_law;
  if (body.has_friction) law.friction = body.friction;
  if (system.fit && (s.relaxation.sewing || s.relaxation.settling > 0)) law.friction = {0, 0};
  return law;
}

namespace {

ContactCoefficients step_coefficients(const model::Scheme& scheme) {
  ContactCoefficients c;
  c.drift = scheme.drift;
  c.kick = scheme.kick;
  c.old_time = scheme.half / scheme.impulse;
  c.new_time = scheme.half_new / scheme.impulse;
  c.stop_rate = rate_of(scheme.drift);
  c.push_rate = kContactPush * c.stop_rate;
  c.reach_time = scheme.drift;
  c.impulse = scheme.impulse;
  c.decay = scheme.decay;
  c.reported_share = scheme.half / scheme.kick;
  c.reported_centred = scheme.centred;
  return c;
}

ContactCoefficients last_kick_coefficients(const model::Scheme& scheme) {
  ContactCoefficients c;
  c.kick = scheme.half / scheme.centred;
  c.new_time = scheme.half / scheme.centred;
  c.stop_rate = rate_of(2 * scheme.half);
  c.push_rate = kContactPush * c.stop_rate;
  c.reach_time = 2 * scheme.half;
  c.impulse = scheme.centred;
  return c;
}

ContactCoefficients acceleration_coefficients(const System& system, const State& s) {
  const double h = s.h_old > 0 ? s.h_old : model::step_next(system, s);
  ContactCoefficients c;
  c.kick = 1;
  c.stop_rate = rate_of(h * h);
  return c;
}

}  // namespace

ContactCoefficients coefficients_of(const System& system, const State& s, const model::Scheme& scheme) {
  ContactCoefficients c = scheme.pass == model::Pass::kStep          ? step_coefficients(scheme)
                          : scheme.pass == model::Pass::kSynchronous ? last_kick_coefficients(scheme)
                                                                     : acceleration_coefficients(system, s);
  c.warm_stop = system.fit ? 1 : 0;
  return c;
}

ContactWorkspace workspace_make(const System& system) {
  ContactWorkspace workspace;
  const double contact_distance = max_contact_distance(system);
  for (const model::Body& body : system.bodies)
    workspace.distance_grids.push_back(
        body::distance_grid_make(*body.mesh.library, *body.mesh.query, body.mesh.surface,
                                 search_reach(body.mesh.surface, contact_distance)));
  workspace.old.resize(system.bodies.size());
  workspace.given.resize(system.bodies.size());
  workspace.response.resize(system.bodies.size());
  workspace.load.resize(system.bodies.size());
  workspace.edge_scratch = edge_scratch_make();
  if (!system.bodies.empty()) workspace.stale.resize(system.nodes / math::kRowUnit);
  return workspace;
}

void begin(const System& system, const ContactKernel& kernel, ContactWorkspace& workspace, State& s) {
  edge_begin(system, s);
  for (model::BodyContact& c : s.body) {
    c.blocks = model::ContactBlocks{};
    c.x = s.x, c.y = s.y, c.z = s.z;
    c.free_distance2.assign(system.nodes, INFINITY);
    for (std::size_t n : system.particle) c.free_distance2[n] = 0;
    c.group_clearance.assign(system.nodes / math::kRowUnit, 0.0);
  }
  update_proximity(system, kernel, workspace, s, 0, model::step_next(system, s));
  for (std::size_t b = 0; b < s.body.size(); ++b) {  // particles at rest on a body at rest stick to it
    if (system.bodies[b].moves) continue;
    for (model::ContactBlock& block : s.body[b].blocks.pool)
      for (std::size_t i = 0; i < std::size_t(math::kRowUnit); ++i) {
        const std::size_t n = block.node + i;
        if (s.vx[n] == 0 && s.vy[n] == 0 && s.vz[n] == 0) block.sticking[i] = 1;
      }
  }
  edge_stick(system, s);
}

namespace {

void particle_store_velocities(ContactWorkspace& workspace, const State& s) {
  for (std::size_t b = 0; b < s.body.size(); ++b) {
    const model::ContactBlocks& blocks = s.body[b].blocks;
    workspace.old[b].resize(3 * math::kRowUnit * blocks.order.size());
    double* to = workspace.old[b].data();
    for (const model::ContactPlace& place : blocks.order)
      for (const Array* v : {&s.vx, &s.vy, &s.vz})
        to = std::copy_n(v->data() + std::size_t(place.node) * math::kRowUnit, math::kRowUnit, to);
  }
}

}  // namespace

void store_velocities(const System& system, ContactWorkspace& workspace, State& s) {
  particle_store_velocities(workspace, s);
  const double lost = edge_store_velocities(system, s, workspace.edge_pairs);
  if (system.energy) s.dissipated += lost;
}

void mark_tied(const System& system, const constraint::Constraints& constraints,
               ContactWorkspace& workspace) {
  workspace.tied.clear();
  workspace.touched.clear();
  if (system.bodies.empty() || constraints.rows.empty()) return;
  workspace.tied.assign(system.nodes, 0.0);
  workspace.touched.assign(system.nodes / math::kRowUnit, 0);
  for (const constraint::HeldRow& row : constraints.rows)
    for (std::size_t n : row.on.node) workspace.tied[n] = 1;
  for (const constraint::RigidLink& link : constraints.rigid.link)
    for (std::size_t n : link.node) workspace.tied[n] = 1;
}

namespace {

// Gives particles that several constraints act on their impulse of the last step.
void warm_start_apply(const State& s, const ContactCoefficients& c, const EdgeField& f) {
  for (const model::BodyContact& body : s.body)
    for (const model::ContactPlace& place : body.blocks.order) {
      const model::ContactBlock& b = body.blocks.pool[place.block];
      if (!b.has_warm_start) continue;
      for (std::size_t i = 0; i < std::size_t(math::kRowUnit); ++i) {
        const std::size_t n = b.node + i;
        const double given = c.kick * (f.inverse_mass_scale ? f.inverse_mass_scale[n] : 1);
        for (std::size_t k = 0; k < 3; ++k) {
          const double dv = b.warm_start[k][i] * given;
          f.v[k][n] += dv;
          if (f.r[k]) f.r[k][n] += dv * c.drift;
        }
      }
    }
}

}  // namespace

void warm_start(const System& system, const ContactWorkspace& workspace, const model::Scheme& scheme,
                State& s) {
  const EdgePass pass{workspace.edge_pairs, coefficients_of(system, s, scheme), field_of(s)};
  warm_start_apply(s, pass.c, pass.field);
  edge_warm_start(system, s, pass);
}

void warm_start_synchronous(const System& system, ContactWorkspace& workspace, const State& s,
                            const SynchronousPass& of) {
  EdgePass pass{workspace.edge_pairs, {}, field_of(of)};
  pass.c.kick = coefficients_of(system, s, of.scheme).kick;
  warm_start_apply(s, pass.c, pass.field);
  workspace.edge_lost = edge_narrow_phase(system, s, workspace.edge_pairs);
  edge_warm_start(system, s, pass);
}

double apply(const System& system, const ContactKernel& kernel, ContactWorkspace& workspace,
             const model::Scheme& scheme, bool on, State& s) {
  const ContactCoefficients c = coefficients_of(system, s, scheme);
  double change = 0;
  std::fill(workspace.touched.begin(), workspace.touched.end(), char(0));
  for (std::size_t b = 0; b < s.body.size(); ++b) {
    model::BodyContact& body = s.body[b];
    if (body.blocks.order.empty()) continue;
    double sum[6]{};
    ContactPass pass = contact_pass_of(system, workspace, s, b, sum, on);
    pass.change = &change;
    const ContactMoves moves{body.blocks.pool.data(), {s.x.data(), s.y.data(), s.z.data()}};
    pass.moves = &moves;
    pass.v[0] = s.vx.data(), pass.v[1] = s.vy.data(), pass.v[2] = s.vz.data();
    if (!s.inverse_mass_scale.empty()) pass.inverse_mass_scale = s.inverse_mass_scale.data();
    pass.c = c;
    pass.reported = last_kick_coefficients(scheme);
    pass.begins = scheme.begins_advance && !workspace.half_kick_reported && scheme.half > 0 && !on;
    kernel.run[system.bodies[b].moves](pass);
    body.impulse.force += load_of(sum).force;
    body.impulse.torque += load_of(sum).torque;
  }
  if (workspace.edge_pairs.empty()) return change;
  for (const EdgeContactPair& t : workspace.edge_pairs)
    for (int k = 0; !workspace.touched.empty() && k < t.element->weights(); ++k)
      workspace.touched[t.element->node[k] / math::kRowUnit] = 1;
  EdgePass pass{workspace.edge_pairs, c, field_of(s), &s};
  pass.on = on;
  change = std::max(change, edge_respond(system, s, pass, workspace.edge_scratch, workspace.edge_sums));
  for (std::size_t b = 0; b < s.body.size(); ++b) {
    s.body[b].impulse.force += workspace.edge_sums.load[b].force;
    s.body[b].impulse.torque += workspace.edge_sums.load[b].torque;
  }
  return change;
}

bool couples(const System& system, const ContactWorkspace& workspace, const State& s) {
  const auto& touched = workspace.touched;  // empty: not known
  if (touched.empty() ? !workspace.tied.empty()
                      : std::find(touched.begin(), touched.end(), char(1)) != touched.end())
    return true;
  if (!system.fit) return false;
  if (!workspace.edge_pairs.empty()) return true;
  for (const model::BodyContact& body : s.body)
    for (const model::ContactPlace& place : body.blocks.order)
      if (body.blocks.pool[place.block].shares) return true;
  return false;
}

double apply_synchronous(const System& system, const ContactKernel& kernel, ContactWorkspace& workspace,
                         const State& s, const SynchronousPass& of, bool on) {
  const bool kicks = of.scheme.pass == model::Pass::kSynchronous;
  const ContactCoefficients c = coefficients_of(system, s, of.scheme);
  double change = 0;
  if (kicks && !on) particle_store_velocities(workspace, s);
  for (std::size_t b = 0; b < s.body.size(); ++b) {
    if (!on) workspace.load[b] = math::Wrench{};
    if (s.body[b].blocks.order.empty()) continue;
    double sum[6]{};
    ContactPass pass = contact_pass_of(system, workspace, s, b, sum, on);
    pass.change = &change;
    pass.v[0] = of.field.x, pass.v[1] = of.field.y, pass.v[2] = of.field.z;
    pass.c = c;
    if (!kicks) {
      if (!s.inverse_mass_scale.empty()) pass.inverse_penalty_scale = s.inverse_mass_scale.data();
      pass.old = nullptr;
      pass.given = nullptr;
    }
    kernel.run[system.bodies[b].moves](pass);
    workspace.load[b].force += load_of(sum).force;
    workspace.load[b].torque += load_of(sum).torque;
  }
  if (workspace.edge_pairs.empty()) return change;
  EdgePass pass{workspace.edge_pairs, c, field_of(of)};
  pass.on = on;
  change = std::max(change, edge_respond(system, s, pass, workspace.edge_scratch, workspace.edge_sums));
  for (std::size_t b = 0; b < s.body.size(); ++b) {
    workspace.load[b].force += workspace.edge_sums.load[b].force;
    workspace.load[b].torque += workspace.edge_sums.load[b].torque;
  }
  return change;
}

// J less its stored part works on v_mid - v_b, all of J on v_b.
ContactWork contact_work(const ContactWorkspace& workspace, const State& s, const double* const v[3]) {
  ContactWork work = edge_work(workspace.edge_pairs, workspace.edge_scratch, v);
  for (std::size_t b = 0; b < s.body.size(); ++b) {
    const std::vector<model::ContactPlace>& order = s.body[b].blocks.order;
    for (std::size_t k = 0; k < order.size(); ++k) {
      const double* given = workspace.given[b].data() + kGivenRows * math::kRowUnit * k;
      const double* old = workspace.old[b].data() + 3 * math::kRowUnit * k;
      for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < std::size_t(math::kRowUnit); ++i) {
          const std::size_t at = c * math::kRowUnit + i, n = std::size_t(order[k].node) * math::kRowUnit + i;
          const double impulse = given[at], stored = given[at + 3 * math::kRowUnit],
                       body_velocity = given[at + 6 * math::kRowUnit];
          work.dissipated += (impulse + stored) * ((old[at] + v[c][n]) / 2 - body_velocity);
          work.input -= impulse * body_velocity;
        }
    }
  }
  return work;
}

bool any_near(const State& s) {
  return std::any_of(s.body.begin(), s.body.end(), [](const model::BodyContact& c) {
    return !c.blocks.order.empty() || !c.edges.pair.empty();
  });
}

double added_omega2(const System& system, const State& s, int lattice) {
  const double omega2 = system.lattices[std::size_t(lattice)].contact_law.omega2;
  return (any_near(s) ? omega2 : 0) + edge_added(system, s) * omega2 + (self_any(s) ? omega2 : 0);
}

}  // namespace drape::contact
