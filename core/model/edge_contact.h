// What of the cloth meets ridges: links along the threads and cells, and which of them a node is in.
#pragma once
#include <cstdint>
#include <vector>

namespace drape {

// A link has the nodes 0 and 1, and of the cells on its sides those across from these: 2 and 3, 4 and 5. A
// cell has its corners a, b, c, d.
struct RidgePart {
  std::uint32_t node[6];
  int nodes;  // 4 or 6 of a link, 4 of a cell
  bool cell;
  int lattice;
  int weights() const { return cell ? 4 : 2; }
};

struct RidgeCloth {
  std::vector<RidgePart> part;
  std::vector<std::uint32_t> first, of_node;  // those of node n: of_node[first[n]] .. of_node[first[n + 1]]
};

struct System;

// Finds the ridges of all bodies, and lays the parts where there are any.
void ridges_find(System& system);

// Sine from which a ridge counts for a lattice, m from which it is looked at.
struct Lattice;
double ridge_sine(const Lattice& lattice);
double ridge_margin(const Lattice& lattice);  // m, that a listing is good for
double ridge_near(const Lattice& lattice);    // m, from a ridge: nodes whose parts may come near it

}  // namespace drape
