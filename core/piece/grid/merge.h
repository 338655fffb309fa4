// Adjacency of the parts of a cut piece: which small parts are merged into a neighbour, and which parts are
// connected at a corner. core/README.md, section 1.
#pragma once
#include <map>

#include "piece/grid/cut.h"

namespace drape::piece {

// A part or a whole place: the number of the part, or the number of parts plus that of the place.
using PartRef = int;

struct Merged {
  std::vector<PartRef> into;         // [parts] the part itself, or that into which it is merged
  std::map<PartRef, double> gained;  // share gained by a part or whole place from merged ones
};
Merged merge_make(const Cut& cut);  // merges small parts
Merged merge_none(const Cut& cut);  // merges nothing

int part_place(const Cut& cut, PartRef part);

// The area of a part with what it has gained, over that of a whole cell.
double part_share(const Cut& cut, const Merged& merged, PartRef part);

// The remaining parts around the low corner of a place, as sets of parts that are connected there.
std::vector<std::vector<PartRef>> corner_sets(const Cut& cut, const Merged& merged, int place);

}  // namespace drape::piece
