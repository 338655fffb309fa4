#include "constraint/linear_constraints.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <unordered_map>

#include "math/vector3.h"

namespace drape::constraint {
namespace {

using namespace math::vector3;

constexpr double kRankTolerance = 1e-10;  // pivot of A M^-1 A^T, relative to the row's own diagonal
// The same for a weld, after pins and other welds. Below it, almost no freedom is left, and closing the whole
// gap with that little freedom would need large displacements.
constexpr double kWeldTolerance = 1e-3;
// Tolerances of the comparison of redundant rows. The weights of a dependent row may differ by the square
// root of kRankTolerance.
constexpr double kTargetTolerance = 1e-6;  // m
constexpr double kShareTolerance = 1e-4;

// A constraint during the elimination of fixed nodes and dependent rows.
struct OpenRow {
  int pin;
  math::SparseRow on;
  std::vector<TargetPart> parts;
};

void parts_add(std::vector<TargetPart>& sum, const std::vector<TargetPart>& parts, double factor) {
  for (const TargetPart& p : parts) {
    auto same = std::find_if(sum.begin(), sum.end(), [&](const TargetPart& s) { return s.pin == p.pin; });
    if (same == sum.end()) same = sum.insert(sum.end(), {p.pin, 0, {0, 0, 0}});
    same->share += factor * p.share;
    same->start += factor * p.start;
  }
}

using Fixed = std::unordered_map<std::size_t, std::vector<TargetPart>>;

// Eliminates fixed nodes from a row.
void row_reduce(OpenRow& row, const Fixed& fixed) {
  math::SparseRow kept;
  for (std::size_t k = 0; k < row.on.node.size(); ++k) {
    const auto f = fixed.find(row.on.node[k]);
    if (f != fixed.end()) {
      parts_add(row.parts, f->second, -row.on.weight[k]);
      continue;
    }
    kept.node.push_back(row.on.node[k]);
    kept.weight.push_back(row.on.weight[k]);
  }
  row.on = std::move(kept);
}

// Reports a problem where a residual target is not 0, at the start or for some motion of the driven pins.
void contradiction_report(const std::vector<PinBase>& pins, int pin, const std::vector<TargetPart>& residual,
                          std::vector<Problem>& problems) {
  if (pin < 0) return;
  const std::string& name = pins[std::size_t(pin)].name;
  Vec3 off{0, 0, 0};
  const PinBase *driven = nullptr, *other = nullptr;
  for (const TargetPart& part : residual) {
    const PinBase& base = pins[std::size_t(part.pin)];
    off += part.start;
    const bool shifts = std::abs(part.share) > kShareTolerance,
               turns = base.clamp && norm(part.start - part.share * base.centre) > kTargetTolerance;
    if (base.drive != scene::Drive::kNone && (shifts || turns)) driven = &base;
    if (base.name != name) other = &base;
  }
  if (norm(off) > kTargetTolerance)
    problems.push_back({"pin." + name, "contradicts the other pins by " + std::to_string(norm(off)) + " m"});
  else if (driven && other)
    problems.push_back({"pin." + name, "holds cloth that pin '" + other->name + "' holds too, and '" +
                                           driven->name +
                                           "' is driven; allowed: driven pins hold cloth of their own"});
}

// For each node, the kept rows that contain it, with their weights.
using RowsByNode = std::unordered_map<std::size_t, std::vector<std::pair<std::size_t, double>>>;

// The residual target of a dependent row. The row is a combination of the kept rows; the result is its own
// target minus the same combination of their targets.
std::vector<TargetPart> residual_target(const OpenRow& row, const std::vector<OpenRow>& kept,
                                        const RowsByNode& by_node, const math::CholeskyFactor& factor,
                                        const Array& inverse_mass) {
  std::vector<double> b(3 * kept.size(), 0.0);
  for (std::size_t k = 0; k < row.on.node.size(); ++k) {
    const auto found = by_node.find(row.on.node[k]);
    if (found == by_node.end()) continue;
    for (const auto& [r, weight] : found->second)
      b[3 * r] += row.on.weight[k] * weight * inverse_mass[row.on.node[k]];
  }
  math::cholesky_solve(factor, b.data());
  std::vector<TargetPart> residual = row.parts;
  for (std::size_t r = 0; r < kept.size(); ++r)
    if (b[3 * r] != 0) parts_add(residual, kept[r].parts, -b[3 * r]);
  return residual;
}

std::vector<const math::SparseRow*> pointers_to(const std::vector<OpenRow>& rows) {
  std::vector<const math::SparseRow*> pointers;
  for (const OpenRow& row : rows) pointers.push_back(&row.on);
  return pointers;
}

// Returns the independent rows, in their order, and checks the dependent ones for contradictions.
std::vector<OpenRow> rows_independent(std::vector<OpenRow> rows, const Array& inverse_mass,
                                      const std::vector<PinBase>& pins, std::vector<Problem>& problems) {
  const auto welds =
      std::stable_partition(rows.begin(), rows.end(), [](const OpenRow& r) { return r.pin >= 0; });
  const math::CholeskyFactor all = math::cholesky_factorise(
      pointers_to(rows), inverse_mass, kRankTolerance, std::size_t(welds - rows.begin()), kWeldTolerance);
  if (all.row.size() == rows.size()) return rows;
  std::vector<char> independent(rows.size(), 0);
  for (int r : all.row) independent[std::size_t(r)] = 1;
  std::vector<OpenRow> kept, dependent;
  for (std::size_t r = 0; r < rows.size(); ++r)
    (independent[r] ? kept : dependent).push_back(std::move(rows[r]));
  RowsByNode by_node;
  for (std::size_t r = 0; r < kept.size(); ++r)
    for (std::size_t k = 0; k < kept[r].on.node.size(); ++k)
      by_node[kept[r].on.node[k]].push_back({r, kept[r].on.weight[k]});
  const math::CholeskyFactor factor = math::cholesky_factorise(pointers_to(kept), inverse_mass, 0);
  for (const OpenRow& row : dependent)
    contradiction_report(pins, row.pin, residual_target(row, kept, by_node, factor, inverse_mass), problems);
  return kept;
}

Target target_make(Constraints& c, const std::vector<TargetPart>& parts) {
  Target t{int(c.parts.size()), 0, {0, 0, 0}, false};
  for (const TargetPart& part : parts) {
    if (part.share == 0 && norm(part.start) == 0) continue;
    c.parts.push_back(part);
    ++t.count;
    t.start += part.start;
    t.moves = t.moves || c.pins[std::size_t(part.pin)].drive != scene::Drive::kNone;
  }
  return t;
}

// Fixes the nodes of rows with a single node, and eliminates these nodes from the other rows. That may leave
// other rows with a single node, so it is repeated.
std::vector<OpenRow> nodes_fix(Constraints& c, std::vector<OpenRow> rows, std::vector<Problem>& problems) {
  Fixed fixed;
  for (bool again = true; again;) {
    again = false;
    std::vector<OpenRow> open;
    for (OpenRow& row : rows) {
      row_reduce(row, fixed);
      if (row.on.node.empty()) {
        contradiction_report(c.pins, row.pin, row.parts, problems);
      } else if (row.on.node.size() == 1) {
        std::vector<TargetPart> parts;
        parts_add(parts, row.parts, 1 / row.on.weight[0]);
        c.fixed.push_back({row.on.node[0], target_make(c, parts)});
        fixed.emplace(row.on.node[0], std::move(parts));
        again = true;
      } else {
        open.push_back(std::move(row));
      }
    }
    rows = std::move(open);
  }
  return rows;
}

// The connected part of each row, named by the first row of the part. Rows that share a node are in the same
// part. Union-find with path halving.
std::vector<std::size_t> parts_of(const std::vector<OpenRow>& rows) {
  std::vector<std::size_t> up(rows.size());  // an earlier row of the same part, or the row itself
  std::iota(up.begin(), up.end(), std::size_t(0));
  const auto first = [&](std::size_t r) {
    while (up[r] != r) r = up[r] = up[up[r]];
    return r;
  };
  std::unordered_map<std::size_t, std::size_t> row_of;  // first row that contains the node
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t n : rows[r].on.node) {
      const std::size_t a = first(row_of.try_emplace(n, r).first->second), b = first(r);
      up[std::max(a, b)] = std::min(a, b);
    }
  for (std::size_t r = 0; r < rows.size(); ++r) up[r] = first(r);
  return up;
}

// Stores the rows in `c`, sorted by part.
void rows_collect(Constraints& c, std::vector<OpenRow> rows) {
  const std::vector<std::size_t> part = parts_of(rows);
  std::vector<std::size_t> order(rows.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return part[a] < part[b]; });
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k == 0 || part[order[k]] != part[order[k - 1]]) c.part.push_back({k, k, {}, {}, {}, {}});
    OpenRow& row = rows[order[k]];
    for (std::size_t n : row.on.node) c.part.back().line.push_back(std::uint32_t(n / math::kRowUnit));
    c.part.back().end = k + 1;
    const Target target = target_make(c, row.parts);
    if (target.count > 0) c.rows_with_target.push_back(k);
    c.rows.push_back({std::move(row.on), target});
  }
  for (RowPart& p : c.part) {
    std::sort(p.line.begin(), p.line.end());
    p.line.erase(std::unique(p.line.begin(), p.line.end()), p.line.end());
  }
}

}  // namespace

