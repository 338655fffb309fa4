// Finds the links and cells that a sharp edge cuts, or that are too deep in contact, at the start.
#include "body/distance_grid.h"
#include "contact/edge/elements.h"
#include "contact/edge/pairs.h"

namespace drape::contact {
namespace {

using namespace math::vector3;

// Whether the segment a b goes through the triangle p q r: its ends are on both sides of the plane, and the
// corners lie around it.
bool goes_through(const Vec3& a, const Vec3& b, const Vec3& p, const Vec3& q, const Vec3& r) {
  const Vec3 normal = cross(q - p, r - p), along = b - a;
  if (!(dot(a - p, normal) * dot(b - p, normal) < 0)) return false;
  const double u = dot(along, cross(p - a, q - a)), v = dot(along, cross(q - a, r - a)),
               w = dot(along, cross(r - a, p - a));
  return (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
}

bool is_cut(const body::BodySurface& surface, const body::SharpFeature& feature,
            const model::EdgeElement& element, const Vec3* x) {
  if (element.cell || feature.tip) return false;
  for (int t : surface.edges[std::size_t(feature.edge)].triangle) {
    const std::array<int, 3>& c = surface.corner[std::size_t(t)];
    if (goes_through(x[0], x[1], surface.point[std::size_t(c[0])], surface.point[std::size_t(c[1])],
                     surface.point[std::size_t(c[2])]))
      return true;
  }
  return false;
}

}  // namespace

EdgeDepth edge_deepest(const System& system, const State& s, std::size_t b, const model::Lattice& l,
                       body::DistanceGrid& grid) {
  EdgeDepth deep;
  const model::Body& body = system.bodies[b];
  std::uint32_t last = 0xffffffff;  // an element over several features counts once
  for (const model::EdgePair& pair : s.body[b].edges.pair) {
    const model::EdgeElement& element = system.edge_elements.element[pair.element];
    if (element.lattice != l.piece) continue;
    const body::SharpFeature& feature = body.sharp.feature[pair.feature];
    Vec3 x[6], point{0, 0, 0}, at{0, 0, 0};
    edge_element_places(system, s, b, element, x);
    const EdgeGap gap = edge_gap(element, feature, x, edge_sine(l));
    if (!gap.over || !(gap.distance < (1 - kContactDeepest) * l.contact_law.distance)) continue;
    for (int k = 0; k < element.weights(); ++k) {
      const std::size_t n = element.node[k];
      point += gap.weight[k] * x[k];
      at += gap.weight[k] * Vec3{s.x[n], s.y[n], s.z[n]};
    }
    if (gap.distance < 0 && !is_cut(body.mesh.surface, feature, element, x) &&
        !(body::distance_grid_depth(grid, point) > 0))
      continue;  // beyond the body
    const double depth = l.contact_law.distance - gap.distance;
    deep.count += pair.element != last;
    last = pair.element;
    if (depth > deep.depth) deep.depth = depth, deep.at = at;
  }
  return deep;
}

}  // namespace drape::contact
