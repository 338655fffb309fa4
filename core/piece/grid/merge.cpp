// A small part may be merged where its removal does not change the topology of the cells. Cells are connected
// along sides. Removing one keeps the topology of the piece (its components and its holes) under two
// conditions. The sides with neighbours are consecutive around the cell and not all four. The neighbours at
// each of its corners are connected there without the cell.
#include "piece/grid/merge.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace drape::piece {
namespace {

constexpr double kSmall = 0.2;    // share of a cell below which a part is merged
constexpr double kShared = 1e-9;  // of a side: neighbours share more than this length

// The step in place number across a side.
int step_to(const Cut& cut, int side) {
  const int steps[] = {-cut.columns, 1, cut.columns, -1};
  return steps[side];
}

bool is_part(const Cut& cut, PartRef part) { return part < int(cut.parts.size()); }

// Calls `use` for all parts of a place, including merged ones.
template <class Use>
void parts_of(const Cut& cut, int place, Use use) {
  const int first = cut.first[std::size_t(place)];
  if (first == kPlaceWhole) use(PartRef(cut.parts.size()) + place);
  for (int p = first; p >= 0 && p < int(cut.parts.size()) && cut.parts[std::size_t(p)].place == place; ++p)
    use(p);
}

// The stretches of a side that belong to a part.
std::vector<CutSide> reaches(const Cut& cut, PartRef part, int side) {
  if (!is_part(cut, part)) return {{side, 0, 1}};
  std::vector<CutSide> list;
  for (const CutSide& s : cut.parts[std::size_t(part)].sides)
    if (s.side == side) list.push_back(s);
  return list;
}

// Length over which two parts touch, on a side of the first.
double shared_length(const Cut& cut, PartRef a, int side, PartRef b) {
  double sum = 0;
  for (const CutSide& s : reaches(cut, a, side))
    for (const CutSide& t : reaches(cut, b, (side + 2) % 4))
      if (const double length = std::min(s.to, t.to) - std::max(s.from, t.from); length > kShared)
        sum += length;
  return sum;
}

struct Neighbour {
  PartRef part;
  int side;
  double length;
};

std::vector<Neighbour> neighbours_of(const Cut& cut, PartRef part) {
  std::vector<Neighbour> list;
  for (int side = 0; side < 4; ++side)
    parts_of(cut, part_place(cut, part) + step_to(cut, side), [&](PartRef other) {
      if (const double length = shared_length(cut, part, side, other); length > 0)
        list.push_back({other, side, length});
    });
  return list;
}

bool remains(const Cut& cut, const Merged& merged, PartRef part) {
  return !is_part(cut, part) || merged.into[std::size_t(part)] == part;
}

PartRef merge_target(const Cut& cut, const Merged& merged, PartRef part) {
  return is_part(cut, part) ? merged.into[std::size_t(part)] : part;
}

// The parts around the low corner of a place, without `left_out`, as sets of parts that are connected there.
std::vector<std::vector<PartRef>> sets_without(const Cut& cut, const Merged& merged, int place,
                                               PartRef left_out) {
  // the four places around the node, counter-clockwise from its lower left; `side` is shared with the next
  // one
  const int round[4] = {place - cut.columns - 1, place - cut.columns, place, place - 1},
            side[4] = {1, 2, 3, 0};
  std::vector<std::pair<PartRef, int>> parts;  // with the index of their place, 0 to 3
  for (int k = 0; k < 4; ++k)
    parts_of(cut, round[k], [&](PartRef p) {
      if (p != left_out && remains(cut, merged, p)) parts.emplace_back(p, k);
    });
  std::vector<std::size_t> set(parts.size());
  for (std::size_t a = 0; a < set.size(); ++a) set[a] = a;
  for (std::size_t a = 0; a < set.size(); ++a)
    for (std::size_t b = 0; b < set.size(); ++b) {
      const int k = parts[a].second;
      if (parts[b].second != (k + 1) % 4 || set[a] == set[b]) continue;
      if (shared_length(cut, parts[a].first, side[k], parts[b].first) > 0)
        std::replace(set.begin(), set.end(), std::max(set[a], set[b]), std::min(set[a], set[b]));
    }
  std::vector<std::vector<PartRef>> sets;
  for (std::size_t s = 0; s < set.size(); ++s) {
    if (set[s] != s) continue;
    sets.emplace_back();
    for (std::size_t a = s; a < set.size(); ++a)
      if (set[a] == s) sets.back().push_back(parts[a].first);
  }
  return sets;
}

// True if the neighbours at a corner are connected there without the part. Corners are numbered
// counter-clockwise from the low one; corner k is between the sides k - 1 and k.
bool corner_is_connected(const Cut& cut, const Merged& merged, PartRef part, int corner,
                         const std::vector<Neighbour>& neighbours) {
  const int steps[] = {0, 1, cut.columns + 1, cut.columns};
  const auto sets = sets_without(cut, merged, part_place(cut, part) + steps[corner], part);
  const std::vector<PartRef>* common = nullptr;
  for (const Neighbour& n : neighbours) {
    if (n.side != corner && n.side != (corner + 3) % 4) continue;
    const auto set = std::find_if(sets.begin(), sets.end(), [&](const std::vector<PartRef>& s) {
      return std::find(s.begin(), s.end(), n.part) != s.end();
    });
    if (common && common != &*set) return false;
    common = &*set;
  }
  return true;
}

bool is_removable(const Cut& cut, const Merged& merged, PartRef part, std::vector<Neighbour> neighbours) {
  std::erase_if(neighbours, [&](const Neighbour& n) { return !remains(cut, merged, n.part); });
  bool has[4] = {};
  for (const Neighbour& n : neighbours) has[n.side] = true;
  int begins = 0;
  for (int side = 0; side < 4; ++side) begins += has[side] && !has[(side + 3) % 4];
  if (begins != 1) return false;  // no side, two opposite ones, or all four
  for (int corner = 0; corner < 4; ++corner)
    if (!corner_is_connected(cut, merged, part, corner, neighbours)) return false;
  return true;
}

// The part into which a small part is merged: one with a share of at least kSmall of its own, in the eight
// places around it. Of several, the one with the longest common side; -1: none.
PartRef merge_target_find(const Cut& cut, const Merged& merged, PartRef part,
                          const std::vector<Neighbour>& neighbours) {
  const int place = part_place(cut, part);
  PartRef best = -1;
  double longest = 0;
  for (const Neighbour& n : neighbours) {
    const PartRef to = merge_target(cut, merged, n.part);
    const int at = part_place(cut, to);
    const int di = std::abs(at % cut.columns - place % cut.columns);
    const int dj = std::abs(at / cut.columns - place / cut.columns);
    if (at == place || di > 1 || dj > 1) continue;
    if (is_part(cut, to) && cut.parts[std::size_t(to)].share < kSmall) continue;
    if (n.length > longest) best = to, longest = n.length;
  }
  return best;
}

}  // namespace

