#include "dynamics/kernel/row_blocks.h"

#include <algorithm>

namespace drape::dynamics {
namespace {

std::int64_t nodes_of(const model::Lattice& l) { return std::int64_t(l.rows) * l.stride; }
std::int64_t nodes_of(const System& system) {
  std::int64_t nodes = 0;
  for (const model::Lattice& l : system.lattices) nodes += nodes_of(l);
  return nodes;
}

// Gives each thread blocks of about as many nodes. All rows are in one order; thread t has those from the
// share t/threads of the nodes on.
void blocks_distribute(const System& system, std::vector<ThreadWorkspace>& threads) {
  const std::int64_t all = nodes_of(system);
  std::int64_t before = 0;
  const std::int64_t count = std::int64_t(threads.size());
  for (std::size_t k = 0; k < system.lattices.size(); ++k) {
    const model::Lattice& l = system.lattices[k];
    const auto row_of = [&](std::int64_t thread) {  // the first of its rows in this lattice
      const std::int64_t row = (all * thread / count - before + l.stride / 2) / l.stride;
      return int(std::clamp<std::int64_t>(row, 0, l.rows));
    };
    for (std::int64_t t = 0; t < count; ++t) {
      const int begin = t == 0 ? 0 : row_of(t), end = t + 1 == count ? l.rows : row_of(t + 1);
      if (begin < end) threads[std::size_t(t)].blocks.push_back({int(k), begin, end, {}});
    }
    before += nodes_of(l);
  }
}

// Copies row j of a lattice to row `slot` of the copies.
void row_copy(const model::Lattice& l, const State& s, int j, int slot, Array& copies) {
  const Array* from[] = {&s.x, &s.y, &s.z, &s.vx, &s.vy, &s.vz, &s.wx, &s.wy, &s.wz};
  const int coordinates = block_coordinates(s);
  const std::size_t first = l.node(0, j), n = std::size_t(l.stride);
  for (int k = 0; k < coordinates; ++k)
    std::copy_n(from[k]->data() + first, n, copies.data() + std::size_t(slot * coordinates + k) * n);
}

}  // namespace

// To call a thread costs about half a microsecond a step, and each block computes up to three rows of its
// neighbours. A thread with fewer nodes than kNodesEach is no gain.
int threads_wanted(const System& system) {
  constexpr std::int64_t kNodesEach = 2000;
  return int(std::clamp<std::int64_t>(nodes_of(system) / kNodesEach, 1, system.threads));
}

Workspace workspace_make(const System& system, int threads) {
  Workspace w;
  int longest = 0;
  for (const model::Lattice& l : system.lattices) longest = std::max(longest, l.stride);
  w.threads.resize(std::size_t(threads));
  for (ThreadWorkspace& workspace : w.threads)
    workspace.rows.assign(std::size_t(kScratchRows) * std::size_t(longest), 0.0);
  blocks_distribute(system, w.threads);
  if (threads > 1) w.workers = workers_start(threads);
  for (Array* a : {&w.slot_x, &w.slot_y, &w.slot_z}) a->assign(system.irregular.node.size(), 0.0);
  return w;
}

void workspace_clear(Workspace& w) {
  for (ThreadWorkspace& workspace : w.threads) std::fill(workspace.rows.begin(), workspace.rows.end(), 0.0);
}

void blocks_copy(const System& system, const State& s, Workspace& w) {
  for (ThreadWorkspace& workspace : w.threads)
    for (RowBlock& block : workspace.blocks) {
      const model::Lattice& l = system.lattices[std::size_t(block.lattice)];
      if (block.begin == 0 && block.end == l.rows) continue;
      block.copies.resize(4 * std::size_t(block_coordinates(s)) * std::size_t(l.stride));
      const int deep = fabric::law_bends(l.law) ? 2 : 1;  // rows that hinges next to a row reach
      for (int slot = 2 - deep; slot < 2 + deep; ++slot) {
        const int j = slot < 2 ? block.begin - 2 + slot : block.end + slot - 2;
        if (j >= 0 && j < l.rows) row_copy(l, s, j, slot, block.copies);
      }
    }
}

}  // namespace drape::dynamics
