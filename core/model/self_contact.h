// Cloth against cloth: what a system knows of its own surface, and what the motion changes. core/README.md,
// section 8.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "math/aligned_array.h"
#include "scene/scene.h"

namespace drape::model {

using NodeIndex = std::uint32_t;
inline constexpr NodeIndex kNoNode = 0xffffffff;

// An edge of a triangle, and the corners across it: of its one or two triangles.
struct SelfEdge {
  NodeIndex node[2];
  NodeIndex across[2];  // kNoNode where there is none
};

// A cell of cloth as the triangles a b d and a d c.
struct SelfCell {
  NodeIndex node[4];  // corners a, b, c, d
  int lattice, i, j;
  int node_first, node_end;  // in SelfMesh::own_node: each particle in one cell
  int edge_first, edge_end;  // in SelfMesh::edge, likewise
  int seam_first, seam_end;  // in SelfMesh::near_seam
};

struct NearSeam {
  int place;        // where pairs of seams meet: sewn points of the cloth
  double distance;  // m along the cloth, from the cell's centre
};

struct NodeSpan {
  std::size_t begin, end;
};

// Constant after assembly; without cells where cloth does not touch cloth.
struct SelfMesh {
  std::vector<SelfCell> cell;
  std::vector<NodeIndex> own_node;
  std::vector<SelfEdge> edge;
  std::vector<NearSeam> near_seam;
  std::vector<NodeSpan> span;        // runs of particles in the arrays of nodes
  std::vector<int> lattice_of;       // [nodes]
  std::vector<char> fixed;           // [nodes] 1 where a pin holds it
  Array max_contact_distance;        // [nodes] m: nearer than the thickness at the start, else infinite
  std::vector<int> exclusion_cells;  // [lattices] cells as near as this along the cloth do not touch
  std::vector<double> min_protrusion_sine;  // [lattices] sine from which edges do: look.cpp
  double seam_exclusion_distance = 0;       // m, likewise along the cloth across a seam
  double contact_distance = 0;              // m, the thickest
  double min_cell = 0;                      // m
};

// A particle and a triangle; two edges.
struct SelfPoint {
  NodeIndex node[4];
  double contact_distance;  // m, at which the pair touches: the mean thickness, or how near it started
};
struct SelfCross {
  NodeIndex node[4];
  NodeIndex edge[2];        // of SelfMesh
  double contact_distance;  // m
};
struct SelfPairs {
  std::vector<SelfPoint> point;  // sorted by their nodes
  std::vector<SelfCross> cross;  // likewise
  std::size_t size() const { return point.size() + cross.size(); }
};

// What friction held at a pair in the last step.
struct SelfHold {
  std::array<NodeIndex, 4> node;
  bool cross, sticks;
  Vec3 force;  // N
};

inline constexpr std::size_t kPairsPerBlock = 32;  // pairs

// What the motion changes. `way` grows by the most that any two points of cloth may have come nearer.
struct SelfState {
  double travel = 0;                       // m
  double speed = 0;                        // m/s, of any two particles against each other, at most
  double searched = 0, margin = 0;         // m: pairs were searched at this way, this much beyond the layer
  std::shared_ptr<const SelfPairs> pairs;  // that were near then
  std::vector<double> active_after_travel,
      block_active_after_travel;  // [pairs], [blocks] way until which they do not touch
  std::vector<SelfHold> hold;     // by their pairs, points first
};

}  // namespace drape::model