int part_place(const Cut& cut, PartRef part) {
  return is_part(cut, part) ? cut.parts[std::size_t(part)].place : part - int(cut.parts.size());
}

double part_share(const Cut& cut, const Merged& merged, PartRef part) {
  const auto gained = merged.gained.find(part);
  return (is_part(cut, part) ? cut.parts[std::size_t(part)].share : 1) +
         (gained == merged.gained.end() ? 0 : gained->second);
}

std::vector<std::vector<PartRef>> corner_sets(const Cut& cut, const Merged& merged, int place) {
  return sets_without(cut, merged, place, -1);
}

Merged merge_none(const Cut& cut) {
  Merged merged;
  for (int p = 0; p < int(cut.parts.size()); ++p) merged.into.push_back(p);
  return merged;
}

Merged merge_make(const Cut& cut) {
  Merged merged = merge_none(cut);
  using Small = std::pair<double, PartRef>;
  std::priority_queue<Small, std::vector<Small>, std::greater<>> queue;  // the smallest first
  const auto enqueue = [&](PartRef p) {
    if (is_part(cut, p) && remains(cut, merged, p) && cut.parts[std::size_t(p)].share < kSmall)
      queue.emplace(cut.parts[std::size_t(p)].share, p);
  };
  for (int p = 0; p < int(cut.parts.size()); ++p) enqueue(p);
  while (!queue.empty()) {
    const PartRef part = queue.top().second;
    queue.pop();
    if (!remains(cut, merged, part)) continue;
    const std::vector<Neighbour> neighbours = neighbours_of(cut, part);
    const PartRef to = merge_target_find(cut, merged, part, neighbours);
    if (to < 0 || !is_removable(cut, merged, part, neighbours)) continue;
    merged.into[std::size_t(part)] = to;
    merged.gained[to] += cut.parts[std::size_t(part)].share;
    for (const Neighbour& n : neighbours) enqueue(n.part);
  }
  return merged;
}

}  // namespace drape::piece
