// Sections across the height y, each two half superellipses, with w to the sides, f to the front, b to the
// back and l its lean to the front:
//
//   x = w c |c|^(2/p - 1),   z = l + (f or b) s |s|^(2/p - 1),     c = cos u, s = sin u,
//
// and in front two breasts, z += a max(s, 0)^0.7 exp(-(y - y_b)^2/k^2) sum_(+-) exp(-(x -+ x_b)^2/q^2), which
// are fuller below than above. Between the sections of the table all of y, w, f, b, p, l are natural cubic
// splines (C2) of one parameter, the length of the polygon through the table.
//
// Heights are those of the size table of W. Aldrich, Metric Pattern Cutting for Women's Wear, 5th ed., 2008,
// size 12 (height 166 cm, nape to waist 41, waist to floor 104, waist to hip 20.6, armscye depth 21, body
// rise 28 cm): waist 104/166, hips (104 - 20.6)/166, bust 2.5 cm below the depth of the armscye, (104 + 41 -
// 21 - 2.5)/166. Sections of the three girths are scaled until a tape round them measures the girth; those
// between them by the shares of the table. The shapes themselves are drawn by eye.
#include "form/form.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "form/spline.h"
#include "scene/faults.h"

namespace drape {
namespace {

constexpr int kAround = 72;                               // points of a ring
constexpr double kReference = 1.66;                       // m, height of the body of the table
constexpr double kStepBelow = 0.026, kStepAbove = 0.016;  // m between rings, up to the armholes and above
constexpr int kColumns = 6;                               // y, w, f, b, p, l
using Section = std::array<double, kColumns>;

struct Row {
  Section at;                // y as a share of the height; m for the body of the table
  double bust, waist, hips;  // shares of their scales in that of the section; the rest is the height's
};

constexpr Row kRows[] = {
    {{0.4370, 0.152, 0.096, 0.104, 2.20, -0.004}, 0, 0, 1},       // base
    {{0.4550, 0.161, 0.103, 0.114, 2.20, -0.004}, 0, 0, 1},       // thigh
    {{kHipsHeight, 0.171, 0.110, 0.128, 2.20, -0.004}, 0, 0, 1},  // hips
    {{0.5600, 0.155, 0.106, 0.111, 2.15, -0.003}, 0, 0.5, 0.5},   // high hips
    {{kWaistHeight, 0.122, 0.092, 0.083, 2.10, 0.000}, 0, 1, 0},  // waist
    {{0.6800, 0.132, 0.097, 0.093, 2.10, -0.001}, 0.5, 0.5, 0},   // ribs
    {{kBustHeight, 0.146, 0.099, 0.112, 2.20, -0.003}, 1, 0, 0},  // bust
    {{0.7650, 0.155, 0.093, 0.113, 2.30, -0.005}, 0.7, 0, 0},     // armholes
    {{0.7930, 0.163, 0.080, 0.104, 2.50, -0.008}, 0.5, 0, 0},     // across the back
    {{0.8165, 0.165, 0.060, 0.086, 2.50, -0.010}, 0.4, 0, 0},     // tips of the shoulders
    {{0.8330, 0.138, 0.050, 0.071, 2.30, -0.009}, 0.3, 0, 0},     // shoulders
    {{0.8460, 0.092, 0.046, 0.061, 2.10, -0.007}, 0.3, 0, 0},
    {{0.8600, 0.061, 0.050, 0.055, 2.00, -0.003}, 0.3, 0, 0},  // neck
    {{0.8800, 0.055, 0.052, 0.052, 2.00, 0.003}, 0.3, 0, 0},
    {{0.9000, 0.054, 0.054, 0.050, 2.00, 0.008}, 0.3, 0, 0},
};
constexpr std::size_t kHips = 2, kWaist = 4, kBust = 6, kArmholes = 7;

struct Breasts {
  double y, x, width, height, depth;  // m
};

Breasts breasts_of(double height, double scale) {
  return {kBustHeight * height, 0.086 * scale, 0.056 * scale, 0.062 * scale, 0.037 * scale};
}

// The section at the angle u, in (x, z).
Vec2 section_point(const Section& section, const Breasts& breasts, double u) {
  const auto [y, w, f, b, p, lean] = section;
  const double c = std::cos(u), s = std::sin(u);
  const auto power = [](double v, double e) { return std::copysign(std::pow(std::abs(v), e), v); };
  const double x = w * power(c, 2 / p), above = (y - breasts.y) / breasts.height;
  double z = lean + (s > 0 ? f : b) * power(s, 2 / p);
  if (s > 0) {
    const auto lobe = [&](double at) { return std::exp(-std::pow((x - at) / breasts.width, 2)); };
    const double k = 1 + 0.2 * std::tanh(above);
    z += breasts.depth * std::pow(s, 0.7) * std::exp(-std::pow(above / k, 2)) *
         (lobe(breasts.x) + lobe(-breasts.x));
  }
  return {x, z};
}

std::vector<Vec2> section_ring(const Section& section, const Breasts& breasts) {
  std::vector<Vec2> ring;
  for (int k = 0; k < kAround; ++k)
    ring.push_back(section_point(section, breasts, 2 * std::numbers::pi * k / kAround));
  return ring;
}

Section section_scaled(const Section& row, double height, double scale) {
  return {row[0] * height, row[1] * scale, row[2] * scale,
          row[3] * scale,  row[4],         row[5] * height / kReference};
}

// The scale with which a tape round the section measures `girth`. It grows with the scale: bisection.
double scale_find(std::size_t row, double height, double girth, double bust_scale) {
  double low = 0.1, high = 10;
  for (int k = 0; k < 100; ++k) {
    const double scale = (low + high) / 2;
    const Breasts breasts = breasts_of(height, row == kBust ? scale : bust_scale);
    const bool small =
        tape_length(section_ring(section_scaled(kRows[row].at, height, scale), breasts)) < girth;
    (small ? low : high) = scale;
  }
  return (low + high) / 2;
}

struct Body {
  Breasts breasts;
  std::vector<Section> sections;
};

Body body_fit(const Measures& m) {
  Body body;
  const double bust = scale_find(kBust, m.height, m.bust, 1), tall = m.height / kReference;
  const double waist = scale_find(kWaist, m.height, m.waist, bust);
  const double hips = scale_find(kHips, m.height, m.hips, bust);
  body.breasts = breasts_of(m.height, bust);
  for (const Row& row : kRows)
    body.sections.push_back(section_scaled(row.at, m.height,
                                           row.bust * bust + row.waist * waist + row.hips * hips +
                                               (1 - row.bust - row.waist - row.hips) * tall));
  return body;
}

// The sections of all rings: those of the table, and splines between them.
std::vector<Section> sections_between(const std::vector<Section>& knots, double height) {
  std::vector<double> at{0};
  for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
    const Section &p = knots[k], &q = knots[k + 1];
    at.push_back(at.back() + std::hypot(q[0] - p[0], q[1] - p[1], (q[2] + q[3] - p[2] - p[3]) / 2));
  }
  std::array<std::vector<double>, kColumns> column, second;
  for (std::size_t c = 0; c < kColumns; ++c) {
    for (const Section& s : knots) column[c].push_back(s[c]);
    second[c] = spline_fit(at, column[c]);
  }
  std::vector<Section> sections;
  for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
    const double step = (k < kArmholes ? kStepBelow : kStepAbove) * height / kReference;
    const int n = std::max(1, int(std::lround((at[k + 1] - at[k]) / step)));
    for (int i = 0; i < n; ++i) {
      Section& s = sections.emplace_back(knots[k]);  // the table's own where i = 0
      for (std::size_t c = 0; i && c < kColumns; ++c)
        s[c] = spline_at(at, column[c], second[c], k, at[k] + (at[k + 1] - at[k]) * i / n);
    }
  }
  sections.push_back(knots.back());
  return sections;
}

