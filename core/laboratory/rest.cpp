#include "laboratory/rest.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "constraint/vector3.h"
#include "laboratory/stiffness.h"
#include "outputs/energy.h"

namespace drape {

struct RestSearch {
  Unknowns unknowns;
  std::vector<SparseRow> rows;   // [held] fixed nodes, then rows, as in HeldMotion
  std::vector<Vec3> multiplier;  // [held] q, N
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor;
  bool ordered = false;
  double way = 0;  // m, the largest of a coordinate in the last step
};

void RestSearchCloser::operator()(RestSearch* search) const { delete search; }

namespace {

using namespace vector3;

constexpr int kStepsMost = 100;
constexpr double kResidualRest = 1e-7;  // of the load
constexpr double kGapRest = 1e-11;      // m
constexpr double kPenalty = 1e3;        // s over the largest entry of K
constexpr double kFarthest = 4;         // cells, the longest way of a particle in one step
constexpr double kArmijo = 1e-4;        // of the promised fall
constexpr int kCutsMost = 20;
constexpr double kRounding = 1e-13;  // of an energy

Vec3 target_at(const HeldMotion& held, std::size_t k) {
  return {held.now[3 * k], held.now[3 * k + 1], held.now[3 * k + 2]};
}

Vec3 place_of(const State& s, std::size_t n) { return {s.x[n], s.y[n], s.z[n]}; }

Vec3 gap_of(const SparseRow& row, const State& s, const Vec3& target) {
  Vec3 gap = -1 * target;
  for (std::size_t k = 0; k < row.node.size(); ++k) gap += row.weight[k] * place_of(s, row.node[k]);
  return gap;
}

// F + m g, in motion.now_x, now_y, now_z.
void forces_take(const System& system, Motion& motion, const State& s) {
  kernel_forces(*motion.kernel, system, s, motion.workspace, motion.now_x.data(), motion.now_y.data(),
                motion.now_z.data());
  Array* f[] = {&motion.now_x, &motion.now_y, &motion.now_z};
  for (std::size_t n : system.particle)
    for (std::size_t k = 0; k < 3; ++k) (*f[k])[n] += system.mass[n] * system.gravity[k];
}

// Pulls of the rows taken from the forces: A^T of what each row carries.
template <class Pull>
void pulls_take(const RestSearch& search, Motion& motion, Pull pull) {
  for (std::size_t r = 0; r < search.rows.size(); ++r) {
    const Vec3 q = pull(r);
    const SparseRow& row = search.rows[r];
    for (std::size_t k = 0; k < row.node.size(); ++k) {
      motion.now_x[row.node[k]] -= row.weight[k] * q[0];
      motion.now_y[row.node[k]] -= row.weight[k] * q[1];
      motion.now_z[row.node[k]] -= row.weight[k] * q[2];
    }
  }
}

std::vector<Vec3> pin_forces(const RestSearch& search, const System& system) {
  std::vector<Vec3> force(system.constraints.pins.size(), Vec3{0, 0, 0});
  std::size_t r = 0;
  const auto add = [&](const Target& t) {
    const Vec3& q = search.multiplier[r++];
    for (int p = t.first; p < t.first + t.count; ++p) {
      const TargetPart& part = system.constraints.parts[std::size_t(p)];
      force[std::size_t(part.pin)] += part.share * q;
    }
  };
  for (const FixedNode& f : system.constraints.fixed) add(f.target);
  for (const HeldRow& row : system.constraints.rows) add(row.target);
  return force;
}

// What is left with the present multipliers, over the load; true where that is rest, or all that rounding of
// the coordinates allows: the last step was below it.
bool rest_judge(const RestSearch& search, const System& system, Motion& motion, const State& s,
                RestFound& found) {
  forces_take(system, motion, s);
  pulls_take(search, motion, [&](std::size_t r) { return search.multiplier[r]; });
  double left = 0, weight = 0, pulled = 0, gap = 0, far = 0;
  for (std::size_t n : system.particle) {
    far = std::max({far, std::abs(s.x[n]), std::abs(s.y[n]), std::abs(s.z[n])});
    left += norm({motion.now_x[n], motion.now_y[n], motion.now_z[n]});
    weight += system.mass[n] * norm(system.gravity);
  }
  for (std::size_t r = 0; r < search.rows.size(); ++r)
    gap = std::max(gap, norm(gap_of(search.rows[r], s, target_at(motion.held, r))));
  found.force = pin_forces(search, system);
  for (const Vec3& f : found.force) pulled += norm(f);
  const double load = std::max(weight, pulled);
  found.residual = load > 0 ? left / load : left;
  const bool rounded = search.way <= std::numeric_limits<double>::epsilon() * far;
  return (found.residual <= kResidualRest || rounded) && gap <= kGapRest;
}

// K + s A^T A, factorised; s in `penalty`. False where it is not positive.
bool factor_take(RestSearch& search, const System& system, const State& s, Stiffness which, double& penalty) {
  Triplets triplets;
  stiffness_add(system, s, which, search.unknowns, triplets);
  double largest = 0;
  for (const auto& t : triplets) largest = std::max(largest, std::abs(t.value()));
  penalty = kPenalty * largest;
  for (const SparseRow& row : search.rows)
    for (std::size_t i = 0; i < row.node.size(); ++i)
      for (std::size_t j = 0; j < row.node.size(); ++j)
        for (int k = 0; k < search.unknowns.dimension; ++k)
          triplets.emplace_back(search.unknowns.first[row.node[i]] + k,
                                search.unknowns.first[row.node[j]] + k,
                                penalty * row.weight[i] * row.weight[j]);
  Eigen::SparseMatrix<double> matrix(search.unknowns.count, search.unknowns.count);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  if (!search.ordered) search.factor.analyzePattern(matrix);
  search.ordered = true;
  search.factor.factorize(matrix);
  return search.factor.info() == Eigen::Success && search.factor.vectorD().minCoeff() > 0;
}

// E - sum m g.r + sum q.(A r - t) + s/2 |A r - t|^2
double merit(const RestSearch& search, const System& system, const HeldMotion& held, const State& s,
             double penalty) {
  double sum = energy_sum(energy_potential(system, s));
  for (std::size_t r = 0; r < search.rows.size(); ++r) {
    const Vec3 gap = gap_of(search.rows[r], s, target_at(held, r));
    sum += dot(search.multiplier[r], gap) + penalty / 2 * dot(gap, gap);
  }
  return sum;
}

void state_move(const RestSearch& search, const System& system, const Eigen::VectorXd& way, double share,
                State& s) {
  Array* r[] = {&s.x, &s.y, &s.z};
  for (std::size_t n : system.particle)
    for (int k = 0; k < search.unknowns.dimension; ++k)
      (*r[k])[n] += share * way[search.unknowns.first[n] + k];
}

// Along `way`, which promises a fall of the merit by `slope` a whole way; false where none is found.
bool way_go(const RestSearch& search, const System& system, const HeldMotion& held,
            const Eigen::VectorXd& way, double slope, double penalty, State& s) {
  double cell = system.lattices[0].cell;
  for (const Lattice& l : system.lattices) cell = std::min(cell, l.cell);
  double share = std::min(1.0, kFarthest * cell / way.lpNorm<Eigen::Infinity>());
  const double before = merit(search, system, held, s, penalty);
  const double rounding = kRounding * std::abs(before);
  state_move(search, system, way, share, s);
  for (int cut = 0; cut < kCutsMost; ++cut, share /= 2) {
    if (merit(search, system, held, s, penalty) <= before - kArmijo * share * slope + rounding) return true;
    state_move(search, system, way, -share / 2, s);
  }
  return false;
}

// One step; false where there is none.
bool step_take(RestSearch& search, const System& system, Motion& motion, State& s) {
  double penalty = 0;
  if (!factor_take(search, system, s, Stiffness::kTangent, penalty) &&
      !factor_take(search, system, s, Stiffness::kBlunt, penalty))
    return false;
  const auto pull = [&](std::size_t r) {
    return search.multiplier[r] + penalty * gap_of(search.rows[r], s, target_at(motion.held, r));
  };
  forces_take(system, motion, s);
  pulls_take(search, motion, pull);
  const Array* f[] = {&motion.now_x, &motion.now_y, &motion.now_z};
  Eigen::VectorXd b(search.unknowns.count);
  for (std::size_t n : system.particle)
    for (int k = 0; k < search.unknowns.dimension; ++k) b[search.unknowns.first[n] + k] = (*f[k])[n];
  const Eigen::VectorXd way = search.factor.solve(b);
  search.way = way.lpNorm<Eigen::Infinity>();
  if (!way_go(search, system, motion.held, way, b.dot(way), penalty, s)) return false;
  for (std::size_t k = 0; k < search.rows.size(); ++k) search.multiplier[k] = pull(k);
  return true;
}

}  // namespace

RestSearchHandle rest_search_make(const System& system, bool flat) {
  RestSearchHandle search(new RestSearch);
  search->unknowns = unknowns_make(system, flat ? 2 : 3);
  for (const FixedNode& f : system.constraints.fixed) search->rows.push_back({{f.node}, {1.0}});
  for (const HeldRow& row : system.constraints.rows) search->rows.push_back(row.on);
  search->multiplier.assign(search->rows.size(), Vec3{0, 0, 0});
  return search;
}

RestFound rest_find(RestSearch& search, const System& system, Motion& motion, State& s) {
  RestFound found;
  held_refresh(system.constraints, s, motion.held);
  search.way = std::numeric_limits<double>::infinity();
  for (found.steps = 0; found.steps < kStepsMost; ++found.steps) {
    if ((found.found = rest_judge(search, system, motion, s, found))) break;
    if (!step_take(search, system, motion, s)) break;
  }
  return found;
}

}  // namespace drape
