// What is near a place of a body, remembered by voxels: the contact library is asked once about each.
//
// Space is divided into voxels of three sizes. A large one far from the surface holds the distance d of its
// centre: any place x in it is at least d - |x - centre| away. A smallest one near the surface holds the
// triangles that a place in it can have within `reach`. Answers depend on the place alone, never on what was
// asked before.
#pragma once
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "contact/body_surface.h"
#include "contact/query.h"

namespace drape {

struct Voxel {
  double distance = 0;        // m, of the centre, at least
  bool far = false;           // nothing is within `reach` of any place in it: all of it is on one side
  int side = 0;               // of a far voxel: 1 outside, -1 inside, 0 not asked yet
  std::vector<int> triangle;  // of a smallest voxel that is near
};

inline constexpr int kVoxelLevels = 3;
struct Voxels {
  const drape_contact_library* library = nullptr;
  const drape_query* query = nullptr;
  double size[kVoxelLevels]{};  // m, largest first
  double reach = 0;             // m
  std::unordered_map<std::uint64_t, Voxel> known[kVoxelLevels];
};

// `reach`: how near a triangle must be to be listed.
Voxels voxels_make(const drape_contact_library& library, const drape_query& query, const BodySurface& surface,
                   double reach);

// How far at least x is from the surface; 0: look at the triangles.
struct Neighbourhood {
  double clearance;                  // m
  const std::vector<int>* triangle;  // that may be within reach of x; or null
};
Neighbourhood voxels_at(Voxels& voxels, const Vec3& x);

// How deep x is inside a solid surface (m), about; 0: it is not.
double voxels_depth(Voxels& voxels, const BodySurface& surface, const Vec3& x);

}  // namespace drape
