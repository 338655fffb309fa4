#include "command/files/frames.h"

#include <cmath>
#include <cstdio>
#include <system_error>

#include "command/files/polydata.h"
#include "command/files/whole_file.h"
#include "decimal.h"

namespace drape::command {
namespace {

// Interpolates the values of four particles at the points that move with them.
template <class T>
void interpolate(const drape_piece& piece, const double* of_nodes, std::size_t components,
                 std::vector<T>& to) {
  for (int k = 0; k < piece.point_count; ++k)
    for (std::size_t axis = 0; axis < components; ++axis) {
      double sum = 0;
      for (int n = 4 * k; n < 4 * k + 4; ++n)
        sum += piece.point_weight[n] * of_nodes[components * std::size_t(piece.point_node[n]) + axis];
      to.push_back(T(sum));
    }
}

// One component of a field on the particles.
struct Component {
  const char* name;
  const double* values;
  std::size_t stride;
};

PolyData cloth_poly(drape_cloth* cloth) {
  const drape_outputs& o = *drape_get_outputs(cloth, DRAPE_OUT_NODE_POSITION | DRAPE_OUT_NODE_VELOCITY);
  const drape_fields& f = *drape_fields_at(cloth);
  const auto count = std::size_t(o.node_count);
  PolyData poly;
  poly.position.assign(o.node_position, o.node_position + 3 * count);
  poly.velocity.assign(o.node_velocity, o.node_velocity + 3 * count);
  const Component components[] = {
      {"strain_warp", f.strain, 3},   {"strain_weft", f.strain + 1, 3},   {"strain_bias", f.strain + 2, 3},
      {"tension_warp", f.tension, 2}, {"tension_weft", f.tension + 1, 2}, {"pressure", f.pressure, 1},
  };
  std::vector<std::vector<double>> of_nodes;
  for (const Component& c : components) {
    std::vector<double>& values = of_nodes.emplace_back(count);
    for (std::size_t n = 0; n < count; ++n) values[n] = c.values[c.stride * n];
    poly.of_points.push_back({c.name, 1, {values.begin(), values.end()}});
  }
  PolyField number{"piece", 1, {}};
  for (int p = 0; p < drape_piece_count(cloth); ++p) {
    const drape_piece piece = drape_piece_at(cloth, p);
    interpolate(piece, o.node_position, 3, poly.position);
    interpolate(piece, o.node_velocity, 3, poly.velocity);
    for (std::size_t k = 0; k < of_nodes.size(); ++k)
      interpolate(piece, of_nodes[k].data(), 1, poly.of_points[k].values);
    const auto before = std::int32_t(poly.polygons.corner.size());
    for (int k = 0; k < piece.polygon_count; ++k) poly.polygons.end.push_back(before + piece.polygon_end[k]);
    const int corners = piece.polygon_count ? piece.polygon_end[piece.polygon_count - 1] : 0;
    poly.polygons.corner.insert(poly.polygons.corner.end(), piece.polygon_corner,
                                piece.polygon_corner + corners);
    number.values.insert(number.values.end(), std::size_t(piece.polygon_count), float(p));
  }
  poly.of_cells.push_back(std::move(number));
  return poly;
}

// Two lines for each seam: the positions of its particles on either piece.
PolyData seams_poly(drape_cloth* cloth) {
  PolyData poly;
  PolyField gap{"gap", 1, {}}, number{"seam", 1, {}};
  const int count = drape_get_outputs(cloth, DRAPE_OUT_POSITION)->seam_count;
  for (int s = 0; s < count; ++s) {
    const drape_seam_lines seam = drape_seam_lines_at(cloth, s);
    for (const double* side : {seam.a, seam.b}) {
      const auto first = std::int32_t(poly.position.size() / 3);
      poly.position.insert(poly.position.end(), side, side + 3 * seam.pair_count);
      for (int k = 0; k < seam.pair_count; ++k) {
        const double *a = seam.a + 3 * k, *b = seam.b + 3 * k;
        gap.values.push_back(float(std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2])));
        poly.lines.corner.push_back(first + k);
      }
      if (seam.loop) poly.lines.corner.push_back(first);
      poly.lines.end.push_back(std::int32_t(poly.lines.corner.size()));
      number.values.push_back(float(s));
    }
  }
  poly.of_points.push_back(std::move(gap));
  poly.of_cells.push_back(std::move(number));
  return poly;
}

