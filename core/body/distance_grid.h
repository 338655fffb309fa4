// What is near a place of a body, remembered by voxels: the contact library is asked once about each large
// one.
//
// Space is divided into voxels of three sizes. A voxel far from the surface holds the distance d of its
// centre: any place x in it is at least d - |x - centre| away. One near the surface holds the triangles that
// a place in it can have within `reach`, out of those of the larger one that it is in. Answers depend on the
// place alone, never on what was asked before.
#pragma once
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "body/query.h"
#include "body/surface.h"

namespace drape::body {

struct Voxel {
  double distance = 0;  // m, of the centre, at least; where there are triangles, within which all are listed
  bool far = false;     // nothing is within `reach` of any place in it: all of it is on one side
  int side = 0;         // of a far voxel: 1 outside, -1 inside, 0 not asked yet
  std::vector<int> triangle;  // of a voxel that is near
};

inline constexpr int kVoxelLevels = 3;
inline constexpr std::size_t kVoxelsRecent = 256;
struct DistanceGrid {
  const drape_contact_library* library = nullptr;
  const drape_query* query = nullptr;
  const BodySurface* surface = nullptr;
  double size[kVoxelLevels]{};  // m, largest first
  double reach = 0;             // m
  std::unordered_map<std::uint64_t, Voxel> known[kVoxelLevels];
  struct Recent {
    std::uint64_t name = 0;
    Voxel* voxel = nullptr;
  };
  std::unique_ptr<Recent[]> recent;  // [kVoxelsRecent] smallest voxels asked for last, by their names
};

// `reach`: how near a triangle must be to be listed.
DistanceGrid distance_grid_make(const drape_contact_library& library, const drape_query& query,
                                const BodySurface& surface, double reach);

// How far at least x is from the surface; 0: look at the triangles.
struct Neighbourhood {
  double clearance;                  // m
  const std::vector<int>* triangle;  // all within `listed` of x, at least those within reach; or null
  double listed;                     // m
};
Neighbourhood distance_grid_at(DistanceGrid& voxels, const Vec3& x);

// How deep x is inside a solid surface (m), about; 0: it is not.
double distance_grid_depth(DistanceGrid& voxels, const Vec3& x);

}  // namespace drape::body
