// Reads OBJ and STL files as triangles; the functions behind `mesh_read` and `mesh_free` of query.h.
#pragma once
#include "body/query.h"

namespace drape::body {

drape_mesh_file* mesh_read(const char* file, char* problem, size_t capacity) noexcept;
void mesh_free(drape_mesh_file* mesh) noexcept;

}  // namespace drape::body
