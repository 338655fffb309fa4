// Vectors at nodes, coordinate by coordinate.
#pragma once
#include <cstddef>

#include "math/vector3.h"

namespace drape::model {

// [nodes] each.
struct Field {
  double *x, *y, *z;
};

inline Vec3 at(const Field& f, std::size_t n) { return {f.x[n], f.y[n], f.z[n]}; }
inline void set(const Field& f, std::size_t n, const Vec3& v) { f.x[n] = v[0], f.y[n] = v[1], f.z[n] = v[2]; }

}  // namespace drape::model
