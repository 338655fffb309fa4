#include "assembly/bodies.h"

#include <cmath>

#include "body/library.h"
#include "math/vector3.h"
#include "scene/diagnostics.h"
#include "scene/files.h"

namespace drape::assembly {
namespace {

using namespace math::vector3;

constexpr double kSmallest = 0.005, kLargest = 20;  // m; a body of another size is probably in another unit

Vec3 posed(const math::RigidMotion& frame, const Vec3& x) {
  return frame.position + x + math::rotation_displacement(frame.orientation, x);
}

// Reads the triangles of a file and scales them. A fixed body is put at its pose, in space.
bool mesh_load(const scene::BodySpec& spec, const math::RigidMotion& frame,
               const drape_contact_library& library, std::vector<Vec3>& point,
               std::vector<std::array<int, 3>>& corner, std::string& trouble) {
  trouble = scene::file_hindrance(scene::path_of(spec.mesh), scene::kMaxData);
  if (!trouble.empty()) return false;
  char text[512];
  drape_mesh_file* mesh = library.mesh_read(spec.mesh.c_str(), text, sizeof text);
  if (!mesh) return trouble = text, false;
  for (std::size_t k = 0; k < mesh->points; ++k) {
    const double* p = mesh->point + 3 * k;
    const Vec3 x = spec.scale * Vec3{p[0], p[1], p[2]};
    point.push_back(spec.moves ? x : posed(frame, x));
  }
  for (std::size_t t = 0; t < mesh->triangles; ++t)
    corner.push_back({mesh->corner[3 * t], mesh->corner[3 * t + 1], mesh->corner[3 * t + 2]});
  library.mesh_free(mesh);
  return true;
}

void findings_report(const std::string& path, const body::BodySurface& surface,
                     const body::SurfaceFindings& found, std::vector<std::string>& remarks) {
  const auto report = [&](std::size_t count, const char* what) {
    if (count > 0) remarks.push_back(path + ".mesh has " + std::to_string(count) + what);
  };
  const std::size_t bad = found.open + found.crowded + found.turned;
  report(found.degenerate, " triangles without area, which are left out");
  if (bad > 0)
    report(bad, surface.solid
                    ? " edges that do not join two triangles that face alike; it is taken as closed"
                    : " edges that do not join two triangles that face alike; it is taken as a sheet with "
                      "two sides, which has no inside");
  if (surface.size < kSmallest || surface.size > kLargest)
    remarks.push_back(path + ".scale makes the body " + scene::number_text(surface.size) +
                      " m across; usual: " + scene::number_text(kSmallest) + " to " +
                      scene::number_text(kLargest) + " m; is the mesh in another unit?");
}

}  // namespace

std::vector<model::Body> bodies_make(const Scene& scene, std::vector<Problem>& problems) {
  std::vector<model::Body> bodies;
  for (const scene::BodySpec& spec : scene.bodies) {
    const std::string path = "body." + spec.name;
    std::string trouble;
    const std::shared_ptr<const drape_contact_library> library = body::contact_library(trouble);
    if (!library) {
      problems.push_back({path, "needs the contact library: " + trouble});
      return bodies;
    }
    model::Body& body = bodies.emplace_back();
    body.name = spec.name;
    body.moves = spec.moves;
    body.drive = spec.drive;
    body.has_friction = spec.friction[0] >= 0;
    body.friction = spec.friction;
    body.damping = spec.damping;
    body.start.position = spec.position;
    body.start.orientation = math::quaternion_normalised(spec.orientation);
    std::vector<Vec3> point;
    std::vector<std::array<int, 3>> corner;
    body::SurfaceFindings findings;
    if (mesh_load(spec, body.start, *library, point, corner, trouble))
      body.mesh.surface = body::surface_make(point, corner, findings, trouble);
    if (!trouble.empty()) {
      problems.push_back({path + ".mesh", "= " + scene::in_quotes(spec.mesh) + " " + trouble});
      continue;
    }
    const body::BodySurface& s = body.mesh.surface;
    findings_report(path, s, findings, body.remarks);
    body.mesh.library = library;
    body.mesh.query = {
        library->query_make(s.point[0].data(), s.point.size(), s.corner[0].data(), s.corner.size()),
        [library](drape_query* query) { library->query_free(query); }};
    if (!body.mesh.query) problems.push_back({path + ".mesh", "does not fit in memory"});
  }
  return bodies;
}

}  // namespace drape::assembly