void ring_add(Mesh& mesh, const std::vector<Vec2>& ring, double y, double shrink, double lean) {
  for (const Vec2& p : ring) mesh.vertices.push_back({p[0] * shrink, y, lean + (p[1] - lean) * shrink});
}

// Rings stitched to each other, and both ends to a point.
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
      problems.push_back({option, "= " + number_text(value) + " m; allowed: " + number_text(low) + " to " +
                                      number_text(high) + " m"});
  };
  within("--bust", measures.bust, 0.7, 1.5);
  within("--waist", measures.waist, 0.5, 1.4);
  within("--hips", measures.hips, 0.7, 1.6);
  within("--height", measures.height, 1.4, 2.0);
}

Mesh form_make(const Measures& measures) {
  const Body body = body_fit(measures);
  const std::vector<Section> sections = sections_between(body.sections, measures.height);
  const double tall = measures.height / kReference;
  Mesh mesh;
  const Section &first = sections.front(), &last = sections.back();
  const double rim[3][2] = {
      {-0.012, 0.80}, {-0.0105, 0.93}, {-0.006, 0.985}};  // m down, shrinking: round edges
  for (const auto& [down, shrink] : rim)
    ring_add(mesh, section_ring(first, body.breasts), first[0] + down * tall, shrink, first[5]);
  for (const Section& s : sections) ring_add(mesh, section_ring(s, body.breasts), s[0], 1, s[5]);
  const double cap[3][2] = {{0.005, 0.97}, {0.008, 0.85}, {0.010, 0.5}};
  for (const auto& [up, shrink] : cap)
    ring_add(mesh, section_ring(last, body.breasts), last[0] + up * tall, shrink, last[5]);
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
  const auto pass = [&](auto begin, auto end) {
    const std::size_t base = hull.size();
    for (auto p = begin; p != end; ++p) {
      const auto outward = [&] {
        const Vec2 &a = hull[hull.size() - 2], &b = hull.back();
        return (b[0] - a[0]) * ((*p)[1] - a[1]) - (b[1] - a[1]) * ((*p)[0] - a[0]) <= 0;
      };
      while (hull.size() > base + 1 && outward()) hull.pop_back();
      hull.push_back(*p);
    }
    hull.pop_back();  // the other pass begins there
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

}  // namespace drape
