#include "reference/course.h"

#include <algorithm>
#include <stdexcept>

#include "reference/names.h"

namespace drape::reference {
namespace {

using Eigen::Vector3d;

// A value of an Outside by its name: "wind[1]", "pin.bar.position[3]", "pin.bar.orientation[1]" (w is the
// first). In memory the coefficients of a quaternion are x, y, z, w.
double* input_of(Outside& outside, const Lattice& lattice, const std::string& name) {
  const std::size_t bracket = name.find('[');
  if (bracket == std::string::npos || name.size() != bracket + 3 || name.back() != ']') return nullptr;
  const std::string stem = name.substr(0, bracket);
  const int axis = name[bracket + 1] - '1';
  if (axis < 0 || axis > 3) return nullptr;
  if (stem == "wind") return axis < 3 ? &outside.wind[axis] : nullptr;
  for (std::size_t k = 0; k < lattice.pins.size(); ++k) {
    const Pin& pin = lattice.pins[k];
    Frame& frame = outside.pins[k];
    const bool place = pin.drive == scene::Drive::kPosition || pin.drive == scene::Drive::kBoth;
    const bool speed = pin.drive == scene::Drive::kVelocity || pin.drive == scene::Drive::kBoth;
    const std::string prefix = variable_prefix("pin", pin.name);
    if (place && pin.clamp && stem == prefix + "orientation") return &frame.R.coeffs()[(axis + 3) % 4];
    if (axis == 3) continue;
    if (place && stem == prefix + "position") return &frame.p[axis];
    if (speed && stem == prefix + "velocity") return &frame.v[axis];
    if (speed && pin.clamp && stem == prefix + "angular_velocity") return &frame.w[axis];
  }
  return nullptr;
}

}  // namespace

Outside outside_start(const Scene& scene, const Lattice& lattice) {
  Outside outside{std::vector<Frame>(lattice.pins.size()), {scene.wind[0], scene.wind[1], scene.wind[2]}};
  for (std::size_t k = 0; k < lattice.pins.size(); ++k) outside.pins[k].p = lattice.pins[k].centre;
  return outside;
}

Course course_make(const Lattice& lattice, const Outside& from, const Outside& to, double length) {
  Course course{length, {}, from.wind, to.wind};
  for (std::size_t k = 0; k < lattice.pins.size(); ++k)
    course.pins.push_back(
        path_make(from.pins[k], lattice.pins[k].drive, lattice.pins[k].clamp, to.pins[k], length));
  return course;
}

Outside course_at(const Course& course, double time) {
  Outside outside{{}, course.wind_from + time / course.length * (course.wind_to - course.wind_from)};
  for (const Path& path : course.pins) outside.pins.push_back(path_frame(path, time));
  return outside;
}

Outside inputs_at(const InputTable& inputs, const Scene& scene, const Lattice& lattice, double time) {
  Outside outside = outside_start(scene, lattice);
  if (inputs.time.empty()) return outside;
  const auto above = std::upper_bound(inputs.time.begin(), inputs.time.end(), time);
  const std::size_t next = std::size_t(above - inputs.time.begin());
  const std::size_t a = next > 0 ? next - 1 : 0, b = std::min(next, inputs.time.size() - 1);
  const double share = a < b ? (time - inputs.time[a]) / (inputs.time[b] - inputs.time[a]) : 0;
  for (std::size_t k = 0; k < inputs.names.size(); ++k) {
    double* value = input_of(outside, lattice, inputs.names[k]);
    if (!value) throw std::runtime_error("'" + inputs.names[k] + "' is no input of this scene");
    *value = inputs.value[a][k] + share * (inputs.value[b][k] - inputs.value[a][k]);
  }
  for (std::size_t k = 0; k < lattice.pins.size(); ++k)
    if (!(outside.pins[k].R.norm() > 0))
      throw std::runtime_error(variable_prefix("pin", lattice.pins[k].name) +
                               "orientation has length 0 at t = " + std::to_string(time) +
                               " s; allowed: above 0");
  return outside;
}

}  // namespace drape::reference