Constraints constraints_make(const std::vector<ConstraintRow>& rows, const Array& inverse_mass,
                             std::vector<PinBase> pins, std::vector<Problem>& problems,
                             const std::vector<RigidLink>& links) {
  Constraints c;
  c.pins = std::move(pins);
  std::vector<OpenRow> open;
  for (const ConstraintRow& row : rows)
    open.push_back(
        {row.pin,
         {row.node, row.weight},
         row.pin < 0 ? std::vector<TargetPart>{} : std::vector{TargetPart{row.pin, 1, row.target}}});
  rows_collect(c, rows_independent(nodes_fix(c, std::move(open), problems), inverse_mass, c.pins, problems));
  constraints_refactor(c, inverse_mass);
  c.rigid = rigid_make(c.rows, c.fixed, links);
  return c;
}

void constraints_refactor(Constraints& c, const Array& inverse_mass) {
  for (RowPart& part : c.part) {
    std::vector<const math::SparseRow*> rows;
    part.term.clear();
    part.last.clear();
    for (std::size_t r = part.begin; r < part.end; ++r) {
      const math::SparseRow& row = c.rows[r].on;
      rows.push_back(&row);
      for (std::size_t k = 0; k < row.node.size(); ++k)
        part.term.push_back(
            {std::uint32_t(row.node[k]), row.weight[k], row.weight[k] * inverse_mass[row.node[k]]});
      part.last.push_back(part.term.size());
    }
    part.factor = math::cholesky_factorise(rows, inverse_mass, 0);
  }
}

}  // namespace drape::constraint
