// A cache of the distance from points to the surface of a body, and of the triangles near them. The cache is
// a hierarchy of voxels. The contact library is queried only once for each voxel of the largest size.
//
// Space is divided into voxels of three sizes. A voxel far from the surface stores the distance d of its
// centre: any point x in it is at least d - |x - centre| away from the surface. A voxel near the surface
// stores the triangles that can be within `reach` of a point in it, selected from those of the larger voxel
// around it. Results depend on the point alone, never on earlier queries.
#pragma once
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "body/query.h"
#include "body/surface.h"

namespace drape::body {

struct Voxel {
  // m. Far voxel: lower bound of the distance of the centre. Near voxel: `triangle` lists all within this.
  double distance = 0;
  bool far = false;  // no triangle is within `reach` of any point of the voxel, so all of it is on one side
  int side = 0;      // of a far voxel: 1 outside, -1 inside, 0 not computed yet
  std::vector<int> triangle;  // of a near voxel
};

inline constexpr int kVoxelLevels = 3;
inline constexpr std::size_t kVoxelsRecent = 256;
struct DistanceGrid {
  const drape_contact_library* library = nullptr;
  const drape_query* query = nullptr;
  const BodySurface* surface = nullptr;
  double size[kVoxelLevels]{};  // m, edge lengths, largest first
  double reach = 0;             // m, distance within which triangles are listed
  std::unordered_map<std::uint64_t, Voxel> known[kVoxelLevels];
  struct Recent {
    std::uint64_t name = 0;
    Voxel* voxel = nullptr;
  };
  std::unique_ptr<Recent[]> recent;  // [kVoxelsRecent] smallest voxels used most recently, hashed by name
};

// Makes an empty grid. Triangles within `reach` (m) of a point are listed. The arguments must outlive the
// grid.
DistanceGrid distance_grid_make(const drape_contact_library& library, const drape_query& query,
                                const BodySurface& surface, double reach);

// The surroundings of a point x.
struct Neighbourhood {
  double clearance;                  // m, lower bound of the distance; 0 where triangles are listed
  const std::vector<int>* triangle;  // all within `listed` of x; null where none is within `reach`
  double listed;                     // m, at least `reach`
};
Neighbourhood distance_grid_at(DistanceGrid& grid, const Vec3& x);

// The depth of x inside a solid surface, m; 0 where x is outside or the surface is not solid.
double distance_grid_depth(DistanceGrid& grid, const Vec3& x);

}  // namespace drape::body
