#include "scene/reader/normalize.h"

#include "scene/files.h"

#include <algorithm>
#include <cmath>

namespace drape::scene {

namespace {

constexpr double kTolerance = 1e-6;     // typed directions have about six digits
constexpr double kMaxRadiusRatio = 20;  // largest ratio of the radii of an elliptic cylinder

double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Removes from `a` its component along the unit vector u.
void remove(Vec3& a, const Vec3& u) {
  const double along = dot(a, u);
  for (std::size_t k = 0; k < 3; ++k) a[k] -= along * u[k];
}

void normalize(Vec3& a) {
  const double length = std::sqrt(dot(a, a));
  for (double& v : a) v /= length;
}

void length_check(Faults& faults, const Vec3& a, const std::string& path) {
  const double length = std::sqrt(dot(a, a));
  if (!(std::abs(length - 1) <= kTolerance))
    fault_add(faults, path,
              "has length " + number_text(length) + "; wanted: 1, within " + number_text(kTolerance));
}

// Checks the axes and makes them exactly orthonormal; x keeps its direction.
void axes_normalize(Faults& faults, const toml::table& table, const std::string& path, PlaceSpec& place) {
  const bool x_given(table["place"]["axis_x"]), y_given(table["place"]["axis_y"]);
  if (x_given != y_given)
    return fault_add(faults, path, "has only one of axis_x and axis_y; wanted: both or neither");
  Vec3 &x = place.axis_x, &y = place.axis_y;
  length_check(faults, x, path + ".axis_x");
  length_check(faults, y, path + ".axis_y");
  if (!(std::abs(dot(x, y)) <= kTolerance))
    fault_add(faults, path,
              "has axis_x . axis_y = " + number_text(dot(x, y)) + "; wanted: 0, a right angle, within " +
                  number_text(kTolerance));
  normalize(x);
  remove(y, x);
  normalize(y);
}

// Checks the axis of the cylinder and makes it exactly parallel to the plane.
void cylinder_normalize(Faults& faults, const std::string& path, PlaceSpec& place) {
  length_check(faults, place.axis, path + ".axis");
  const Vec3 normal = cross(place.axis_x, place.axis_y);
  const double out = dot(place.axis, normal);
  if (!(std::abs(out) <= kTolerance))
    fault_add(faults, path + ".axis",
              "has " + number_text(out) +
                  " across the plane of axis_x and axis_y; wanted: 0, an axis parallel to " +
                  "the plane, within " + number_text(kTolerance));
  remove(place.axis, normal);
  normalize(place.axis);
  const auto [a, b] = place.radius;
  if (!(std::max(a, b) <= kMaxRadiusRatio * std::min(a, b)))
    fault_add(faults, path + ".radius",
              "= [" + number_text(a) + ", " + number_text(b) + "] m; allowed: neither above " +
                  number_text(kMaxRadiusRatio) + " times the other");
}

void curves_normalize(Faults& faults, const toml::table& table, const std::string& path) {
  const toml::array* curves = table["curves"].as_array();
  for (std::size_t i = 0; curves && i < curves->size(); ++i) {
    const toml::table* curve = (*curves)[i].as_table();
    if (!curve) continue;
    const std::string at = path + ".curves[" + std::to_string(i) + "]";
    const bool bezier = curve->contains("bezier"), arc = curve->contains("arc");
    if (bezier == arc)
      fault_add(
          faults, at,
          bezier ? "has both bezier and arc; wanted: one of them" : "is no curve; wanted: bezier or arc");
    for (const char* key : {"large", "right"})
      if (bezier && !arc && curve->contains(key))
        fault_add(faults, at + "." + key, "belongs to an arc, not to a Bezier curve");
  }
}

}  // namespace

void piece_normalize(Faults& faults, const toml::table& table, const std::string& path, PieceSpec& piece) {
  const std::string place = path + ".place";
  const auto valid = [&](const std::string& key) { return !fault_within(faults, path + "." + key); };
  if (valid("place.axis_x") && valid("place.axis_y")) axes_normalize(faults, table, place, piece.place);
  if (table["place"]["cylinder"].is_table() && valid("place"))
    cylinder_normalize(faults, place + ".cylinder", piece.place);
  curves_normalize(faults, table, path);
  if (!valid("curves") || !valid("holes")) piece.outline.clear();
}

void seam_normalize(Faults& faults, const toml::table& table, const std::string& path) {
  for (const char* side : {"a", "b"})
    if (!table.contains(side))
      fault_add(faults, path + "." + side, "is missing; wanted: a table { piece, edges }");
}

void body_normalize(Faults& faults, const std::string& path, const std::filesystem::path& folder,
                    const BodyText& text, BodySpec& body) {
  const std::filesystem::path file = (folder / path_of(text.mesh)).lexically_normal();
  body.mesh = path_text(file);
  if (body.drive != Drive::kNone && !body.moves)
    fault_add(faults, path + ".drive",
              "is of a body that moves; wanted: moves = true beside it, or no drive");
  if (const std::string hindrance = file_hindrance(file, kMaxData); !text.mesh.empty() && !hindrance.empty())
    fault_add(faults, path + ".mesh",
              "= " + in_quotes(text.mesh) + ": " + hindrance + " (looked for " + path_text(file) + ")");
  if (text.orientation.empty() || fault_within(faults, path + ".orientation")) return;
  if (text.orientation.size() != 4)
    return fault_add(faults, path + ".orientation",
                     "has " + entries_text(text.orientation.size()) + "; wanted: 4 numbers, w, x, y, z");
  std::copy(text.orientation.begin(), text.orientation.end(), body.orientation.begin());
  const auto& q = body.orientation;
  if (q[0] == 0 && q[1] == 0 && q[2] == 0 && q[3] == 0)
    fault_add(faults, path + ".orientation", "has length 0; allowed: any length above 0");
}

void pin_normalize(Faults& faults, const toml::table& table, const std::string& path) {
  const int given = table.contains("at") + table.contains("edges") + table.contains("region");
  if (given != 1)
    fault_add(faults, path,
              given ? "has more than one of at, edges and region; wanted: one of them"
                    : "holds nothing; wanted: at, edges or region");
}

}  // namespace drape::scene
