// Fields, seams and bodies of a cloth for the C interface.
#include <limits>

#include "api/cloth.h"
#include "math/plain_environment.h"
#include "math/vector3.h"
#include "model/elements.h"
#include "model/node_sums.h"

namespace drape::api {
namespace {

using namespace math::vector3;

// R x
Vec3 outward(const model::Mat3& rotation, const Vec3& x) {
  return {dot(rotation[0], x), dot(rotation[1], x), dot(rotation[2], x)};
}

}  // namespace
}  // namespace drape::api

using namespace drape;
using namespace drape::api;

const drape_fields* drape_fields_at(drape_cloth* c) {
  const math::PlainEnvironment plain;
  outputs::fields_fill(c->fields, c->system, c->state,
                       dynamics::leapfrog_stops(c->system, c->motion, c->state));
  c->fields_view = {int(c->fields.area.size()), c->fields.strain.data(), c->fields.tension.data(),
                    c->fields.pressure.data(), c->fields.area.data()};
  return &c->fields_view;
}

drape_elongation drape_elongation_of(drape_cloth* c, int piece, drape_yarn_direction along, double limit) {
  const math::PlainEnvironment plain;
  const model::Lattice& l = c->system.lattices[std::size_t(piece)];
  const math::Curve& curve = model::law_curve(l.law, model::YarnDirection(along));
  if (limit < 0) limit = curve.segments ? curve.last : std::numeric_limits<double>::infinity();
  const outputs::Elongation e =
      outputs::elongation_of(c->system, c->state, l, model::YarnDirection(along), limit);
  return {{e.min, e.max, e.mean}, e.tension_max, limit, e.beyond};
}

drape_seam_lines drape_seam_lines_at(drape_cloth* c, int index) {
  const math::PlainEnvironment plain;
  const model::Seam& seam = c->system.seams.seam[std::size_t(index)];
  for (int side = 0; side < 2; ++side) {
    c->seam_line[side].clear();
    for (std::size_t p = seam.first; p < seam.first + seam.count; ++p) {
      const Vec3 x = model::point_now(c->system.seams.pair[p].side[side], c->state);
      c->seam_line[side].insert(c->seam_line[side].end(), x.begin(), x.end());
    }
  }
  return {int(seam.count), seam.closed, c->seam_line[0].data(), c->seam_line[1].data()};
}

drape_surface drape_surface_at(drape_cloth* c, int index) {
  const math::PlainEnvironment plain;
  const model::Body& body = c->system.bodies[std::size_t(index)];
  const model::BodyContact& now = c->state.body[std::size_t(index)];
  const body::BodySurface& surface = body.mesh.surface;
  c->surface_point.clear();
  for (const Vec3& at : surface.point) {
    const Vec3 x = body.moves ? now.motion.position + outward(now.rotation, at) : at;
    c->surface_point.insert(c->surface_point.end(), x.begin(), x.end());
  }
  return {body.name.c_str(),          body.moves,
          int(surface.point.size()),  c->surface_point.data(),
          int(surface.corner.size()), surface.corner[0].data()};
}
