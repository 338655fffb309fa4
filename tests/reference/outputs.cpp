// Strain e = l/rest - 1 of a link; its mean over a direction is weighted by the area width x rest.
// Tension T/w of a thread is its law at e. Energies: sums over the lists; gravity: -sum m g.r. Columns stand
// in the order of the variable table; step.stability is left out, as an error-controlled step has no limit to
// be compared with.
#include "reference/outputs.h"

#include <algorithm>
#include <limits>

#include "reference/forces.h"

namespace drape::reference {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

void push(std::vector<double>& row, const Vector3d& x) { row.insert(row.end(), x.data(), x.data() + 3); }

void push_axes(std::vector<std::string>& names, const std::string& stem) {
  for (const char* axis : {"[1]", "[2]", "[3]"}) names.push_back(stem + axis);
}

void push_strain(std::vector<double>& row, const std::vector<Link>& links, const VectorXd& r) {
  double min = std::numeric_limits<double>::infinity(), max = -min, sum = 0, area = 0;
  for (const Link& link : links) {
    const double e = link_strain(link, r);
    min = std::min(min, e);
    max = std::max(max, e);
    sum += e * link.width * link.rest;
    area += link.width * link.rest;
  }
  row.insert(row.end(), {min, max, sum / area});
}

double tension_max(const Lattice& lattice, const VectorXd& r) {
  double max = -std::numeric_limits<double>::infinity();
  for (const std::vector<Link>* links : {&lattice.warp, &lattice.weft}) {
    for (const Link& link : *links) {
      max = std::max(max, curve_value(lattice.laws[std::size_t(link.law)].curve, link_strain(link, r)));
    }
  }
  return max;
}

double beyond_test_count(const Lattice& lattice, const VectorXd& r) {
  double count = 0;
  for (const std::vector<Link>* links : {&lattice.warp, &lattice.weft, &lattice.bias}) {
    for (const Link& link : *links) {
      if (link_strain(link, r) > lattice.laws[std::size_t(link.law)].test_end) ++count;
    }
  }
  return count;
}

void push_energies(std::vector<double>& row, const Motion& motion, const VectorXd& r, const VectorXd& v) {
  const Lattice& lattice = motion.lattice;
  double kinetic = 0, gravity = 0;
  for (int n = 0; n < lattice.count; ++n) {
    const double m = lattice.mass[std::size_t(n)];
    kinetic += m * v.segment<3>(3 * n).squaredNorm() / 2;
    gravity -= m * motion.gravity.dot(r.segment<3>(3 * n));
  }
  row.insert(row.end(), {kinetic, stretch_energy(lattice, r), shear_energy(lattice, r),
                         bending_energy(lattice, r), gravity});
}

}  // namespace

std::vector<std::string> output_columns(const Scene& scene, const Lattice& lattice, OutputChoice choice) {
  std::vector<std::string> names{"time"};
  for (const ProbeSpec& probe : scene.probes) {
    push_axes(names, "probe." + probe.name + ".position");
    push_axes(names, "probe." + probe.name + ".velocity");
  }
  for (const std::string& pin : lattice.pins) push_axes(names, "pin." + pin + ".force");
  for (const char* direction : {"warp", "weft", "bias"}) {
    for (const char* what : {".min", ".max", ".mean"})
      names.push_back(std::string("strain.") + direction + what);
  }
  names.insert(names.end(), {"tension.max", "strain.beyond_test.count", "step.size", "step.count"});
  if (choice.energy) {
    for (const char* kind : {"kinetic", "stretch", "shear", "bending", "gravity"}) {
      names.push_back(std::string("energy.") + kind);
    }
  }
  if (!choice.nodes) return names;
  for (const char* what : {"node.position[", "node.velocity["}) {
    for (int n = 1; n <= lattice.count; ++n) {
      for (const char* axis : {",1]", ",2]", ",3]"}) names.push_back(what + std::to_string(n) + axis);
    }
  }
  return names;
}

std::vector<double> output_row(const Motion& motion, OutputChoice choice, double time, const VectorXd& y,
                               const VectorXd& pin_force, double last_step, long step_count) {
  const Lattice& lattice = motion.lattice;
  const VectorXd r = y.head(3 * lattice.count), v = y.segment(3 * lattice.count, 3 * lattice.count);
  std::vector<double> row{time};
  for (const Point& probe : lattice.probes) {
    push(row, point_value(probe, r));
    push(row, point_value(probe, v));
  }
  row.insert(row.end(), pin_force.begin(), pin_force.end());
  push_strain(row, lattice.warp, r);
  push_strain(row, lattice.weft, r);
  push_strain(row, lattice.bias, r);
  row.insert(row.end(),
             {tension_max(lattice, r), beyond_test_count(lattice, r), last_step, double(step_count)});
  if (choice.energy) push_energies(row, motion, r, v);
  if (!choice.nodes) return row;
  row.insert(row.end(), r.begin(), r.end());
  row.insert(row.end(), v.begin(), v.end());
  return row;
}

}  // namespace drape::reference
