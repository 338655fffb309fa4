// Self contact: the surface of the cloth, constant after assembly, and the state of its contact.
// core/README.md, section 8.
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

// Columns and rows of a lattice: low[0] .. high[0] and low[1] .. high[1].
struct SelfBox {
  int low[2], high[2];
};

// An edge, and the corners opposite to it in its one or two triangles.
struct SelfEdge {
  NodeIndex node[2];
  NodeIndex across[2];  // kNoNode where there is no triangle
  SelfBox box;
};

// A cell of the cloth as the triangles a b d and a d c.
struct SelfCell {
  NodeIndex node[4];  // corners a, b, c, d
  int lattice, i, j;
  int node_first, node_end;  // range in SelfMesh::own_node; each particle belongs to one cell
  int edge_first, edge_end;  // range in SelfMesh::edge; each edge belongs to one cell
  int seam_first, seam_end;  // range in SelfMesh::near_seam
};

struct NearSeam {
  int place;        // number of a sewn point of the cloth: all pairs of seams that meet there share it
  double distance;  // m along the cloth, from the cell's centre
};

struct NodeSpan {
  std::size_t begin, end;
};

// Constant after assembly. Has no cells in a scene without self contact.
struct SelfMesh {
  std::vector<SelfCell> cell;
  std::vector<NodeIndex> own_node;
  std::vector<SelfEdge> edge;
  std::vector<NearSeam> near_seam;
  std::vector<NodeSpan> span;         // runs of particles of one piece in the arrays of nodes
  std::vector<int> lattice_of;        // [nodes]
  std::vector<char> fixed;            // [nodes] 1 where a pin holds it
  Array max_contact_distance;         // [nodes] m: bound, where it starts within the thickness; else infinite
  std::vector<char> parts;            // [nodes] 1 where the bound grows to the thickness: it lies over cloth
  std::vector<NodeIndex> same_place;  // particles that start in the very place of other cloth
  std::vector<SelfBox> box;           // [nodes]
  std::vector<int> exclusion_cells;   // [lattices] what is fewer cells apart along the cloth does not touch
  std::vector<double> min_protrusion_sine;  // [lattices] sine from which an edge protrudes: narrow_phase.cpp
  double seam_exclusion_distance = 0;       // m, exclusion along the cloth across a seam
  double contact_distance = 0;              // m, the largest of all pairs
  double min_cell = 0;                      // m, smallest cell size
};

// A pair of a particle and a triangle.
struct SelfPoint {
  NodeIndex node[4];        // particle, corners of the triangle
  double contact_distance;  // m: the mean thickness, or the distance at the start where that stays smaller
  double start;             // m: the same at the start
};
// A pair of two edges.
struct SelfCross {
  NodeIndex node[4];
  NodeIndex edge[2];               // indices in SelfMesh::edge
  double contact_distance, start;  // m
};
struct SelfPairs {
  std::vector<SelfPoint> point;  // sorted by their nodes
  std::vector<SelfCross> cross;  // likewise
  std::size_t size() const { return point.size() + cross.size(); }
};

// The friction force of a pair in the last step.
struct SelfHold {
  std::array<NodeIndex, 4> node;
  bool cross, sticks;
  Vec3 force;  // N
};

inline constexpr std::size_t kPairsPerBlock = 32;  // pairs

// The state of self contact. In each step, `travel` grows by an upper bound of how much nearer any two points
// of the cloth have come, `shape_travel` by the same of two points of one piece.
struct SelfState {
  double age = 0;                          // s, since the start, while layers that started too near part
  double travel = 0;                       // m
  double speed = 0;                        // m/s, upper bound of the relative speed of any two particles
  double shape_travel = 0;                 // m
  double searched = 0;                     // m, travel at the last search for pairs
  double margin = 0;                       // m, margin of that search beyond the contact distance
  std::shared_ptr<const SelfPairs> pairs;  // pairs that search found
  std::vector<double> active_after_travel,
      block_active_after_travel;  // [pairs], [blocks] m, travel up to which they cannot touch
  std::vector<double>
      level_until;             // [edges] m, shape_travel up to which it cannot protrude; infinite: it may
  std::vector<SelfHold> hold;  // in the order of their pairs, points first
};

}  // namespace drape::model
