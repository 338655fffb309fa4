// Bodies and what the cloth knows of them. core/README.md, section 7.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "body/query.h"
#include "body/sharp_edges.h"
#include "body/surface.h"
#include "math/aligned_array.h"
#include "math/rigid_motion.h"

namespace drape::model {

// Rotation matrix, row by row.
using Mat3 = std::array<Vec3, 3>;

// A body's surface in its own frame, and who finds its triangles.
struct BodyMesh {
  body::BodySurface surface;
  const drape_contact_library* library = nullptr;
  std::shared_ptr<drape_query> query;
};

struct Body {
  std::string name;
  BodyMesh mesh;  // of a body that does not move, in space
  bool moves = false;
  bool has_friction = false;  // of its own, in place of the fabric's
  Vec2 friction{0, 0};        // static, kinetic
  double damping = 1;         // of the normal motion while it touches, over the critical one
  math::RigidMotion start;
  body::SharpFeatures sharp;
  std::vector<std::string> remarks;  // what is odd about the mesh, but no fault
};

// How the particles of a lattice touch.
struct ContactLaw {
  double distance = 0;      // m, half the thickness: nearer to a surface, a particle touches it
  double omega2 = 0;        // 1/s^2, stiffness over mass
  Vec2 friction{0.3, 0.3};  // static, kinetic
};

// Eight neighbouring nodes of a lattice and a surface near each: lanes without one have side = 0 and
// offset = -kFar.
inline constexpr double kFar = 1e300;
struct alignas(math::kLine) ContactBlock {
  double side[3][math::kRowUnit];        // unit vector out of the surface, in the body's frame
  double offset[math::kRowUnit];         // m, side . point
  double point[3][math::kRowUnit];       // m
  double shape[6][math::kRowUnit];       // D: xx xy xz yy yz zz
  double sticking[math::kRowUnit];       // 1 where the particle sticks, else 0
  double warm_start[3][math::kRowUnit];  // m/s^2, what a particle that is not alone got in the last step
  double shared[math::kRowUnit];         // 1 where other surfaces are near as well, else 0
  bool flat;                             // every surface in it is a face: D = side side^T
  bool shares;                           // somewhere
  bool has_warm_start;                   // a carry is not 0
  std::size_t node;                      // the first of them
  int lattice;
  bool empty() const {
    for (double o : offset)
      if (o != -kFar) return false;
    return true;
  }
};

// The blocks of a body, by their nodes; a particle in a groove is in several.
struct ContactPlace {
  std::uint32_t node, block;  // the first node, over kRowUnit; its place in the pool
};
struct ContactBlocks {
  std::vector<ContactBlock> pool;
  std::vector<std::uint32_t> free;
  std::vector<ContactPlace> order;
};

// A link or cell of the cloth (a number of RidgeCloth) near a ridge of the body.
struct EdgePair {
  std::uint32_t element, feature;
  bool outside = false;      // known to belong out of the body
  double sticking = 0;       // 1 where it sticks, else 0
  double share = 0;          // of its penalty
  double stored = 0;         // J, of its penalty
  Vec3 warm_start{0, 0, 0};  // N, what it got in the last step
};

// Which pairs are near. `way` grows by the most that any of the nodes moves against the body.
struct EdgeContact {
  std::vector<char> near;            // [nodes] 1: a ridge may be near its links; empty where a body has none
  std::vector<std::uint32_t> fresh;  // nodes near since the pairs were listed
  std::vector<std::uint32_t> node;   // those of all links and cells of near nodes, sorted
  std::vector<Vec3> last,
      from;                    // [of node] m, in the body's frame: where they are; as their parts were listed
  std::vector<EdgePair> pair;  // sorted
  std::vector<double> active_after_travel;  // [pairs] m, way until which they do not touch
  double travel = 0;                        // m
  double reach = 0;                         // m, of the next step
};

// What the motion changes of a body.
struct BodyContact {
  math::RigidMotion motion;  // at t_n
  Mat3 rotation;             // R at t_n
  math::Wrench
      impulse;    // N s, N m s of the cloth on the body in the last advance, but for its last half step
  Array x, y, z;  // [nodes] m, where a particle was when its surroundings were last looked at
  Array free_distance2;  // [nodes] m^2, of the distance that it may move from there; infinite at unused nodes
  Array group_clearance;  // [nodes / kRowUnit] m, that all nodes of a group may still move before one must be
                          // compared with its budget: at the group's first block, where the body stays
  ContactBlocks blocks;
  EdgeContact edges;
};

struct ContactSummary {
  std::size_t count = 0;                 // particles that touch, pairs with ridges that do
  double penetration = 0, pressure = 0;  // m, Pa, the largest
};

}  // namespace drape::model
