// A hinge at node n1 joins a link of width w_0 that ends there and a link of width w_1 that begins there:
// half of either link in series. W_0 and W_1 are the total widths of all links of the yarn direction that end
// and begin at n1. q is the series factor of a link that leaves a clamp, else 1:
//
//   n0 ---w_0--- n1 ---w_1--- n2        kappa/B = 2 w_0 w_1/[b (q_0 W_1 + q_1 W_0)]
//
// The rows of nodes hold the hinges whose two links come from regular cells. All other hinges are irregular
// elements. Most nodes have regular cells and no clamp around them; their hinges follow from the shares of
// these cells. Only the others, *irregular nodes*, are treated link by link.
#include "assembly/weave.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drape::assembly {
namespace {

// A link along a yarn, by its lower node [0] and upper node [1] in the numbering of piece::Grid.
struct Span {
  int node[2];
  double width, dense;             // m, from all cells, from the regular ones
  double q[2] = {1, 1};            // 1, series factors in the hinges at its ends
  bool pivot[2] = {false, false};  // no hinge at this end: a clamp replaces it
  double clamps = 0;               // 1, sum of the weights of its clamp hinges
};

using Irregular = std::vector<char>;  // [nodes of Grid] 1 for irregular nodes

Irregular irregular_nodes(const piece::Grid& grid, const std::vector<ClampSlopes>& clamps) {
  Irregular irregular(std::size_t(grid.nodes()), false);
  for (std::size_t c = std::size_t(grid.regular); c < grid.cells.size(); ++c)
    for (int n : grid.cells[c].node) irregular[std::size_t(n)] = true;
  for (const ClampSlopes& clamp : clamps)
    for (const piece::HeldSlope& slope : clamp.slopes)
      irregular[std::size_t(slope.from)] = irregular[std::size_t(slope.to)] = true;
  return irregular;
}

// The links with an irregular end, sorted by their nodes.
std::vector<Span> spans_of(const piece::Grid& grid, const Irregular& irregular, bool warp) {
  std::vector<Span> all;
  for (int c = 0; c < int(grid.cells.size()); ++c) {
    const piece::GridCell& cell = grid.cells[std::size_t(c)];
    const double half = grid.cell * cell.share / 2;
    const auto [a, b, up, opposite] = cell.node;
    const int low[2] = {a, warp ? b : up}, high[2] = {warp ? up : b, opposite};
    for (int k = 0; k < 2; ++k)
      if (irregular[std::size_t(low[k])] || irregular[std::size_t(high[k])])
        all.push_back({{low[k], high[k]}, half, c < grid.regular ? half : 0});
  }
  std::stable_sort(all.begin(), all.end(), [](const Span& p, const Span& q) {
    return p.node[0] != q.node[0] ? p.node[0] < q.node[0] : p.node[1] < q.node[1];
  });
  std::size_t kept = 0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (kept > 0 && all[kept - 1].node[0] == all[k].node[0] && all[kept - 1].node[1] == all[k].node[1]) {
      all[kept - 1].width += all[k].width;
      all[kept - 1].dense += all[k].dense;
    } else {
      all[kept++] = all[k];
    }
  }
  all.resize(kept);
  return all;
}

// The link between two nodes given in either order; null where there is none.
Span* span_between(std::vector<Span>& spans, int p, int q) {
  for (const auto& [low, high] : {std::pair{p, q}, std::pair{q, p}}) {
    const auto s =
        std::lower_bound(spans.begin(), spans.end(), std::pair{low, high},
                         [](const Span& a, auto b) { return std::pair{a.node[0], a.node[1]} < b; });
    if (s != spans.end() && s->node[0] == low && s->node[1] == high) return &*s;
  }
  return nullptr;
}

Vec3 direction(const State& s, std::size_t from, std::size_t to) {
  const Vec3 d{s.x[to] - s.x[from], s.y[to] - s.y[from], s.z[to] - s.z[from]};
  const double length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  return {d[0] / length, d[1] / length, d[2] / length};
}

