#include "constraint/rigid_links.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>

#include "constraint/linear_constraints.h"

namespace drape::constraint {
namespace {

constexpr double kSoft = 0.01;  // e of rigid_links.h

// Fills in the entries of all scalar rows.
void entries_fill(const std::vector<HeldRow>& rows, const std::vector<FixedNode>& fixed, Rigid& rigid) {
  std::set<std::size_t> held;
  for (const FixedNode& f : fixed) held.insert(f.node);
  const auto add = [&](std::size_t node, int axis, double weight) {
    rigid.node.push_back(node);
    rigid.fixed.push_back(held.contains(node));
    rigid.axis.push_back(axis);
    rigid.weight.push_back(weight);
  };
  rigid.begin.push_back(0);
  for (const HeldRow& row : rows)
    for (int axis = 0; axis < 3; ++axis) {
      for (std::size_t k = 0; k < row.on.node.size(); ++k) add(row.on.node[k], axis, row.on.weight[k]);
      rigid.begin.push_back(rigid.node.size());
    }
  rigid.held = rigid.begin.size() - 1;
  for (const RigidLink& link : rigid.link) {
    for (std::size_t node : link.node)
      for (int axis = 0; axis < 3; ++axis) add(node, axis, 0);
    rigid.begin.push_back(rigid.node.size());
  }
}

// Scalar rows in order of elimination. A linear row is eliminated just before the first link that shares a
// node with it.
std::vector<std::size_t> elimination_order(const Rigid& rigid) {
  std::unordered_map<std::size_t, int> first;  // node -> lowest order of its links
  for (const RigidLink& link : rigid.link)
    for (std::size_t node : link.node) {
      const auto [at, made] = first.emplace(node, link.order);
      at->second = std::min(at->second, link.order);
    }
  std::vector<std::pair<int, std::size_t>> keyed;
  for (std::size_t r = 0; r + 1 < rigid.begin.size(); ++r) {
    int key = r < rigid.held ? 0 : 2 * rigid.link[r - rigid.held].order + 1;
    for (std::size_t e = rigid.begin[r]; r < rigid.held && e < rigid.begin[r + 1]; ++e)
      if (const auto found = first.find(rigid.node[e]); found != first.end())
        key = std::max(key, 2 * found->second);
    keyed.push_back({key, r});
  }
  std::sort(keyed.begin(), keyed.end());
  std::vector<std::size_t> order;
  for (const auto& [key, r] : keyed) order.push_back(r);
  return order;
}

// Pairs of columns that share a node along an axis, with the pairs of entries that they share.
using Shared =
    std::map<std::pair<std::size_t, std::size_t>, std::vector<std::pair<std::size_t, std::size_t>>>;
Shared shared_of(const Rigid& rigid) {
  std::map<std::pair<std::size_t, int>, std::vector<std::pair<std::size_t, std::size_t>>> on;
  for (std::size_t r = 0; r + 1 < rigid.begin.size(); ++r)
    for (std::size_t e = rigid.begin[r]; e < rigid.begin[r + 1]; ++e)
      if (!rigid.fixed[e]) on[{rigid.node[e], rigid.axis[e]}].push_back({rigid.column[r], e});
  Shared shared;
  for (const auto& [place, entries] : on)
    for (const auto& [i, left] : entries)
      for (const auto& [j, right] : entries)
        if (i <= j) shared[{i, j}].push_back({left, right});
  return shared;
}

// The sparsity pattern of the factor: the entries of the matrix and the fill-in of the elimination.
void shape_make(const std::vector<std::size_t>& order, Rigid& rigid) {
  const Shared shared = shared_of(rigid);
  const std::size_t rank = order.size();
  std::vector<std::set<std::size_t>> below(rank);
  for (const auto& [place, terms] : shared)
    if (place.first != place.second) below[place.first].insert(place.second);
  math::CholeskyFactor& f = rigid.shape;
  f.begin.push_back(0);
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> slot;
  for (std::size_t k = 0; k < rank; ++k) {
    f.row.push_back(int(order[k]));
    for (std::size_t i : below[k]) {
      slot[{k, i}] = rank + f.entry_row.size();
      f.entry_row.push_back(int(order[i]));
    }
    f.begin.push_back(f.entry_row.size());
    if (below[k].empty()) continue;
    std::set<std::size_t> rest(std::next(below[k].begin()), below[k].end());
    below[*below[k].begin()].merge(rest);  // its parent in the elimination tree
  }
  for (std::size_t k = 0; k < rank; ++k)
    for (auto a = below[k].begin(); a != below[k].end(); ++a)
      for (auto b = a; b != below[k].end(); ++b) rigid.update.push_back(a == b ? *a : slot.at({*a, *b}));
  for (const auto& [place, terms] : shared)
    for (const auto& [left, right] : terms)
      rigid.terms.push_back({place.first == place.second ? place.first : slot.at(place), left, right});
}

}  // namespace

Rigid rigid_make(const std::vector<HeldRow>& rows, const std::vector<FixedNode>& fixed,
                 const std::vector<RigidLink>& links) {
  Rigid rigid;
  rigid.link = links;
  if (links.empty()) return rigid;
  entries_fill(rows, fixed, rigid);
  const std::vector<std::size_t> order = elimination_order(rigid);
  rigid.column.resize(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) rigid.column[order[k]] = k;
  shape_make(order, rigid);
  return rigid;
}

RigidNow rigid_now(const Rigid& rigid) {
  RigidNow now;
  now.weight = rigid.weight;
  now.factor = rigid.shape;
  now.factor.inverse.resize(rigid.shape.row.size());
  now.factor.entry.resize(rigid.shape.entry_row.size());
  now.slot.resize(rigid.shape.row.size() + rigid.shape.entry_row.size());
  now.rate.assign(rigid.link.size(), 0.0);
  now.y.assign(rigid.shape.row.size(), 0.0);
  now.b = now.y;
  return now;
}

void rigid_aim(const Rigid& rigid, const double* x, const double* y, const double* z, RigidNow& now) {
  const double* r[] = {x, y, z};
  for (std::size_t k = 0; k < rigid.link.size(); ++k) {
    const RigidLink& link = rigid.link[k];
    double* weight = &now.weight[rigid.begin[rigid.held + k]];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      weight[3 + axis] = (r[axis][link.node[1]] - r[axis][link.node[0]]) / link.length;
      weight[axis] = -weight[3 + axis];
    }
  }
  now.ready = false;
}

