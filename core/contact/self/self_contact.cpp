#include "contact/self/self_contact.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "contact/self/search.h"
#include "math/smooth_ramp.h"
#include "math/vector3.h"
#include "scene/diagnostics.h"

namespace drape::contact {
namespace {

using namespace math::vector3;

constexpr double kReachSteps = 2;       // steps at the present speed before contact: pairs are examined
constexpr double kReachDistance = 0.1;  // of the contact distance, added to that
constexpr double kSearchSteps = 48;     // steps at the present speed that a search is to last
constexpr double kMinMargin = 0.25, kMaxMargin = 0.5;  // cells, of a search
constexpr double kMarginReach = 4;                     // minimum of the margin, in reaches
// Sweeps end when velocities change by less than this share of the first change: of a step, of accelerations.
constexpr double kConverged = 1e-3, kConvergedRest = 1e-9;
constexpr int kSweeps = 10, kSweepsRest = 1000;  // maxima

// An upper bound (m/s) of the relative speed of any two particles: the diagonal of the box of all velocities.
double speed_of(const System& system, const State& s) {
  Vec3 range;
  const Array* v[3] = {&s.vx, &s.vy, &s.vz};
  for (std::size_t k = 0; k < 3; ++k) {
    double low[math::kRowUnit], high[math::kRowUnit];  // lanes that the compiler vectorizes
    std::fill_n(low, math::kRowUnit, INFINITY);
    std::fill_n(high, math::kRowUnit, -INFINITY);
    const auto include = [&](double at, int i) {
      low[i] = at < low[i] ? at : low[i];
      high[i] = at > high[i] ? at : high[i];
    };
    for (const model::NodeSpan& span : system.self.span) {
      const double *at = v[k]->data() + span.begin, *end = v[k]->data() + span.end;
      for (; at + math::kRowUnit <= end; at += math::kRowUnit)
        for (int i = 0; i < math::kRowUnit; ++i) include(at[i], i);
      for (; at < end; ++at) include(*at, 0);
    }
    range[k] = *std::max_element(high, high + math::kRowUnit) - *std::min_element(low, low + math::kRowUnit);
  }
  return norm(range);
}

double reach_of(const System& system, const State& s, double h) {
  return kReachSteps * s.self.speed * h + kReachDistance * system.self.contact_distance;
}

void search(const System& system, State& s, double h) {
  const double cell = system.self.min_cell;
  model::SelfState& self = s.self;
  self.margin = std::max(kMarginReach * reach_of(system, s, h),
                         std::clamp(kSearchSteps * self.speed * h, kMinMargin * cell, kMaxMargin * cell));
  self.searched = self.travel;
  self.pairs = std::make_shared<const model::SelfPairs>(self_search(system, system.self, s, self.margin));
  self.active_after_travel.assign(self.pairs->size(), self.travel);
  self.block_active_after_travel.assign(
      (self.pairs->size() + model::kPairsPerBlock - 1) / model::kPairsPerBlock, self.travel);
}

void holds_set(const ContactCoefficients& c, const SelfContactPairs& all, model::SelfState& self) {
  self.hold.clear();
  for (const SelfContactPair& t : all.pair)
    if (t.normal + t.stop > 0) self.hold.push_back({t.node, t.cross, !t.slides, (1 / c.kick) * t.friction});
}

}  // namespace

void self_begin(const System& system, State& s) {
  if (!self_enabled(system)) return;
  s.self = model::SelfState{};
  s.self.speed = speed_of(system, s);
  search(system, s, model::step_next(system, s));
}

namespace {

// The energy of the penalty of a pair over its stiffness (m^2), at an age of the state.
double penalty_integral(const SelfContactPair& t, double age) {
  const double contact_distance = self_contact_distance_at(t.start, t.final_distance, age);
  return math::smooth_ramp_integral(kSelfBlend * contact_distance, contact_distance - t.distance);
}

// Cloth in the very place of other cloth has no side on which it could part from it.
void same_place_check(const System& system, const Scene& scene, const State& s,
                      std::vector<Problem>& problems) {
  std::map<int, std::vector<model::NodeIndex>> found;
  for (model::NodeIndex n : system.self.same_place) found[system.self.lattice_of[n]].push_back(n);
  for (const auto& [piece, nodes] : found) {
    if (piece == system.self.lattice_of[system.self.same_place[0]] && found.size() > 1) continue;
    const std::size_t n = nodes[0];
    problems.push_back({"piece." + scene.pieces[std::size_t(piece)].name + ".place",
                        "puts it into other cloth with self_contact = true: " + std::to_string(nodes.size()) +
                            " of its particles lie in cells of it, the first at (" +
                            scene::number_text(s.x[n]) + ", " + scene::number_text(s.y[n]) + ", " +
                            scene::number_text(s.z[n]) +
                            "); allowed: layers apart by at least a thousandth of their thickness"});
  }
}

}  // namespace

void self_check_start(const System& system, const Scene& scene, const State& s,
                      std::vector<Problem>& problems) {
  same_place_check(system, scene, s, problems);
  std::map<std::array<int, 2>, std::vector<Vec3>> found;
  for (const SelfCut& cut : self_cuts(system.self, s))
    found[{std::min(cut.lattice[0], cut.lattice[1]), std::max(cut.lattice[0], cut.lattice[1])}].push_back(
        cut.at);
  for (const auto& [pieces, cuts] : found) {
    const auto name = [&](std::size_t k) { return scene.pieces[std::size_t(pieces[k])].name; };
    const Vec3& at = cuts[0];
    problems.push_back(
        {"piece." + name(1) + ".place",
         "puts it through " + (pieces[0] == pieces[1] ? "itself" : "the piece " + scene::in_quotes(name(0))) +
             " with self_contact = true: " + std::to_string(cuts.size()) +
             " edges of cells go through cells, the first near (" + scene::number_text(at[0]) + ", " +
             scene::number_text(at[1]) + ", " + scene::number_text(at[2]) + "); wanted: none"});
  }
}

void self_invalidate_proximity(const System& system, State& s, double moved) {
  if (!self_enabled(system)) return;
  s.self.speed = std::max(s.self.speed, speed_of(system, s));
  s.self.travel += 2 * moved;
}

void self_store_velocities(const System& system, SelfContactWorkspace& workspace, State& s, double h) {
  const double reach = reach_of(system, s, h);
  if (s.self.travel + reach > s.self.searched + s.self.margin) search(system, s, h);
  self_narrow_phase(system, s, reach, workspace.touches, &s.self);
  self_prepare(system, s, true, workspace.touches);
}

void self_apply(const System& system, SelfContactWorkspace& workspace, const model::Scheme& scheme,
                State& s) {
  SelfContactPairs& all = workspace.touches;
  if (all.pair.empty()) {
    s.self.hold.clear();
    return;
  }
  const ContactCoefficients c = coefficients_of(system, s, scheme);
  for (SelfNode& n : all.node) n.v = n.fixed ? n.old : Vec3{s.vx[n.node], s.vy[n.node], s.vz[n.node]};
  self_respond(c, kConverged, kSweeps, all);
  for (const SelfNode& n : all.node) {
    const double over = n.fixed ? 1 / n.mass : n.inverse;  // the pin of a fixed node reports it
    const Vec3 dv = over * n.impulse;
    s.vx[n.node] += dv[0], s.vy[n.node] += dv[1], s.vz[n.node] += dv[2];
    s.x[n.node] += scheme.drift * dv[0], s.y[n.node] += scheme.drift * dv[1],
        s.z[n.node] += scheme.drift * dv[2];
  }
  workspace.factor = c.impulse;
  holds_set(c, all, s.self);
}

double self_parting_work(const SelfContactWorkspace& workspace, const State& s, double h) {
  if (s.self.age - h / 2 >= kParting) return 0;
  double sum = 0;
  for (const SelfContactPair& t : workspace.touches.pair)
    sum += t.stiffness * (penalty_integral(t, s.self.age + h / 2) - penalty_integral(t, s.self.age - h / 2));
  return sum;
}

double self_work(SelfContactWorkspace& workspace, const double* const v[3]) {
  for (SelfNode& n : workspace.touches.node) n.v = {v[0][n.node], v[1][n.node], v[2][n.node]};
  return workspace.factor * self_dissipated(workspace.touches);
}

void self_update_proximity(const System& system, State& s, double drift) {
  s.self.speed = speed_of(system, s);
  s.self.travel += s.self.speed * std::abs(drift);
  if (s.self.age < 2 * kParting) s.self.age += drift;
}

void self_synchronous(const System& system, SelfContactWorkspace& workspace, const State& s,
                      const SynchronousPass& pass) {
  const model::Field& field = pass.field;
  SelfContactPairs& all = workspace.touches;
  self_narrow_phase(system, s, 0, all, nullptr);
  self_prepare(system, s, false, all);
  const ContactCoefficients c = coefficients_of(system, s, pass.scheme);
  const bool kicks = pass.scheme.pass == model::Pass::kSynchronous;
  for (SelfNode& n : all.node) {
    n.v = {field.x[n.node], field.y[n.node], field.z[n.node]};
    if (n.fixed) n.v = kicks ? n.old : Vec3{0, 0, 0};
  }
  self_respond(c, kicks ? kConverged : kConvergedRest, kicks ? kSweeps : kSweepsRest, all);
  for (const SelfNode& n : all.node) {
    const Vec3 dv = (n.fixed ? 1 / n.mass : n.inverse) * n.impulse;
    field.x[n.node] += dv[0], field.y[n.node] += dv[1], field.z[n.node] += dv[2];
  }
  workspace.factor = c.impulse;
}

namespace {

std::vector<SelfContactPair> touching(const System& system, const State& s) {
  SelfContactPairs all;
  if (!self_any(s)) return {};
  self_narrow_phase(system, s, 0, all, nullptr);
  self_prepare(system, s, false, all);
  return all.pair;
}

}  // namespace

model::ContactSummary self_summary(const System& system, const State& s) {
  model::ContactSummary sum;
  for (const SelfContactPair& t : touching(system, s)) {
    const double depth = t.contact_distance - t.distance;
    double area = INFINITY;
    for (model::NodeIndex n : t.node) area = std::min(area, system.area[n]);
    ++sum.count;
    sum.penetration = std::max(sum.penetration, depth);
    sum.pressure = std::max(sum.pressure,
                            t.stiffness * math::smooth_ramp(kSelfBlend * t.contact_distance, depth) / area);
  }
  return sum;
}

double self_energy(const System& system, const State& s) {
  double sum = 0;
  for (const SelfContactPair& t : touching(system, s)) sum += t.stiffness * penalty_integral(t, s.self.age);
  return sum;
}

}  // namespace drape::contact
