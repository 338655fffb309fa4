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
#include "command/dress_form/sections.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "command/dress_form/spline.h"

namespace drape::command {
namespace {

constexpr double kReference = 1.66;                       // m, height of the body of the table
constexpr double kStepBelow = 0.026, kStepAbove = 0.016;  // m between rings, up to the armholes and above

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

Breasts breasts_of(double height, double scale) {
  return {kBustHeight * height, 0.086 * scale, 0.056 * scale, 0.062 * scale, 0.037 * scale};
}

// The point (x, z) of the section at the angle u, in m.
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

Section section_scaled(const Section& row, double height, double scale) {
  return {row[0] * height, row[1] * scale, row[2] * scale,
          row[3] * scale,  row[4],         row[5] * height / kReference};
}

// The scale at which a tape round the section measures `girth`. The length grows with the scale, so
// bisection finds it.
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
      Section& s = sections.emplace_back(knots[k]);  // i = 0: the section of the table itself
      for (std::size_t c = 0; i && c < kColumns; ++c)
        s[c] = spline_at(at, column[c], second[c], k, at[k] + (at[k + 1] - at[k]) * i / n);
    }
  }
  sections.push_back(knots.back());
  return sections;
}

}  // namespace

std::vector<Vec2> section_ring(const Section& section, const Breasts& breasts) {
  std::vector<Vec2> ring;
  for (int k = 0; k < kAround; ++k)
    ring.push_back(section_point(section, breasts, 2 * std::numbers::pi * k / kAround));
  return ring;
}

Torso torso_fit(const Measures& m) {
  Torso torso;
  const double bust = scale_find(kBust, m.height, m.bust, 1), tall = m.height / kReference;
  const double waist = scale_find(kWaist, m.height, m.waist, bust);
  const double hips = scale_find(kHips, m.height, m.hips, bust);
  torso.breasts = breasts_of(m.height, bust);
  std::vector<Section> knots;
  for (const Row& row : kRows)
    knots.push_back(section_scaled(row.at, m.height,
                                   row.bust * bust + row.waist * waist + row.hips * hips +
                                       (1 - row.bust - row.waist - row.hips) * tall));
  torso.sections = sections_between(knots, m.height);
  return torso;
}

}  // namespace drape::command
