#include "contact/self/self_contact.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "contact/self/closest_lanes.h"
#include "contact/self/search.h"
#include "math/smooth_ramp.h"
#include "math/vector3.h"
#include "scene/diagnostics.h"
#include "simd/lane_scalar.h"

namespace drape::contact {
namespace {

using namespace math::vector3;

constexpr double kReachSteps = 2;    // steps at the present speed before contact: pairs are examined
constexpr double kSearchSteps = 48;  // steps at the present speed that a search is to last
constexpr double kMinMargin = 0.25, kMaxMargin = 0.5;  // cells, of a search
constexpr double kMarginReach = 4;                     // minimum of the margin, in reaches
// Sweeps end when velocities change by less than this share of the first change: of a step, of accelerations.
constexpr double kConverged = 1e-3, kConvergedRest = 1e-9;
constexpr int kSweeps = 100, kSweepsRest = 1000;  // maxima

// The least and the largest of a component of the velocity.
struct Range {
  double low = INFINITY, high = -INFINITY;
  void include(const Range& r) { low = std::min(low, r.low), high = std::max(high, r.high); }
};

// In lanes that the compiler vectorizes.
Range range_of(const double* at, const double* end) {
  double low[math::kRowUnit], high[math::kRowUnit];
  std::fill_n(low, math::kRowUnit, INFINITY);
  std::fill_n(high, math::kRowUnit, -INFINITY);
  const auto include = [&](double v, int i) {
    low[i] = v < low[i] ? v : low[i];
    high[i] = v > high[i] ? v : high[i];
  };
  for (; at + math::kRowUnit <= end; at += math::kRowUnit)
    for (int i = 0; i < math::kRowUnit; ++i) include(at[i], i);
  for (; at < end; ++at) include(*at, 0);
  return {*std::min_element(low, low + math::kRowUnit), *std::max_element(high, high + math::kRowUnit)};
}

double diagonal(const std::array<Range, 3>& box) {
  return norm(Vec3{box[0].high - box[0].low, box[1].high - box[1].low, box[2].high - box[2].low});
}

// Upper bounds (m/s) of the relative speed of any two particles, and of any two of one piece: the diagonals
// of the boxes of their velocities.
struct Speeds {
  double all, piece;
};
Speeds speeds_of(const System& system, const State& s) {
  const Array* const v[3] = {&s.vx, &s.vy, &s.vz};
  const std::vector<model::NodeSpan>& spans = system.self.span;
  std::array<Range, 3> all;
  double piece = 0;
  for (std::size_t at = 0; at < spans.size();) {
    const int lattice = system.self.lattice_of[spans[at].begin];
    std::array<Range, 3> box;
    for (; at < spans.size() && system.self.lattice_of[spans[at].begin] == lattice; ++at)
      for (std::size_t k = 0; k < 3; ++k)
        box[k].include(range_of(v[k]->data() + spans[at].begin, v[k]->data() + spans[at].end));
    piece = std::max(piece, diagonal(box));
    for (std::size_t k = 0; k < 3; ++k) all[k].include(box[k]);
  }
  return {diagonal(all), piece};
}

double reach_of(const System& system, const State& s, double h) {
  return kReachSteps * s.self.speed * h + self_still_reach(system);
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
  self.level_until.assign(system.self.edge.size(), INFINITY);
}

// Computes the impulses of all pairs. Sweeps over them until the velocities of the gaps change by less than
// `tolerance` of the first change, at most `sweeps` times.
void respond(const SelfContactKernel& kernel, const SelfContactPass& pass, double tolerance, int sweeps) {
  double first = kernel.begin(pass);
  for (int k = 0; k < sweeps; ++k) {
    const double largest = kernel.sweep(pass);
    if (k == 0) first = std::max(first, largest);
    if (!(largest > tolerance * first)) break;
  }
}

Vec3 lane3(const SelfGroup::Lanes (&of)[3], std::size_t lane) {
  return {of[0][lane], of[1][lane], of[2][lane]};
}

void holds_set(double kick, const std::vector<SelfContactPair>& pairs, const SelfGroups& all,
               model::SelfState& self) {
  self.hold.clear();
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const SelfGroup& g = all.group[all.slot[p] / kGroupPairs];
    const std::size_t lane = all.slot[p] % kGroupPairs;
    if (g.normal[lane] + g.stop[lane] > 0)
      self.hold.push_back(
          {pairs[p].node, pairs[p].cross, g.slides[lane] == 0, (1 / kick) * lane3(g.friction, lane)});
  }
}

// Gives fixed nodes the velocities of a field and what the pairs add to them: their pins report it.
void fixed_nodes_push(const SelfContactKernel& kernel, const SelfContactPass& pass,
                      const double* const field[3], SelfNodes& nodes) {
  if (std::none_of(nodes.fixed.begin(), nodes.fixed.end(), [](char is) { return is; })) return;
  for (std::size_t k = 0; k < nodes.node.size(); ++k)
    if (nodes.fixed[k]) row_set(nodes.v, k, field, nodes.node[k]);
  kernel.push_fixed(pass);
}

// Sets the free velocities of the nodes from a field. Those of fixed nodes are the old ones, or 0.
void velocities_set(const double* const field[3], bool fixed_keep, SelfNodes& nodes) {
  for (std::size_t k = 0; k < nodes.node.size(); ++k)
    if (!nodes.fixed[k]) row_set(nodes.v, k, field, nodes.node[k]);
    else
      for (std::size_t c = 4 * k; c < 4 * k + 3; ++c) nodes.v[c] = fixed_keep ? nodes.old[c] : 0;
}

}  // namespace

