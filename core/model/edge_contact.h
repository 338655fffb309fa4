// What of the cloth meets ridges: links along the threads and cells, and which of them a node is in.
#pragma once
#include <cstdint>
#include <vector>

namespace drape::model {

// A link has the nodes 0 and 1, and of the cells on its sides those across from these: 2 and 3, 4 and 5. A
// cell has its corners a, b, c, d.
struct EdgeElement {
  std::uint32_t node[6];
  int nodes;  // 4 or 6 of a link, 4 of a cell
  bool cell;
  int lattice;
  int weights() const { return cell ? 4 : 2; }
};

struct EdgeElements {
  std::vector<EdgeElement> element;
  std::vector<std::uint32_t> first, of_node;  // those of node n: of_node[first[n]] .. of_node[first[n + 1]]
};

}  // namespace drape::model