PolyData bodies_poly(drape_cloth* cloth) {
  PolyData poly;
  PolyField number{"body", 1, {}};
  for (int b = 0; b < drape_file_count(cloth); ++b) {
    const drape_surface body = drape_surface_at(cloth, b);
    const auto first = std::int32_t(poly.position.size() / 3);
    poly.position.insert(poly.position.end(), body.point, body.point + 3 * body.point_count);
    for (int t = 0; t < body.triangle_count; ++t) {
      for (int k = 3 * t; k < 3 * t + 3; ++k) poly.polygons.corner.push_back(first + body.corner[k]);
      poly.polygons.end.push_back(std::int32_t(poly.polygons.corner.size()));
    }
    number.values.insert(number.values.end(), std::size_t(body.triangle_count), float(b));
  }
  poly.of_cells.push_back(std::move(number));
  return poly;
}

std::string file_name(const std::string& collection, std::size_t number) {
  char name[16];
  std::snprintf(name, sizeof name, "/%04zu.vtp", number);
  return collection + name;
}

std::string collection_text(const Collection& c) {
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\">\n<Collection>\n";
  for (std::size_t i = 0; i < c.times.size(); ++i)
    text += "<DataSet timestep=\"" + description::decimal_text(c.times[i]) + "\" file=\"" +
            file_name(c.name, c.files[i]) + "\"/>\n";
  return text + "</Collection>\n</VTKFile>\n";
}

// Adds a time to a collection. `poly` is null where the last file still holds.
bool collect(Frames& frames, Collection& c, double time, const PolyData* poly) {
  const std::size_t number = c.files.empty() ? 0 : c.files.back() + (poly != nullptr);
  std::error_code error;
  std::filesystem::create_directories(frames.folder / c.name, error);
  const std::filesystem::path path = frames.folder / file_name(c.name, number),
                              collection = frames.folder / (c.name + ".pvd");
  if (poly) frames.failure = file_write(path, polydata_text(*poly)).problem;
  if (!frames.failure.empty()) return false;
  c.times.push_back(time);
  c.files.push_back(number);
  frames.failure = file_write(collection, collection_text(c)).problem;
  return frames.failure.empty();
}

bool any_moves(drape_cloth* cloth) {
  bool moves = false;
  for (int b = 0; b < drape_file_count(cloth); ++b) moves = moves || drape_surface_at(cloth, b).moves;
  return moves;
}

}  // namespace

bool frame_write(Frames& frames, drape_cloth* cloth, double time) {
  std::error_code error;
  if (frames.cloth.times.empty())  // remove the files of another run in the same folder
    for (const char* name : {"frames.pvd", "seams.pvd", "bodies.pvd"})
      std::filesystem::remove(frames.folder / name, error);
  const PolyData poly = cloth_poly(cloth);
  if (!collect(frames, frames.cloth, time, &poly)) return false;
  if (drape_get_outputs(cloth, DRAPE_OUT_POSITION)->seam_count > 0) {
    const PolyData seams = seams_poly(cloth);
    if (!collect(frames, frames.seams, time, &seams)) return false;
  }
  if (drape_file_count(cloth) == 0) return true;
  if (!frames.bodies.files.empty() && !any_moves(cloth)) return collect(frames, frames.bodies, time, nullptr);
  const PolyData bodies = bodies_poly(cloth);
  return collect(frames, frames.bodies, time, &bodies);
}

}  // namespace drape::command
