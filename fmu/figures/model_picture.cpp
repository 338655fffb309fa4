#include "figures/model_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "figures/png.h"
#include "math/vector3.h"

namespace drape::figures {
namespace {

using namespace math::vector3;

constexpr int kWidth = 480, kHeight = 360, kMargin = 12;  // pixels
constexpr int kSamples = 2;                               // along either side of a pixel

struct Colour {
  double red, green, blue;
};
constexpr Colour kBody{0.72, 0.72, 0.74};
constexpr Colour kPieces[] = {{0.36, 0.52, 0.74}, {0.80, 0.55, 0.36}, {0.45, 0.65, 0.45},
                              {0.62, 0.47, 0.68}, {0.75, 0.68, 0.38}, {0.42, 0.64, 0.68}};

struct Triangle {
  Vec3 corner[3];  // m
  Colour colour;
};

void pieces_add(drape_cloth* cloth, std::vector<Triangle>& triangles) {
  const double* node = drape_get_outputs(cloth, DRAPE_OUT_NODE_POSITION)->node_position;
  for (int p = 0; p < drape_piece_count(cloth); ++p) {
    const drape_piece piece = drape_piece_at(cloth, p);
    const auto place = [&](int corner) {
      Vec3 sum{0, 0, 0};
      const int point = corner - piece.point_first;
      for (int k = 0; k < (point < 0 ? 1 : 4); ++k) {
        const int n = point < 0 ? corner : piece.point_node[4 * point + k];
        const double weight = point < 0 ? 1 : piece.point_weight[4 * point + k];
        const double* const at = node + 3 * std::size_t(n);
        sum += weight * Vec3{at[0], at[1], at[2]};
      }
      return sum;
    };
    for (int k = 0, begin = 0; k < piece.polygon_count; begin = piece.polygon_end[k++])
      for (int c = begin + 2; c < piece.polygon_end[k]; ++c)
        triangles.push_back({{place(piece.polygon_corner[begin]), place(piece.polygon_corner[c - 1]),
                              place(piece.polygon_corner[c])},
                             kPieces[std::size_t(p) % std::size(kPieces)]});
  }
}

void bodies_add(drape_cloth* cloth, std::vector<Triangle>& triangles) {
  const int bodies = drape_get_outputs(cloth, 0)->body_count;
  for (int b = 0; b < bodies; ++b) {
    const drape_surface surface = drape_surface_at(cloth, b);
    for (int t = 0; t < surface.triangle_count; ++t) {
      Triangle triangle{{}, kBody};
      for (int c = 0; c < 3; ++c)
        std::copy_n(surface.point + 3 * surface.corner[3 * t + c], 3, triangle.corner[c].begin());
      triangles.push_back(triangle);
    }
  }
}

// Axes of the picture in space: to the right, up, and towards the eye.
struct Camera {
  Vec3 right, up, eye;
};

// Up is against gravity; the eye is in front, to the right and above.
Camera camera_make(const double gravity[3]) {
  Vec3 up = unit(Vec3{-gravity[0], -gravity[1], -gravity[2]});
  if (dot(up, up) == 0) up = {0, 0, 1};
  const bool y_up = std::abs(up[1]) > 0.7;
  const Vec3 front = y_up ? Vec3{0, 0, 1} : Vec3{0, -1, 0};
  const Vec3 side = unit(cross(up, front));
  const Vec3 eye = unit(front + 0.55 * side + 0.5 * up);
  const Vec3 right = unit(cross(up, eye));
  return {right, cross(eye, right), eye};
}

// Draws triangles nearest to the eye first, by a depth for each sample.
struct Canvas {
  int width = kWidth * kSamples, height = kHeight * kSamples;
  std::vector<double> depth =
      std::vector<double>(std::size_t(width) * std::size_t(height), -std::numeric_limits<double>::infinity());
  std::vector<Colour> colour = std::vector<Colour>(depth.size(), Colour{0, 0, 0});
};

void triangle_draw(Canvas& canvas, const Vec3 (&p)[3], const Colour& colour) {
  const double area = (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[2][0] - p[0][0]) * (p[1][1] - p[0][1]);
  if (area == 0) return;
  const auto span = [&](std::size_t axis, int size) {
    const double low = std::min({p[0][axis], p[1][axis], p[2][axis]}),
                 high = std::max({p[0][axis], p[1][axis], p[2][axis]});
    return std::pair{std::max(0, int(std::floor(low))), std::min(size - 1, int(std::ceil(high)))};
  };
  const auto [left, right] = span(0, canvas.width);
  const auto [top, bottom] = span(1, canvas.height);
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x) {
      const double px = x + 0.5, py = y + 0.5;
      double weight[3];
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 &a = p[(k + 1) % 3], &b = p[(k + 2) % 3];
        weight[k] = ((b[0] - a[0]) * (py - a[1]) - (px - a[0]) * (b[1] - a[1])) / area;
      }
      if (weight[0] < 0 || weight[1] < 0 || weight[2] < 0) continue;
      const double depth = weight[0] * p[0][2] + weight[1] * p[1][2] + weight[2] * p[2][2];
      const std::size_t at = std::size_t(y) * std::size_t(canvas.width) + std::size_t(x);
      if (depth <= canvas.depth[at]) continue;
      canvas.depth[at] = depth;
      canvas.colour[at] = colour;
    }
}