// Adds the clamp hinges on the links of one direction. Their excess over the hinges of a regular link, two of
// weight 1, is computed once all are there.
void clamps_lay(System& system, int lattice, std::vector<Span>& spans, bool warp,
                const std::vector<ClampSlopes>& clamps, const State& start) {
  const model::Lattice& l = system.lattices[std::size_t(lattice)];
  const std::size_t first = system.irregular.clamps.size();
  std::vector<Span*> link;
  for (const ClampSlopes& clamp : clamps)
    for (const piece::HeldSlope& slope : clamp.slopes) {
      Span* s = slope.warp == warp ? span_between(spans, slope.from, slope.to) : nullptr;
      if (!s) continue;
      const int held = s->node[0] == slope.from ? 0 : 1;
      s->q[1 - held] = slope.series;
      if (slope.pivot) s->pivot[held] = true;
      s->clamps += slope.clamp;
      const std::size_t from = l.node_of(slope.from), to = l.node_of(slope.to);
      system.irregular.clamps.push_back({{from, to},
                                         {},
                                         lattice,
                                         clamp.pin,
                                         warp,
                                         slope.clamp * 2 * s->width / l.cell,
                                         direction(start, from, to),
                                         0});
      link.push_back(s);
    }
  for (std::size_t k = 0; k < link.size(); ++k) {
    double load = link[k]->clamps;
    for (int end : {0, 1})
      if (!link[k]->pivot[end]) load += 1 / link[k]->q[end];
    system.irregular.clamps[first + k].excess = std::max(0.0, load / 2 - 1);
  }
}

// Sets the hinges of all regular nodes.
void hinges_fill(System& system, int lattice, const Irregular& irregular, bool warp) {
  const model::Lattice& l = system.lattices[std::size_t(lattice)];
  const std::ptrdiff_t along = warp ? l.stride : 1, across = warp ? 1 : l.stride;
  Array& rows = warp ? system.hinge_warp : system.hinge_weft;
  for (int j = 0; j < l.rows; ++j)
    for (int i = 0; i < l.columns; ++i) {
      if (irregular[std::size_t(j * l.columns + i)]) continue;
      const std::size_t n = l.node(i, j);
      const auto width = [&](std::ptrdiff_t cell) {
        return l.cell * system.share[std::size_t(std::ptrdiff_t(n) + cell)] / 2;
      };
      const double before = width(-along - across) + width(-along), after = width(-across) + width(0);
      if (before > 0 && after > 0) rows[n] = 2 * before * after / (l.cell * (after + before));
    }
}

// Sets or adds the hinges of the irregular nodes.
void hinges_lay(System& system, int lattice, const std::vector<Span>& spans, const Irregular& irregular,
                bool warp) {
  const model::Lattice& l = system.lattices[std::size_t(lattice)];
  std::vector<const Span*> ending;  // by their upper node
  for (const Span& s : spans)
    if (irregular[std::size_t(s.node[1])]) ending.push_back(&s);
  std::stable_sort(ending.begin(), ending.end(),
                   [](const Span* p, const Span* q) { return p->node[1] < q->node[1]; });
  Array& rows = warp ? system.hinge_warp : system.hinge_weft;
  auto begins = spans.begin();
  for (auto e = ending.begin(); e != ending.end();) {
    const int at = (*e)->node[1];
    const auto e_end = std::find_if(e, ending.end(), [&](const Span* s) { return s->node[1] != at; });
    begins = std::lower_bound(begins, spans.end(), at, [](const Span& s, int n) { return s.node[0] < n; });
    const auto b_end = std::find_if(begins, spans.end(), [&](const Span& s) { return s.node[0] != at; });
    double before = 0, after = 0;
    bool pivot = false;
    for (auto k = e; k != e_end; ++k) before += (*k)->width, pivot = pivot || (*k)->pivot[1];
    for (auto k = begins; k != b_end; ++k) after += k->width, pivot = pivot || k->pivot[0];
    for (; e != e_end; ++e)
      for (auto b = begins; b != b_end && !pivot; ++b) {
        const double share = 2 * (*e)->width * b->width / (l.cell * ((*e)->q[1] * after + b->q[0] * before));
        const std::size_t n = l.node_of(at);
        if ((*e)->dense > 0 && b->dense > 0) rows[n] = share;
        else
          system.irregular.hinges.push_back(
              {{l.node_of((*e)->node[0]), n, l.node_of(b->node[1])}, {}, lattice, warp, share});
      }
    begins = b_end;
  }
}

