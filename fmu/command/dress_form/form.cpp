#include "command/dress_form/form.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "command/dress_form/sections.h"
#include "scene/diagnostics.h"

namespace drape::command {
namespace {

constexpr double kReference = 1.66;  // m, the height for which the rounding radii are given

void ring_add(Mesh& mesh, const std::vector<Vec2>& ring, double y, double shrink, double lean) {
  for (const Vec2& p : ring) mesh.vertices.push_back({p[0] * shrink, y, lean + (p[1] - lean) * shrink});
}

// Triangles between neighbouring rings, and from the first and the last ring to a point.
void rings_close(Mesh& mesh, double low, double high) {
  const int rings = int(mesh.vertices.size()) / kAround, last = (rings - 1) * kAround;
  const auto centre = [&](int first, double y) {
    Vec3 c{0, y, 0};
    for (int k = 0; k < kAround; ++k)
      for (std::size_t a : {0, 2}) c[a] += mesh.vertices[std::size_t(first + k)][a] / kAround;
    mesh.vertices.push_back(c);
    return int(mesh.vertices.size()) - 1;
  };
  const int bottom = centre(0, low), top = centre(last, high);
  for (int k = 0; k < kAround; ++k) {
    const int next = (k + 1) % kAround;
    mesh.triangles.push_back({bottom, k, next});
    for (int r = 0; r < last; r += kAround) {
      mesh.triangles.push_back({r + k, r + kAround + k, r + next});
      mesh.triangles.push_back({r + next, r + kAround + k, r + kAround + next});
    }
    mesh.triangles.push_back({top, last + next, last + k});
  }
}

}  // namespace

void measures_check(const Measures& measures, std::vector<Problem>& problems) {
  const auto within = [&](const char* option, double value, double low, double high) {
    if (!(value >= low && value <= high))
      problems.push_back({option, "= " + scene::number_text(value) + " m; allowed: " +
                                      scene::number_text(low) + " to " + scene::number_text(high) + " m"});
  };
  within("--bust", measures.bust, 0.7, 1.5);
  within("--waist", measures.waist, 0.5, 1.4);
  within("--hips", measures.hips, 0.7, 1.6);
  within("--height", measures.height, 1.4, 2.0);
}

Mesh form_make(const Measures& measures) {
  const Torso torso = torso_fit(measures);
  const std::vector<Section>& sections = torso.sections;
  const double tall = measures.height / kReference;
  Mesh mesh;
  const Section &first = sections.front(), &last = sections.back();
  const double rim[3][2] = {
      {-0.012, 0.80}, {-0.0105, 0.93}, {-0.006, 0.985}};  // m down, shrinking: round edges
  for (const auto& [down, shrink] : rim)
    ring_add(mesh, section_ring(first, torso.breasts), first[0] + down * tall, shrink, first[5]);
  for (const Section& s : sections) ring_add(mesh, section_ring(s, torso.breasts), s[0], 1, s[5]);
  const double cap[3][2] = {{0.005, 0.97}, {0.008, 0.85}, {0.010, 0.5}};
  for (const auto& [up, shrink] : cap)
    ring_add(mesh, section_ring(last, torso.breasts), last[0] + up * tall, shrink, last[5]);
  rings_close(mesh, first[0] - 0.012 * tall, last[0] + 0.011 * tall);
  return mesh;
}

std::string mesh_obj(const Mesh& mesh, const std::string& title) {
  std::string text = "# " + title + "\n";
  char line[96];
  for (const Vec3& v : mesh.vertices)
    std::snprintf(line, sizeof line, "v %.7f %.7f %.7f\n", v[0], v[1], v[2]), text += line;
  for (const std::array<int, 3>& t : mesh.triangles)
    std::snprintf(line, sizeof line, "f %d %d %d\n", t[0] + 1, t[1] + 1, t[2] + 1), text += line;
  return text;
}

// Andrew's monotone chain, A. M. Andrew, Information Processing Letters 9(5), 1979.
double tape_length(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end());
  std::vector<Vec2> hull;
  const auto pass = [&](const auto& begin, const auto& end) {
    const std::size_t base = hull.size();
    for (auto p = begin; p != end; ++p) {
      const auto outward = [&] {
        const Vec2 &a = hull[hull.size() - 2], &b = hull.back();
        return (b[0] - a[0]) * ((*p)[1] - a[1]) - (b[1] - a[1]) * ((*p)[0] - a[0]) <= 0;
      };
      while (hull.size() > base + 1 && outward()) hull.pop_back();
      hull.push_back(*p);
    }
    hull.pop_back();  // the other pass begins at this point
  };
  pass(points.begin(), points.end());
  pass(points.rbegin(), points.rend());
  double length = 0;
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const Vec2 &a = hull[k], &b = hull[(k + 1) % hull.size()];
    length += std::hypot(b[0] - a[0], b[1] - a[1]);
  }
  return length;
}

}  // namespace drape::command
