#include "reference/contact.h"

#include <cmath>
#include <stdexcept>

#include "body/library.h"
#include "piece/grid/grid.h"

namespace drape::reference {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

Obstacle obstacle_of(const scene::BodySpec& body) {
  const std::string name = "body." + body.name;
  if (body.moves) throw std::runtime_error(name + " moves; the reference takes bodies that stay");
  std::string trouble;
  const std::shared_ptr<const drape_contact_library> library = body::contact_library(trouble);
  if (!library) throw std::runtime_error(trouble);
  char text[256];
  drape_mesh_file* mesh = library->mesh_read(body.mesh.c_str(), text, sizeof text);
  if (!mesh) throw std::runtime_error(name + ".mesh " + text);
  Obstacle o;
  o.damping = body.damping;
  const Eigen::Quaterniond turn =
      Eigen::Quaterniond(body.orientation[0], body.orientation[1], body.orientation[2], body.orientation[3])
          .normalized();
  const Vector3d origin(body.position[0], body.position[1], body.position[2]);
  for (std::size_t k = 0; k < mesh->points; ++k)
    o.point.push_back(origin + turn * (body.scale * Eigen::Map<const Vector3d>(mesh->point + 3 * k)));
  for (std::size_t t = 0; t < mesh->triangles; ++t)
    o.corner.push_back({mesh->corner[3 * t], mesh->corner[3 * t + 1], mesh->corner[3 * t + 2]});
  library->mesh_free(mesh);
  return o;
}

// W^2 = [4 (max p'(0) + g'(0))/(rho b^2) + 32 B/(rho b^4)]/20
double stiffness(const Scene& scene, const scene::FabricSpec& f, double b) {
  const auto slope = [](const Law& law) { return law.curve.e.empty() ? 0.0 : curve_slope(law.curve, 0); };
  const double along = std::max(slope(yarn_law(scene, f, f.warp, b)), slope(yarn_law(scene, f, f.weft, b)));
  const double B = std::max(f.bending_warp, f.bending_weft) / (1 - f.poisson * f.poisson);
  const double b2 = b * b;
  return (4 * (along + slope(bias_law(scene, f, b))) / b2 + 32 * B / (b2 * b2)) / f.areal_density / 20;
}

Vector3d on_segment(const Vector3d& a, const Vector3d& b, const Vector3d& x) {
  const double t = (x - a).dot(b - a) / (b - a).squaredNorm();
  return a + std::min(std::max(t, 0.0), 1.0) * (b - a);
}

Vector3d on_triangle(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& x) {
  const Vector3d n = (b - a).cross(c - a);
  const auto left = [&](const Vector3d& p, const Vector3d& q) { return (q - p).cross(x - p).dot(n) >= 0; };
  if (left(a, b) && left(b, c) && left(c, a)) return x - (x - a).dot(n) / n.squaredNorm() * n;
  const Vector3d sides[] = {on_segment(a, b, x), on_segment(b, c, x), on_segment(c, a, x)};
  const Vector3d* best = sides;
  for (const Vector3d& p : sides)
    if ((x - p).norm() < (x - *best).norm()) best = &p;
  return *best;
}

Vector3d nearest(const Obstacle& o, const Vector3d& x) {
  Vector3d best = o.point[0];
  for (const auto& c : o.corner) {
    const Vector3d p =
        on_triangle(o.point[std::size_t(c[0])], o.point[std::size_t(c[1])], o.point[std::size_t(c[2])], x);
    if ((x - p).norm() < (x - best).norm()) best = p;
  }
  return best;
}

// Visits each particle within its contact distance: visit(body, particle, law, depth, outward direction).
template <class Visit>
void contacts_visit(const Lattice& lattice, const Contact& contact, const VectorXd& r, Visit visit) {
  for (const Obstacle& o : contact.bodies)
    for (int n = 0; n < lattice.count; ++n) {
      const Vector3d x = r.segment<3>(3 * n), away = x - nearest(o, x);
      const Skin& skin = contact.skin[std::size_t(n)];
      const double depth = skin.contact_distance - away.norm();
      if (depth > 0) visit(o, n, skin, depth, Vector3d(away.normalized()));
    }
}

}  // namespace

Contact contact_make(const Scene& scene) {
  Contact contact;
  if (scene.self_contact)
    throw std::runtime_error(
        "scene.self_contact = true; the reference takes scenes whose cloth does not touch itself: false");
  if (scene.bodies.empty()) return contact;
  for (const scene::BodySpec& body : scene.bodies) contact.bodies.push_back(obstacle_of(body));
  for (std::size_t p = 0; p < scene.pieces.size(); ++p) {
    const scene::FabricSpec& f = scene.fabrics[std::size_t(scene.pieces[p].fabric)];
    for (const scene::BodySpec& body : scene.bodies)
      if ((body.friction[0] < 0 ? f.friction : body.friction) != Vec2{0, 0})
        throw std::runtime_error("body." + body.name +
                                 " has friction; the reference takes bodies without: body.friction = 0");
    const piece::Grid grid = piece::grid_make(scene, int(p));
    const Skin skin{f.thickness / 2, std::sqrt(stiffness(scene, f, scene.pieces[p].cell))};
    for (double area : grid.area)
      if (area > 0) contact.skin.push_back(skin);
  }
  return contact;
}

double add_contact(const Lattice& lattice, const Contact& contact, const VectorXd& r, const VectorXd& v,
                   VectorXd& F) {
  double dissipated = 0;
  contacts_visit(lattice, contact, r,
                 [&](const Obstacle& o, int n, const Skin& skin, double depth, const Vector3d& out) {
                   const double blend = skin.contact_distance / 8, t = std::min(depth / blend, 1.0),
                                slope = 3 * t * t - 2 * t * t * t;
                   const double phi = blend * (t * t * t - t * t * t * t / 2) + std::max(depth - blend, 0.0);
                   const double speed = v.segment<3>(3 * n).dot(out);
                   const double penalty = skin.omega * skin.omega * phi,
                                pushed = std::max(penalty - 2 * o.damping * skin.omega * slope * speed, 0.0);
                   const double m = lattice.mass[std::size_t(n)];
                   F.segment<3>(3 * n) += m * pushed * out;
                   dissipated -= m * (pushed - penalty) * speed;
                 });
  return dissipated;
}

double contact_energy(const Lattice& lattice, const Contact& contact, const VectorXd& r) {
  double sum = 0;
  contacts_visit(
      lattice, contact, r, [&](const Obstacle&, int n, const Skin& skin, double depth, const Vector3d&) {
        const double blend = skin.contact_distance / 8, t = std::min(depth / blend, 1.0),
                     on = std::max(depth - blend, 0.0);
        const double phi =
            blend * blend * (t * t * t * t / 4 - t * t * t * t * t / 10) + on * blend / 2 + on * on / 2;
        sum += lattice.mass[std::size_t(n)] * skin.omega * skin.omega * phi;
      });
  return sum;
}

ContactSummary contact_summary(const Lattice& lattice, const Contact& contact, const VectorXd& r) {
  ContactSummary found;
  contacts_visit(lattice, contact, r, [&](const Obstacle&, int, const Skin&, double depth, const Vector3d&) {
    ++found.count;
    found.depth = std::max(found.depth, depth);
  });
  return found;
}

}  // namespace drape::reference