// Adds links and diagonals of irregular cells. Their widths come from those cells alone.
void links_lay(System& system, int lattice, const std::vector<Span>& spans, model::YarnDirection along) {
  const model::Lattice& l = system.lattices[std::size_t(lattice)];
  for (const Span& s : spans)
    if (s.width > s.dense)
      system.irregular.links.push_back({{l.node_of(s.node[0]), l.node_of(s.node[1])},
                                        {},
                                        lattice,
                                        along,
                                        s.width - s.dense,
                                        l.cell,
                                        s.dense > 0});
}
void cells_lay(System& system, int lattice, const piece::Grid& grid) {
  const model::Lattice& l = system.lattices[std::size_t(lattice)];
  const double diagonal = std::numbers::sqrt2 * l.cell;
  for (std::size_t c = std::size_t(grid.regular); c < grid.cells.size(); ++c) {
    const piece::GridCell& cell = grid.cells[c];
    model::IrregularCell laid{{}, {}, lattice, cell.share};
    for (int k = 0; k < 4; ++k) laid.node[k] = l.node_of(cell.node[k]);
    const double width = l.cell * l.cell / diagonal * cell.share;
    const auto [a, b, up, opposite] = laid.node;
    system.irregular.links.push_back(
        {{a, opposite}, {}, lattice, model::YarnDirection::kBias, width, diagonal, false});
    system.irregular.links.push_back(
        {{b, up}, {}, lattice, model::YarnDirection::kBias, width, diagonal, false});
    system.irregular.cells.push_back(laid);
  }
}

}  // namespace

void weave_lay(System& system, int lattice, const piece::Grid& grid, const std::vector<ClampSlopes>& clamps,
               const State& start) {
  const Irregular irregular = irregular_nodes(grid, clamps);
  for (bool warp : {true, false}) {
    hinges_fill(system, lattice, irregular, warp);
    std::vector<Span> spans = spans_of(grid, irregular, warp);
    clamps_lay(system, lattice, spans, warp, clamps, start);
    hinges_lay(system, lattice, spans, irregular, warp);
    links_lay(system, lattice, spans, warp ? model::YarnDirection::kWarp : model::YarnDirection::kWeft);
  }
  cells_lay(system, lattice, grid);
}

void slots_number(System& system) {
  model::IrregularElements& elements = system.irregular;
  std::vector<std::size_t> touched;
  const auto each_node = [&](auto visit) {
    for (model::IrregularLink& s : elements.links)
      for (int k = 0; k < 2; ++k) visit(s.node[k], s.slot[k]);
    for (model::IrregularHinge& s : elements.hinges)
      for (int k = 0; k < 3; ++k) visit(s.node[k], s.slot[k]);
    for (model::IrregularCell& s : elements.cells)
      for (int k = 0; k < 4; ++k) visit(s.node[k], s.slot[k]);
    for (model::ClampHinge& s : elements.clamps)
      for (int k = 0; k < 2; ++k) visit(s.node[k], s.slot[k]);
    const auto row = [&](model::NodeSum& r) {
      for (model::NodeTerm& t : r) visit(t.node, t.slot);
    };
    for (model::SeamPair& s : system.seams.pair) row(s.gap);
    for (model::SeamHinge& s : system.seams.hinge)
      for (model::NodeSum& arm : s.arm) row(arm);
    for (model::SeamLink& s : system.seams.link) row(s.edge);
  };
  each_node([&](std::size_t node, int&) { touched.push_back(node); });
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());

  auto next = touched.begin();
  std::vector<std::size_t> slot_of(touched.size());
  for (model::Lattice& l : system.lattices) {
    l.twin_slot = int(elements.node.size());
    for (int k = 0; k < l.twin_stride; ++k) elements.node.push_back(l.twin_first + std::size_t(k));
    const std::size_t rows_end = l.node(0, l.rows);
    if (next != touched.end() && *next < rows_end) l.row_slot.assign(std::size_t(l.rows) + 1, 0);
    for (int j = 0; j < int(l.row_slot.size()); ++j) {
      l.row_slot[std::size_t(j)] = int(elements.node.size());
      if (j == l.rows) break;
      for (; next != touched.end() && *next < l.node(0, j + 1); ++next) {
        slot_of[std::size_t(next - touched.begin())] = elements.node.size();
        elements.node.push_back(*next);
      }
    }
    for (; next != touched.end() && *next < l.end(); ++next)
      slot_of[std::size_t(next - touched.begin())] = std::size_t(l.twin_slot) + (*next - l.twin_first);
    while (elements.node.size() % math::kRowUnit != 0) elements.node.push_back(l.first);
  }
  each_node([&](std::size_t node, int& slot) {
    slot =
        int(slot_of[std::size_t(std::lower_bound(touched.begin(), touched.end(), node) - touched.begin())]);
  });
}

}  // namespace drape::assembly
