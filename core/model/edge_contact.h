// The elements of the cloth that may touch sharp features: links along the yarns, and cells.
#pragma once
#include <cstdint>
#include <vector>

namespace drape::model {

// A link joins nodes 0 and 1. Nodes 2 and 3, 4 and 5 are the opposite corners of the cells on its two sides.
// A cell has its corners a, b, c, d.
struct EdgeElement {
  std::uint32_t node[6];
  int nodes;  // 4 or 6 for a link, 4 for a cell
  bool cell;
  int lattice;
  int weights() const { return cell ? 4 : 2; }
};

struct EdgeElements {
  std::vector<EdgeElement> element;
  std::vector<std::uint32_t> first,
      of_node;  // elements of node n: of_node[first[n]] .. of_node[first[n+1] - 1]
};

}  // namespace drape::model
