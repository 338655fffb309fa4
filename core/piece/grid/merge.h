// Parts of a cut piece as neighbours of each other: which small ones their neighbours take over, and which
// share a corner. core/README.md, section 1.
#pragma once
#include <map>

#include "piece/grid/cut.h"

namespace drape::piece {

// A part or a whole place: the number of the part, or of the place beyond them.
using PartRef = int;

struct Merged {
  std::vector<PartRef> into;         // [parts] itself, or the one that took it over
  std::map<PartRef, double> gained;  // share that a part or whole place has taken over
};
Merged merge_make(const Cut& cut);
Merged merge_none(const Cut& cut);

int part_place(const Cut& cut, PartRef part);
double part_share(const Cut& cut, const Merged& merged, PartRef part);

// The remaining parts round the low corner of a place, as sets of parts that hang together there.
std::vector<std::vector<PartRef>> corner_sets(const Cut& cut, const Merged& merged, int place);

}  // namespace drape::piece
