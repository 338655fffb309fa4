#include "laboratory/equilibrium.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "laboratory/null_space_basis.h"
#include "math/vector3.h"
#include "outputs/energy.h"

namespace drape::laboratory {

struct EquilibriumSearch {
  std::vector<math::SparseRow> rows;  // [held] fixed nodes, then rows, as in HeldMotion
  NullSpaceBasis basis;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor;
  bool ordered = false;
  double way = 0;  // m, the largest of a coordinate in the last step
};

void EquilibriumSearchCloser::operator()(EquilibriumSearch* search) const { delete search; }

namespace {

using namespace math::vector3;
using Eigen::Index;
using Eigen::VectorXd;

constexpr int kMaxSteps = 300;
constexpr double kResidualRest = 1e-7;  // of the load
constexpr double kMinLoad = 1e-2;       // N, of slack cloth, which carries nothing
constexpr double kFarthest = 4;         // cells, the longest way of a particle in one step
constexpr double kArmijo = 1e-4;        // of the promised fall
constexpr int kMaxCuts = 20;
constexpr double kRounding = 1e-13;  // of an energy
constexpr double kShifts[] = {0, 1e-6, 1e-4, 1e-2};

// Puts the nodes that follow where their rows want them.
void held_place(const EquilibriumSearch& search, const dynamics::HeldMotion& held, State& s) {
  Array* const axes[] = {&s.x, &s.y, &s.z};
  for (std::size_t k = 0; k < 3; ++k) {
    Array& r = *axes[k];
    for (const NullSpaceBlock& block : search.basis.blocks) {
      VectorXd gap(Index(block.row.size()));
      for (std::size_t i = 0; i < block.row.size(); ++i) {
        const math::SparseRow& row = search.rows[block.row[i]];
        double at = 0;
        for (std::size_t j = 0; j < row.node.size(); ++j) at += row.weight[j] * r[row.node[j]];
        gap[Index(i)] = held.now[3 * block.row[i] + k] - at;
      }
      const VectorXd by = block.inverse * gap;
      for (std::size_t i = 0; i < block.following.size(); ++i) r[block.following[i]] += by[Index(i)];
    }
  }
}

// F + m g, in motion.now_x, now_y, now_z.
void forces_collect(const System& system, dynamics::Motion& motion, const State& s) {
  dynamics::kernel_forces(*motion.kernel, system, s, motion.workspace, dynamics::motion_field(motion));
  Array* f[] = {&motion.now_x, &motion.now_y, &motion.now_z};
  for (std::size_t n : system.particle)
    for (std::size_t k = 0; k < 3; ++k) (*f[k])[n] += system.mass[n] * system.gravity[k];
}

VectorXd forces_of(const EquilibriumSearch& search, const System& system, const dynamics::Motion& motion) {
  const Array* f[] = {&motion.now_x, &motion.now_y, &motion.now_z};
  const Unknowns& all = search.basis.all;
  VectorXd b(all.count);
  for (std::size_t n : system.particle)
    for (int k = 0; k < all.dimension; ++k) b[all.first[n] + k] = (*f[k])[n];
  return b;
}

// [held] N, what each row carries: A1^T q = f_1.
std::vector<Vec3> row_forces(const EquilibriumSearch& search, const dynamics::Motion& motion) {
  const Array* f[] = {&motion.now_x, &motion.now_y, &motion.now_z};
  std::vector<Vec3> q(search.rows.size(), Vec3{0, 0, 0});
  for (const NullSpaceBlock& block : search.basis.blocks)
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < block.row.size(); ++i)
        for (std::size_t j = 0; j < block.following.size(); ++j)
          q[block.row[i]][k] += block.inverse(Index(j), Index(i)) * (*f[k])[block.following[j]];
  return q;
}

std::vector<Vec3> pin_forces(const EquilibriumSearch& search, const System& system,
                             const dynamics::Motion& motion) {
  const std::vector<Vec3> q = row_forces(search, motion);
  std::vector<Vec3> force(system.constraints.pins.size(), Vec3{0, 0, 0});
  std::size_t r = 0;
  const auto add = [&](const constraint::Target& t) {
    for (int p = t.first; p < t.first + t.count; ++p) {
      const constraint::TargetPart& part = system.constraints.parts[std::size_t(p)];
      force[std::size_t(part.pin)] += part.share * q[r];
    }
    ++r;
  };
  for (const constraint::FixedNode& f : system.constraints.fixed) add(f.target);
  for (const constraint::HeldRow& row : system.constraints.rows) add(row.target);
  return force;
}

// What is left of the forces, over the load; true where that is rest, or all that rounding of the coordinates
// allows: the last step was below it.
bool equilibrium_check(const EquilibriumSearch& search, const System& system, dynamics::Motion& motion,
                       const State& s, Equilibrium& found) {
  forces_collect(system, motion, s);
  const VectorXd left = search.basis.z.transpose() * forces_of(search, system, motion);
  double sum = 0, weight = 0, pulled = 0, far = 0;
  const int dimension = search.basis.all.dimension;
  for (Index k = 0; k < left.size(); k += dimension) sum += left.segment(k, dimension).norm();
  for (std::size_t n : system.particle) {
    far = std::max({far, std::abs(s.x[n]), std::abs(s.y[n]), std::abs(s.z[n])});
    weight += system.mass[n] * norm(system.gravity);
  }
  found.force = pin_forces(search, system, motion);
  for (const Vec3& f : found.force) pulled += norm(f);
  found.residual = sum / std::max({weight, pulled, kMinLoad});
  const bool rounded = search.way <= std::numeric_limits<double>::epsilon() * far;
  return found.residual <= kResidualRest || rounded;
}

// Z^T (K + shift 1) Z, factorised; the shift over the largest entry of K. False where it is not positive.
bool factor_update(EquilibriumSearch& search, const System& system, const State& s, Stiffness which,
                   double shift) {
  Triplets triplets;
  const NullSpaceBasis& basis = search.basis;
  stiffness_add(system, s, which, basis.all, triplets);
  double largest = 0;
  for (const auto& t : triplets) largest = std::max(largest, std::abs(t.value()));
  for (Index i = 0; shift > 0 && i < basis.all.count; ++i) triplets.emplace_back(i, i, shift * largest);
  Eigen::SparseMatrix<double> k(basis.all.count, basis.all.count);
  k.setFromTriplets(triplets.begin(), triplets.end());
  const Eigen::SparseMatrix<double> matrix = basis.z.transpose() * k * basis.z;
  if (!search.ordered) search.factor.analyzePattern(matrix);
  search.ordered = true;
  search.factor.factorize(matrix);
  return search.factor.info() == Eigen::Success && search.factor.vectorD().minCoeff() > 0;
}

void state_move(const EquilibriumSearch& search, const System& system, const VectorXd& way, double share,
                State& s) {
  Array* const axes[] = {&s.x, &s.y, &s.z};
  const Unknowns& all = search.basis.all;
  for (std::size_t n : system.particle)
    for (int k = 0; k < all.dimension; ++k) (*axes[k])[n] += share * way[all.first[n] + k];
}

// Along `way`, which promises a fall of the energy by `slope` a whole way; false where none is found.
bool travel_step(const EquilibriumSearch& search, const System& system, const VectorXd& way, double slope,
                 State& s) {
  double cell = system.lattices[0].cell;
  for (const model::Lattice& l : system.lattices) cell = std::min(cell, l.cell);
  double share = std::min(1.0, kFarthest * cell / way.lpNorm<Eigen::Infinity>());
  const auto energy = [&] { return outputs::energy_sum(outputs::energy_potential(system, s)); };
  const double before = energy();
  const double rounding = kRounding * std::abs(before);
  state_move(search, system, way, share, s);
  for (int cut = 0; cut < kMaxCuts; ++cut, share /= 2) {
    if (energy() <= before - kArmijo * share * slope + rounding) return true;
    state_move(search, system, way, -share / 2, s);
  }
  return false;
}

// The tangent, or the nearest to it that is positive.
bool positive_factor(EquilibriumSearch& search, const System& system, const State& s) {
  if (factor_update(search, system, s, Stiffness::kTangent, 0)) return true;
  for (double shift : kShifts)
    if (factor_update(search, system, s, Stiffness::kBlunt, shift)) return true;
  return false;
}

// One step; false where there is none.
bool step_apply(EquilibriumSearch& search, const System& system, dynamics::Motion& motion, State& s) {
  if (!positive_factor(search, system, s)) return false;
  const VectorXd b = search.basis.z.transpose() * forces_of(search, system, motion);
  const VectorXd free = search.factor.solve(b), way = search.basis.z * free;
  search.way = way.lpNorm<Eigen::Infinity>();
  if (!travel_step(search, system, way, b.dot(free), s)) return false;
  held_place(search, motion.held, s);
  return true;
}

}  // namespace

EquilibriumSearchHandle equilibrium_search_make(const System& system, bool flat) {
  EquilibriumSearchHandle search(new EquilibriumSearch);
  for (const constraint::FixedNode& f : system.constraints.fixed) search->rows.push_back({{f.node}, {1.0}});
  for (const constraint::HeldRow& row : system.constraints.rows) search->rows.push_back(row.on);
  search->basis = null_space_basis_make(system, search->rows, flat ? 2 : 3);
  return search;
}

Equilibrium equilibrium_find(EquilibriumSearch& search, const System& system, dynamics::Motion& motion,
                             State& s) {
  Equilibrium found;
  dynamics::held_refresh(system.constraints, s, motion.held);
  held_place(search, motion.held, s);
  search.way = std::numeric_limits<double>::infinity();
  for (found.steps = 0; found.steps < kMaxSteps; ++found.steps) {
    if ((found.found = equilibrium_check(search, system, motion, s, found))) break;
    if (!step_apply(search, system, motion, s)) break;
  }
  return found;
}

}  // namespace drape::laboratory