void triangles_draw(Canvas& canvas, const Camera& camera, const std::vector<Triangle>& triangles) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double low[2] = {kInfinity, kInfinity}, high[2] = {-kInfinity, -kInfinity};
  const auto seen = [&](const Vec3& at) {
    return Vec3{dot(at, camera.right), -dot(at, camera.up), dot(at, camera.eye)};
  };
  for (const Triangle& t : triangles)
    for (const Vec3& corner : t.corner)
      for (std::size_t k = 0; k < 2; ++k)
        low[k] = std::min(low[k], seen(corner)[k]), high[k] = std::max(high[k], seen(corner)[k]);
  const double scale = kSamples * std::min((kWidth - 2 * kMargin) / std::max(high[0] - low[0], 1e-9),
                                           (kHeight - 2 * kMargin) / std::max(high[1] - low[1], 1e-9));
  const Vec3 light = unit({0.3, 0.5, 0.8});  // in the axes of the picture
  for (const Triangle& t : triangles) {
    const Vec3 n = unit(cross(t.corner[1] - t.corner[0], t.corner[2] - t.corner[0]));
    const double lit = std::abs(dot(n, camera.right) * light[0] + dot(n, camera.up) * light[1] +
                                dot(n, camera.eye) * light[2]),
                 shade = 0.45 + 0.55 * lit;
    Vec3 p[3];
    for (int c = 0; c < 3; ++c) {
      const Vec3 at = seen(t.corner[c]);
      p[c] = {canvas.width / 2.0 + scale * (at[0] - (low[0] + high[0]) / 2),
              canvas.height / 2.0 + scale * (at[1] - (low[1] + high[1]) / 2), at[2]};
    }
    triangle_draw(canvas, p, {shade * t.colour.red, shade * t.colour.green, shade * t.colour.blue});
  }
}

// The means of the samples of each pixel; where nothing is drawn, the image is transparent.
std::vector<Pixel> pixels_of(const Canvas& canvas) {
  std::vector<Pixel> pixels;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      double sum[3] = {0, 0, 0}, drawn = 0;
      for (int s = 0; s < kSamples * kSamples; ++s) {
        const std::size_t at = std::size_t(y * kSamples + s / kSamples) * std::size_t(canvas.width) +
                               std::size_t(x * kSamples + s % kSamples);
        if (!(canvas.depth[at] > -std::numeric_limits<double>::infinity())) continue;
        const Colour& c = canvas.colour[at];
        sum[0] += c.red, sum[1] += c.green, sum[2] += c.blue;
        drawn += 1;
      }
      Pixel pixel{};
      for (std::size_t k = 0; k < 3 && drawn > 0; ++k)
        pixel[k] = std::uint8_t(std::lround(255 * sum[k] / drawn));
      pixel[3] = std::uint8_t(std::lround(255 * drawn / (kSamples * kSamples)));
      pixels.push_back(pixel);
    }
  return pixels;
}

}  // namespace

std::string model_png(drape_cloth* cloth) {
  std::vector<Triangle> triangles;
  pieces_add(cloth, triangles);
  bodies_add(cloth, triangles);
  Canvas canvas;
  triangles_draw(canvas, camera_make(drape_parameters_of(cloth)->gravity), triangles);
  return png_bytes(kWidth, pixels_of(canvas));
}

}  // namespace drape::figures