// Right-looking Cholesky factorisation on the fixed sparsity pattern.
void rigid_factor(const Rigid& rigid, const Array& inverse_mass, RigidNow& now) {
  if (now.ready) return;
  now.ready = true;
  std::fill(now.slot.begin(), now.slot.end(), 0.0);
  for (const Rigid::Term& t : rigid.terms)
    now.slot[t.slot] += now.weight[t.left] * now.weight[t.right] * inverse_mass[rigid.node[t.left]];
  math::CholeskyFactor& f = now.factor;
  const std::size_t rank = f.row.size();
  for (std::size_t k = 0; k < rank; ++k)
    if (std::size_t(f.row[k]) >= rigid.held) now.slot[k] *= 1 + kSoft;
  const std::size_t* update = rigid.update.data();
  for (std::size_t k = 0; k < rank; ++k) {
    const double inverse = now.slot[k] > 0 ? 1 / std::sqrt(now.slot[k]) : 0;
    f.inverse[k] = inverse;
    const std::size_t end = f.begin[k + 1];
    for (std::size_t e = f.begin[k]; e < end; ++e) f.entry[e] = now.slot[rank + e] * inverse;
    for (std::size_t a = f.begin[k]; a < end; ++a)
      for (std::size_t b = a; b < end; ++b) now.slot[*update++] -= f.entry[a] * f.entry[b];
  }
}

double rigid_excess(const RigidLink& link, const double* x, const double* y, const double* z) {
  const std::size_t a = link.node[0], b = link.node[1];
  const double dx = x[b] - x[a], dy = y[b] - y[a], dz = z[b] - z[a];
  return (dx * dx + dy * dy + dz * dz - link.length * link.length) / (2 * link.length);
}

double rigid_along(const Rigid& rigid, const RigidNow& now, std::size_t link, const double* x,
                   const double* y, const double* z) {
  const double* f[] = {x, y, z};
  double sum = 0;
  for (std::size_t e = rigid.begin[rigid.held + link]; e < rigid.begin[rigid.held + link + 1]; ++e)
    sum += now.weight[e] * f[rigid.axis[e]][rigid.node[e]];
  return sum;
}

void rigid_correct(const Rigid& rigid, const Array& inverse_mass, RigidNow& now, const RigidField* field,
                   int fields) {
  rigid_factor(rigid, inverse_mass, now);
  math::cholesky_solve_scalar(now.factor, now.b.data());
  for (std::size_t r = 0; r + 1 < rigid.begin.size(); ++r) {
    now.y[r] += now.b[r];
    for (std::size_t e = rigid.begin[r]; e < rigid.begin[r + 1]; ++e) {
      if (rigid.fixed[e]) continue;
      const std::size_t n = rigid.node[e];
      const double pull = now.weight[e] * inverse_mass[n] * now.b[r];
      for (int k = 0; k < fields; ++k) {
        double* to[] = {field[k].x, field[k].y, field[k].z};
        to[rigid.axis[e]][n] -= field[k].scale * pull;
      }
    }
  }
}

}  // namespace drape::constraint
