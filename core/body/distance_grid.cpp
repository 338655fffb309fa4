#include "body/distance_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <new>
#include <numbers>

#include "body/closest_features.h"
#include "math/vector3.h"

namespace drape::body {
namespace {

using namespace math::vector3;

constexpr double kFiner = 4;         // size of a voxel over that of the next level
constexpr double kEdges = 2;         // size of the smallest voxels over the mean edge length
constexpr double kRounding = 1e-12;  // relative, of the distance
constexpr std::uint64_t kSpread = 0x9E3779B97F4A7C15;  // hash multiplier: 2^64 over the golden ratio
constexpr int kSpreadShift = 64 - std::countr_zero(kVoxelsRecent);
const double kHalfDiagonal = std::numbers::sqrt3 / 2;

// Voxel indices run from -2^20 to 2^20 along each axis; at 1 mm that is a kilometre. Points beyond have no
// unique voxel name and are queried without a cache.
constexpr double kMaxIndex = 1 << 20;

bool voxel_name(const Vec3& x, double size, std::uint64_t& name, Vec3& centre) {
  name = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double cell = std::floor(x[k] / size);
    if (!(std::abs(cell) < kMaxIndex)) return false;
    name = name << 21 | std::uint64_t(std::int64_t(cell) + std::int64_t(kMaxIndex));
    centre[k] = (cell + 0.5) * size;
  }
  return true;
}

double half_diagonal(const DistanceGrid& grid, int level) { return kHalfDiagonal * grid.size[level]; }

// The queries of the contact library, which fail where there is not enough memory.
double query_distance(const DistanceGrid& grid, const Vec3& x, int* triangle) {
  const double distance = grid.library->distance(grid.query, x.data(), triangle);
  if (std::isnan(distance) && std::isfinite(x[0] + x[1] + x[2])) throw std::bad_alloc();
  return distance;
}
std::size_t query_within(const DistanceGrid& grid, const Vec3& x, double radius, std::vector<int>& triangle) {
  const std::size_t count =
      grid.library->within(grid.query, x.data(), radius, triangle.data(), triangle.size());
  if (count == SIZE_MAX) throw std::bad_alloc();
  return count;
}

// Makes a voxel of the largest size.
Voxel voxel_query(const DistanceGrid& grid, const Vec3& centre) {
  Voxel voxel;
  voxel.distance = query_distance(grid, centre, nullptr) * (1 - kRounding);
  voxel.far = voxel.distance > half_diagonal(grid, 0) + grid.size[0] / kFiner;
  if (voxel.far) return voxel;
  voxel.distance = half_diagonal(grid, 0) + grid.reach;
  voxel.triangle.resize(grid.surface->corner.size());
  voxel.triangle.resize(query_within(grid, centre, voxel.distance, voxel.triangle));
  voxel.triangle.shrink_to_fit();
  return voxel;
}

// Makes a voxel at `centre` from the triangles of the larger voxel that contains it, at `middle`.
Voxel voxel_subdivide(const DistanceGrid& grid, int level, const Voxel& whole, const Vec3& middle,
                      const Vec3& centre) {
  Voxel voxel;
  const double listed = half_diagonal(grid, level) + grid.reach;
  double clear = whole.distance * (1 - kRounding) - norm(centre - middle);
  for (int t : whole.triangle) {
    const Facet& f = grid.surface->facet[std::size_t(t)];
    const Vec3 d = centre - f.middle;
    const double far = f.radius + std::max(listed, clear);
    if (dot(d, d) > far * far) continue;
    const double distance = closest_features_distance(*grid.surface, t, centre);
    clear = std::min(clear, distance);
    if (distance <= listed) voxel.triangle.push_back(t);
  }
  voxel.far = level + 1 < kVoxelLevels ? clear > half_diagonal(grid, level) + grid.size[level] / kFiner
                                       : voxel.triangle.empty();
  voxel.distance = voxel.far ? clear * (1 - kRounding) : listed;
  return voxel;
}

}  // namespace

DistanceGrid distance_grid_make(const drape_contact_library& library, const drape_query& query,
                                const BodySurface& surface, double reach) {
  DistanceGrid grid;
  grid.library = &library;
  grid.query = &query;
  grid.surface = &surface;
  grid.recent = std::make_unique<DistanceGrid::Recent[]>(kVoxelsRecent);
  grid.reach = reach;
  double size = std::max(kEdges * surface.edge_mean, 2 * reach);
  for (int level = kVoxelLevels - 1; level >= 0; --level, size *= kFiner) grid.size[level] = size;
  return grid;
}

namespace {

// The voxel that contains x: the first far one, or that of the smallest size. Null beyond the largest index.
struct Found {
  Voxel* voxel;
  Vec3 centre;
};
Found voxel_at(DistanceGrid& grid, const Vec3& x) {
  constexpr int kLast = kVoxelLevels - 1;
  std::uint64_t last = 0;
  Vec3 centre{}, above{};
  if (!voxel_name(x, grid.size[kLast], last, centre)) return {nullptr, {}};
  DistanceGrid::Recent& recent = grid.recent[last * kSpread >> kSpreadShift];
  if (recent.voxel && recent.name == last) return {recent.voxel, centre};
  Voxel* whole = nullptr;
  for (int level = 0; level < kVoxelLevels; ++level) {
    std::uint64_t name = 0;
    voxel_name(x, grid.size[level], name, centre);
    const auto [at, fresh] = grid.known[level].try_emplace(name);
    if (fresh)
      at->second =
          level == 0 ? voxel_query(grid, centre) : voxel_subdivide(grid, level, *whole, above, centre);
    whole = &at->second;
    above = centre;
    if (whole->far) break;
    if (level == kLast) recent = {name, whole};
  }
  return {whole, centre};
}

double signed_distance(const DistanceGrid& grid, const Vec3& x) {
  int triangle = 0;
  query_distance(grid, x, &triangle);
  return closest_features_signed(*grid.surface, triangle, x);
}

}  // namespace

Neighbourhood distance_grid_at(DistanceGrid& grid, const Vec3& x) {
  const Found found = voxel_at(grid, x);
  if (!found.voxel) return {query_distance(grid, x, nullptr) * (1 - kRounding), nullptr, 0};
  if (found.voxel->far) return {found.voxel->distance - norm(x - found.centre), nullptr, 0};
  return {0, &found.voxel->triangle, found.voxel->distance * (1 - kRounding) - norm(x - found.centre)};
}

double distance_grid_depth(DistanceGrid& grid, const Vec3& x) {
  if (!grid.surface->solid) return 0;
  const Found found = voxel_at(grid, x);
  if (found.voxel && found.voxel->far) {
    int& side = found.voxel->side;
    if (side == 0) side = signed_distance(grid, found.centre) < 0 ? -1 : 1;
    if (side > 0) return 0;
  }
  return std::max(-signed_distance(grid, x), 0.0);
}

}  // namespace drape::body
