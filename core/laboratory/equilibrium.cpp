#include "laboratory/equilibrium.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/potential_energy.h"
#include "laboratory/null_space_basis.h"
#include "math/vector3.h"

namespace drape::laboratory {

struct EquilibriumSearch {
  std::vector<math::SparseRow> rows;  // [held] fixed nodes, then rows, in the order of HeldMotion
  NullSpaceBasis basis;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor;
  bool ordered = false;
  double last_step = 0;  // m, largest displacement of a coordinate in the last step
};

void EquilibriumSearchCloser::operator()(EquilibriumSearch* search) const { delete search; }

namespace {

using namespace math::vector3;
using Eigen::Index;
using Eigen::VectorXd;

constexpr int kMaxSteps = 300;
constexpr double kResidualRest = 1e-7;  // relative to the load
constexpr double kMinLoad = 1e-2;       // N, for slack cloth, which carries no load
constexpr double kMaxTravel = 4;        // cells, largest displacement in one step
constexpr double kArmijo = 1e-4;        // relative to the predicted decrease of energy
constexpr int kMaxCuts = 20;
constexpr double kRounding = 1e-13;  // relative to the energy
constexpr double kShifts[] = {0, 1e-6, 1e-4, 1e-2};

// Moves the following nodes so that all rows are satisfied.
void rows_satisfy(const EquilibriumSearch& search, const dynamics::HeldMotion& held, State& s) {
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

// [held] N, the force on each row: A1^T q = f_1.
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

// Sets the residual. True where it is small enough, or where the last step was below the rounding of the
// coordinates.
bool equilibrium_check(const EquilibriumSearch& search, const System& system, dynamics::Motion& motion,
                       const State& s, Equilibrium& found) {
  forces_collect(system, motion, s);
  const VectorXd unbalanced = search.basis.z.transpose() * forces_of(search, system, motion);
  double sum = 0, weight = 0, pulled = 0, far = 0;
  const int dimension = search.basis.all.dimension;
  for (Index k = 0; k < unbalanced.size(); k += dimension) sum += unbalanced.segment(k, dimension).norm();
  for (std::size_t n : system.particle) {
    far = std::max({far, std::abs(s.x[n]), std::abs(s.y[n]), std::abs(s.z[n])});
    weight += system.mass[n] * norm(system.gravity);
  }
  found.force = pin_forces(search, system, motion);
  for (const Vec3& f : found.force) pulled += norm(f);
  found.residual = sum / std::max({weight, pulled, kMinLoad});
  const bool rounded = search.last_step <= std::numeric_limits<double>::epsilon() * far;
  return found.residual <= kResidualRest || rounded;
}

// Factorises Z^T (K + shift 1) Z, with the shift relative to the largest entry of K. False where the matrix
// is not positive definite.
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

void state_move(const EquilibriumSearch& search, const System& system, const VectorXd& direction,
                double share, State& s) {
  Array* const axes[] = {&s.x, &s.y, &s.z};
  const Unknowns& all = search.basis.all;
  for (std::size_t n : system.particle)
    for (int k = 0; k < all.dimension; ++k) (*axes[k])[n] += share * direction[all.first[n] + k];
}

// Line search along `direction`, for which a full step is predicted to lower the energy by `slope`, J. False
// where no step lowers it.
bool line_search(const EquilibriumSearch& search, const System& system, const VectorXd& direction,
                 double slope, State& s) {
  double cell = system.lattices[0].cell;
  for (const model::Lattice& l : system.lattices) cell = std::min(cell, l.cell);
  double share = std::min(1.0, kMaxTravel * cell / direction.lpNorm<Eigen::Infinity>());
  const auto energy = [&] { return dynamics::energy_sum(dynamics::potential_energy(system, s)); };
  const double before = energy();
  const double rounding = kRounding * std::abs(before);
  state_move(search, system, direction, share, s);
  for (int cut = 0; cut < kMaxCuts; ++cut, share /= 2) {
    if (energy() <= before - kArmijo * share * slope + rounding) return true;
    state_move(search, system, direction, -share / 2, s);
  }
  return false;
}

// Factorises the tangent, or the first of its modifications that is positive definite.
bool positive_factor(EquilibriumSearch& search, const System& system, const State& s) {
  if (factor_update(search, system, s, Stiffness::kTangent, 0)) return true;
  for (double shift : kShifts)
    if (factor_update(search, system, s, Stiffness::kNonNegative, shift)) return true;
  return false;
}

// One Newton step. False where none lowers the energy.
bool step_apply(EquilibriumSearch& search, const System& system, dynamics::Motion& motion, State& s) {
  if (!positive_factor(search, system, s)) return false;
  const VectorXd b = search.basis.z.transpose() * forces_of(search, system, motion);
  const VectorXd free = search.factor.solve(b), direction = search.basis.z * free;
  search.last_step = direction.lpNorm<Eigen::Infinity>();
  if (!line_search(search, system, direction, b.dot(free), s)) return false;
  rows_satisfy(search, motion.held, s);
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
  rows_satisfy(search, motion.held, s);
  search.last_step = std::numeric_limits<double>::infinity();
  for (found.steps = 0; found.steps < kMaxSteps; ++found.steps) {
    found.found = equilibrium_check(search, system, motion, s, found);
    if (found.found) break;
    if (!step_apply(search, system, motion, s)) break;
  }
  return found;
}

}  // namespace drape::laboratory