void self_begin(const System& system, State& s) {
  if (!self_enabled(system)) return;
  s.self = model::SelfState{};
  s.self.speed = speeds_of(system, s).all;
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
  s.self.speed = std::max(s.self.speed, speeds_of(system, s).all);
  s.self.travel += 2 * moved;
  s.self.shape_travel += 2 * moved;
}

void self_store_velocities(const System& system, const SelfContactKernel& kernel,
                           SelfContactWorkspace& workspace, State& s, double h) {
  const double reach = reach_of(system, s, h);
  if (s.self.travel + reach > s.self.searched + s.self.margin) search(system, s, h);
  self_narrow_phase(system, s, reach, kernel.points, workspace.touches, &s.self);
  self_group(system, s, true, workspace.touches.pair, workspace.groups);
}

void self_apply(const System& system, const SelfContactKernel& kernel, SelfContactWorkspace& workspace,
                const model::Scheme& scheme, State& s) {
  if (workspace.touches.pair.empty()) {
    s.self.hold.clear();
    return;
  }
  SelfGroups& all = workspace.groups;
  double* const v[3] = {s.vx.data(), s.vy.data(), s.vz.data()};
  workspace.c = coefficients_of(system, s, scheme);
  velocities_set(v, true, all.node);
  const SelfContactPass pass = self_pass(workspace.c, all);
  respond(kernel, pass, kConverged, kSweeps);
  fixed_nodes_push(kernel, pass, v, all.node);
  double* const x[3] = {s.x.data(), s.y.data(), s.z.data()};
  for (std::size_t k = 0; k < all.node.node.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c) {
      double& velocity = v[c][all.node.node[k]];
      x[c][all.node.node[k]] += scheme.drift * (all.node.v[4 * k + c] - velocity);
      velocity = all.node.v[4 * k + c];
    }
  holds_set(workspace.c.kick, workspace.touches.pair, all, s.self);
}

double self_parting_work(const System& system, const SelfContactWorkspace& workspace, const State& s,
                         double h) {
  if (s.self.age - h / 2 >= kParting) return 0;
  double sum = 0;
  for (const SelfContactPair& t : workspace.touches.pair)
    sum += t.share * self_pair_law(system, t).stiffness *
           (penalty_integral(t, s.self.age + h / 2) - penalty_integral(t, s.self.age - h / 2));
  return sum;
}

double self_work(const SelfContactKernel& kernel, SelfContactWorkspace& workspace, const double* const v[3]) {
  if (workspace.touches.pair.empty()) return 0;
  SelfNodes& nodes = workspace.groups.node;
  for (std::size_t k = 0; k < nodes.node.size(); ++k) row_set(nodes.v, k, v, nodes.node[k]);
  return workspace.c.impulse * kernel.dissipated(self_pass(workspace.c, workspace.groups));
}

void self_update_proximity(const System& system, State& s, double drift) {
  const Speeds speeds = speeds_of(system, s);
  s.self.speed = speeds.all;
  s.self.travel += s.self.speed * std::abs(drift);
  s.self.shape_travel += speeds.piece * std::abs(drift);
  if (s.self.age < 2 * kParting) s.self.age += drift;
}

void self_synchronous(const System& system, const SelfContactKernel& kernel, SelfContactWorkspace& workspace,
                      const State& s, const SynchronousPass& pass) {
  self_narrow_phase(system, s, 0, kernel.points, workspace.touches, nullptr);
  if (workspace.touches.pair.empty()) return;
  SelfGroups& all = workspace.groups;
  self_group(system, s, false, workspace.touches.pair, all);
  workspace.c = coefficients_of(system, s, pass.scheme);
  const bool kicks = pass.scheme.pass == model::Pass::kSynchronous;
  double* const field[3] = {pass.field.x, pass.field.y, pass.field.z};
  velocities_set(field, kicks, all.node);
  const SelfContactPass groups = self_pass(workspace.c, all);
  respond(kernel, groups, kicks ? kConverged : kConvergedRest, kicks ? kSweeps : kSweepsRest);
  fixed_nodes_push(kernel, groups, field, all.node);
  for (std::size_t k = 0; k < all.node.node.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c) field[c][all.node.node[k]] = all.node.v[4 * k + c];
}

namespace {

// Whether pins hold all that has weight in a pair.
bool pins_hold(const System& system, const SelfContactPair& t) {
  for (std::size_t k = 0; k < 4; ++k)
    if (t.weight[k] != 0 && !system.self.fixed[t.node[k]]) return false;
  return true;
}

std::vector<SelfContactPair> touching(const System& system, const State& s) {
  SelfContactPairs all;
  if (!self_any(s)) return {};
  self_narrow_phase(system, s, 0, self_points_lanes<simd::ScalarLane<false>>, all, nullptr);
  std::erase_if(all.pair, [&](const SelfContactPair& t) { return pins_hold(system, t); });
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
    sum.pressure =
        std::max(sum.pressure, t.share * self_pair_law(system, t).stiffness *
                                   math::smooth_ramp(kSelfBlend * t.contact_distance, depth) / area);
  }
  return sum;
}

double self_energy(const System& system, const State& s) {
  double sum = 0;
  for (const SelfContactPair& t : touching(system, s))
    sum += t.share * self_pair_law(system, t).stiffness * penalty_integral(t, s.self.age);
  return sum;
}

}  // namespace drape::contact
