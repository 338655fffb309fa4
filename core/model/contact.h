// Bodies, and the state of their contact with the cloth. core/README.md, section 7.
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

// 3 x 3 matrix by rows, here a rotation.
using Mat3 = std::array<Vec3, 3>;

// A body's surface in the body's frame, and the library that queries its triangles.
struct BodyMesh {
  body::BodySurface surface;
  std::shared_ptr<const drape_contact_library> library;
  std::shared_ptr<drape_query> query;
};

struct Body {
  std::string name;
  BodyMesh mesh;                             // a fixed body's frame is space itself
  bool moves = false;                        // its pose is an input
  scene::Drive drive = scene::Drive::kNone;  // what its inputs are; kNone: both, see velocity_given
  bool has_friction = false;  // it has coefficients of its own, which replace those of the fabric
  Vec2 friction{0, 0};        // 1, static, kinetic
  double damping = 1;         // 1, of the normal motion in contact, over the critical damping
  math::RigidMotion start;
  body::SharpFeatures sharp;
  std::vector<std::string> remarks;  // warnings about the mesh
};

// The contact law of a lattice's particles.
struct ContactLaw {
  double distance = 0;  // m, contact distance, half the thickness: a particle nearer to a surface touches it
  double omega2 = 0;    // 1/s^2, penalty stiffness over mass
  Vec2 friction{0.3, 0.3};  // 1, static, kinetic
};

// Eight consecutive nodes of a lattice, each with a nearby point of a body's surface. Lanes without a near
// surface have side = 0 and offset = -kFar.
inline constexpr double kFar = 1e300;
struct alignas(math::kLine) ContactBlock {
  double side[3][math::kRowUnit];        // unit vector out of the surface, in the body's frame
  double offset[math::kRowUnit];         // m, side . point
  double point[3][math::kRowUnit];       // m
  double shape[6][math::kRowUnit];       // D: xx xy xz yy yz zz
  double sink[math::kRowUnit];           // m, how deep a link at the particle may sink in beside it
  double sticking[math::kRowUnit];       // 1 where the particle sticks, else 0
  double warm_start[3][math::kRowUnit];  // m/s^2, response of the last step, where several constraints act
  double shared[math::kRowUnit];         // 1 where further surfaces are near the particle, else 0
  bool flat;                             // every surface in the block is a face: D = side side^T
  bool shares;                           // a lane has shared = 1
  bool has_warm_start;                   // a warm start is not 0
  std::size_t node;                      // the first of the eight nodes
  int lattice;
  bool empty() const {
    for (double o : offset)
      if (o != -kFar) return false;
    return true;
  }
};

// The blocks of a body, sorted by node. A particle in a groove is in several blocks.
struct ContactPlace {
  std::uint32_t node, block;  // first node divided by kRowUnit; index in the pool
};
struct ContactBlocks {
  std::vector<ContactBlock> pool;
  std::vector<std::uint32_t> free;  // indices of unused blocks in the pool
  std::vector<ContactPlace> order;
};

// A link or cell of the cloth (an index in EdgeElements) near a sharp feature of the body.
struct EdgePair {
  std::uint32_t element, feature;
  bool outside = false;      // known to belong outside the body
  double sticking = 0;       // 1 where it sticks, else 0
  double share = 0;          // 1, of its penalty
  double stored = 0;         // J, of its penalty
  Vec3 warm_start{0, 0, 0};  // N, response of the last step
};

// Nearby pairs. In each step, `travel` grows by the largest displacement of a node relative to the body.
struct EdgeContact {
  std::vector<char> near;  // [nodes] 1: a sharp feature may be near its links; empty without features
  std::vector<std::uint32_t> fresh;  // nodes that came near since the pairs were listed
  std::vector<std::uint32_t> node;   // nodes of all links and cells of near nodes, sorted
  std::vector<Vec3> last, from;      // [node] m, in the body's frame: now; when their elements were listed
  std::vector<EdgePair> pair;        // sorted
  std::vector<double> active_after_travel;  // [pairs] m, travel up to which the pair cannot touch
  double travel = 0;                        // m
  double reach = 0;                         // m, of the next step
};

// The state of a body and of its contact with the cloth.
struct BodyContact {
  math::RigidMotion motion;     // at t_n
  Mat3 rotation;                // R at t_n
  bool velocity_given = false;  // without a stated drive: its velocity has been an input other than 0
  math::Wrench
      impulse;    // N s, N m s, of the cloth on the body in the last advance, without its last half step
  Array x, y, z;  // [nodes] m, a particle's position when its neighbours were last updated
  Array free_distance2;   // [nodes] m^2, square of its free distance: how far it may move from there before
                          // its neighbours must be updated; infinite at unused nodes
  Array group_clearance;  // [nodes / kRowUnit] m: how far all nodes of a group may still move before one must
                          // be compared with its free distance; at the group's first block, for a fixed body
  ContactBlocks blocks;
  EdgeContact edges;
};

struct ContactSummary {
  std::size_t count = 0;                 // particles and pairs with sharp features that touch
  double penetration = 0, pressure = 0;  // m, Pa, the largest values
};

}  // namespace drape::model
