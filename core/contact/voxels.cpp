#include "contact/voxels.h"

#include <algorithm>
#include <cmath>

#include "constraint/vector3.h"
#include "contact/nearest.h"

namespace drape {
namespace {

using namespace vector3;

constexpr double kFiner = 4;         // a voxel's size over that of the next level
constexpr double kEdges = 2;         // a smallest voxel over the mean edge
constexpr double kRounding = 1e-12;  // of the distance
const double kHalfDiagonal = std::sqrt(3.0) / 2;

// Voxels from -2^20 to 2^20 along each axis, which at 1 mm is a kilometre; beyond, places share voxels' names
// with others and are asked about without being remembered.
constexpr double kMost = 1 << 20;

bool voxel_name(const Vec3& x, double size, std::uint64_t& name, Vec3& centre) {
  name = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double cell = std::floor(x[k] / size);
    if (!(std::abs(cell) < kMost)) return false;
    name = name << 21 | std::uint64_t(std::int64_t(cell) + std::int64_t(kMost));
    centre[k] = (cell + 0.5) * size;
  }
  return true;
}

Voxel voxel_ask(const Voxels& v, int level, const Vec3& centre) {
  Voxel voxel;
  const double half = kHalfDiagonal * v.size[level];
  if (level + 1 < kVoxelLevels) {
    voxel.distance = v.library->distance(v.query, centre.data(), nullptr) * (1 - kRounding);
    voxel.far = voxel.distance > half + v.size[level] / kFiner;
    return voxel;
  }
  std::vector<int> room(64);
  for (;;) {
    const std::size_t count =
        v.library->within(v.query, centre.data(), half + v.reach, room.data(), room.size());
    const bool all = count <= room.size();
    room.resize(count);
    if (all) break;
  }
  voxel.triangle = std::move(room);
  voxel.far = voxel.triangle.empty();
  voxel.distance = half + v.reach;
  return voxel;
}

}  // namespace

Voxels voxels_make(const drape_contact_library& library, const drape_query& query, const BodySurface& surface,
                   double reach) {
  Voxels v;
  v.library = &library;
  v.query = &query;
  v.reach = reach;
  double size = std::max(kEdges * surface.edge_mean, 2 * reach);
  for (int level = kVoxelLevels - 1; level >= 0; --level, size *= kFiner) v.size[level] = size;
  return v;
}

namespace {

// The voxel that decides about x; null where none is kept.
struct Found {
  Voxel* voxel;
  int level;
  Vec3 centre;
};
Found voxel_at(Voxels& v, const Vec3& x) {
  for (int level = 0; level < kVoxelLevels; ++level) {
    std::uint64_t name = 0;
    Vec3 centre{};
    if (!voxel_name(x, v.size[level], name, centre)) break;
    auto known = v.known[level].find(name);
    if (known == v.known[level].end())
      known = v.known[level].emplace(name, voxel_ask(v, level, centre)).first;
    if (known->second.far || level + 1 == kVoxelLevels) return {&known->second, level, centre};
  }
  return {nullptr, 0, {}};
}

double signed_distance(const Voxels& v, const BodySurface& surface, const Vec3& x) {
  int triangle = 0;
  v.library->distance(v.query, x.data(), &triangle);
  return nearest_signed(surface, triangle, x);
}

}  // namespace

Neighbourhood voxels_at(Voxels& v, const Vec3& x) {
  const Found found = voxel_at(v, x);
  if (!found.voxel) return {v.library->distance(v.query, x.data(), nullptr) * (1 - kRounding), nullptr};
  if (found.voxel->far) return {found.voxel->distance - norm(x - found.centre), nullptr};
  return {0, &found.voxel->triangle};
}

double voxels_depth(Voxels& v, const BodySurface& surface, const Vec3& x) {
  if (!surface.solid) return 0;
  const Found found = voxel_at(v, x);
  if (found.voxel && found.voxel->far) {
    int& side = found.voxel->side;
    if (side == 0) side = signed_distance(v, surface, found.centre) < 0 ? -1 : 1;
    if (side > 0) return 0;
  }
  return std::max(-signed_distance(v, surface, x), 0.0);
}

}  // namespace drape
