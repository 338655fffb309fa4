/* What the core asks of the contact library, a shared object of its own that is opened in scenes with a body:
 * it reads meshes and knows which triangles are near a place. Everything else about contact is the core's.
 */
#ifndef DRAPE_CONTACT_QUERY_H
#define DRAPE_CONTACT_QUERY_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Triangles as they stand in a file; polygons are cut into triangles. */
typedef struct drape_mesh_file {
  size_t points;
  double* point; /* [points x 3] */
  size_t triangles;
  int* corner; /* [triangles x 3] counted from 0 */
} drape_mesh_file;

typedef struct drape_query drape_query;

typedef struct drape_contact_library {
  /* Reads an OBJ or STL file. NULL: `problem` [room] says why. */
  drape_mesh_file* (*mesh_read)(const char* file, char* problem, size_t room);
  void (*mesh_free)(drape_mesh_file*);
  /* The triangles are copied. */
  drape_query* (*query_make)(const double* point, size_t points, const int* corner, size_t triangles);
  void (*query_free)(drape_query*);
  /* The distance from a place to the nearest triangle. */
  double (*distance)(const drape_query*, const double at[3], int* triangle);
  /* All triangles that a ball meets: their number; the first `room` of them in `triangle`. */
  size_t (*within)(const drape_query*, const double at[3], double radius, int* triangle, size_t room);
} drape_contact_library;

/* The one symbol of the library. */
__attribute__((visibility("default"))) const drape_contact_library* drape_contact_library_1(void);

#ifdef __cplusplus
}
#endif
#endif
