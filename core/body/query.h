/* The interface of the contact library: a separate shared object that the core opens for scenes with a body.
 * The library reads meshes and finds the triangles near a point. The core does everything else about contact.
 *
 * No exception leaves the library: it has a C++ runtime of its own. Where there is not enough memory, a
 * function returns its failure value.
 */
#ifndef DRAPE_CONTACT_QUERY_H
#define DRAPE_CONTACT_QUERY_H

#include <stddef.h>

#ifdef __cplusplus
#define DRAPE_CONTACT_NOEXCEPT noexcept
extern "C" {
#else
#define DRAPE_CONTACT_NOEXCEPT
#endif

/* The triangles of a mesh file; polygons are divided into triangles. */
typedef struct drape_mesh_file {
  size_t points;
  double* point; /* [points x 3], in the unit of the file */
  size_t triangles;
  int* corner; /* [triangles x 3] point numbers, from 0 */
} drape_mesh_file;

typedef struct drape_query drape_query;

typedef struct drape_contact_library {
  /* Reads an OBJ or STL file; its name is in UTF-8. Returns NULL on failure and writes the reason to
   * `problem` [capacity]. */
  drape_mesh_file* (*mesh_read)(const char* file, char* problem, size_t capacity)DRAPE_CONTACT_NOEXCEPT;
  void (*mesh_free)(drape_mesh_file*) DRAPE_CONTACT_NOEXCEPT;
  /* Copies the triangles. Returns NULL where there is not enough memory. */
  drape_query* (*query_make)(const double* point, size_t points, const int* corner,
                             size_t triangles)DRAPE_CONTACT_NOEXCEPT;
  void (*query_free)(drape_query*) DRAPE_CONTACT_NOEXCEPT;
  /* The distance from a point to the closest triangle. `triangle` gets its number, unless it is NULL.
   * Returns NaN on failure. */
  double (*distance)(const drape_query*, const double at[3], int* triangle) DRAPE_CONTACT_NOEXCEPT;
  /* Finds the triangles that intersect a ball. Returns their number; writes the first `capacity` of them to
   * `triangle`, sorted. Returns SIZE_MAX on failure. */
  size_t (*within)(const drape_query*, const double at[3], double radius, int* triangle,
                   size_t capacity) DRAPE_CONTACT_NOEXCEPT;
} drape_contact_library;

#ifdef _WIN32
#define DRAPE_CONTACT_EXPORT __declspec(dllexport)
#define DRAPE_CONTACT_FILE "drape_contact.dll"
#else
#define DRAPE_CONTACT_EXPORT __attribute__((visibility("default")))
#define DRAPE_CONTACT_FILE "libdrape_contact.so"
#endif

/* The only exported symbol of the library. Its number is the version of this interface. */
DRAPE_CONTACT_EXPORT const drape_contact_library* drape_contact_library_2(void) DRAPE_CONTACT_NOEXCEPT;

#ifdef __cplusplus
}
#endif
#endif
