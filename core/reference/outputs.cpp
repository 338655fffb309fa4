// The strain of a link is e = l/rest - 1; its mean over a direction is weighted by the area, width x rest.
// The tension T/w of a link is its law at e. Energies are sums over the lists; that of gravity is -sum m g.r.
// Columns are in the order of the variable table, without step.stability, the loads on bodies and the largest
// pressure. (A step with error control has no stability limit to compare with.)
#include "reference/outputs.h"

#include <algorithm>
#include <limits>

#include "reference/forces.h"
#include "reference/names.h"

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

// Appends the largest gap, 1 where the seam is closed, and the length along the middle of both sides.
void push_seam(std::vector<double>& row, const Seam& seam, const std::vector<Stage>& stages,
               const VectorXd& r) {
  double gap = 0, length = 0;
  Vector3d last = Vector3d::Zero();
  for (std::size_t p = 0; p < seam.pairs.size(); ++p) {
    const Vector3d a = point_value(seam.pairs[p][0], r), b = point_value(seam.pairs[p][1], r);
    const Vector3d middle = (a + b) / 2;
    gap = std::max(gap, (b - a).norm());
    if (p > 0) length += (middle - last).norm();
    last = middle;
  }
  const bool closed =
      std::all_of(stages.begin(), stages.end(), [](Stage stage) { return stage == Stage::kWelded; });
  row.insert(row.end(), {gap, double(closed && gap <= seam.gap_tolerance), length});
}

// balance_error is the solver's own error: the exact solution has 0.
void push_energies(std::vector<double>& row, const Motion& motion, const Sample& sample) {
  const Layout at = layout_of(motion.lattice);
  const Energy energy = motion_energy(motion, turns_of(sample.outside), sample.y);
  const double input = sample.y[at.input], dissipated = sample.y[at.dissipated];
  row.insert(row.end(), {energy.kinetic, energy.stretch, energy.shear, energy.bending, energy.gravity});
  if (!motion.contact.bodies.empty()) row.push_back(energy.contact);
  row.insert(row.end(), {dissipated, input, energy.total() - sample.energy_start - input + dissipated});
}

}  // namespace

std::vector<std::string> output_columns(const Scene& scene, const Lattice& lattice, bool nodes) {
  std::vector<std::string> names{"time"};
  for (const scene::ProbeSpec& probe : scene.probes) {
    push_axes(names, variable_prefix("probe", probe.name) + "position");
    push_axes(names, variable_prefix("probe", probe.name) + "velocity");
  }
  for (const Pin& pin : lattice.pins) {
    push_axes(names, variable_prefix("pin", pin.name) + "force");
    push_axes(names, variable_prefix("pin", pin.name) + "torque");
  }
  for (const Seam& seam : lattice.seams)
    for (const char* what : {"gap.max", "closed", "length"})
      names.push_back(variable_prefix("seam", seam.name) + what);
  if (!scene.bodies.empty()) names.insert(names.end(), {"contact.count", "contact.penetration.max"});
  for (const char* direction : {"warp", "weft", "bias"}) {
    for (const char* what : {".min", ".max", ".mean"})
      names.push_back(std::string("strain.") + direction + what);
  }
  names.insert(names.end(), {"tension.max", "strain.beyond_test.count", "step.size", "step.count"});
  if (scene.mode == scene::Mode::kFit) names.push_back("fit.residual");
  if (scene.energy) {
    for (const char* kind : {"kinetic", "stretch", "shear", "bending", "gravity"})
      names.push_back(std::string("energy.") + kind);
    if (!scene.bodies.empty()) names.push_back("energy.contact");
    if (scene.mode == scene::Mode::kDynamic)  // fit mode has no energy balance
      for (const char* kind : {"dissipated", "input", "balance_error"})
        names.push_back(std::string("energy.") + kind);
  }
  if (!nodes) return names;
  for (const char* what : {"node.position[", "node.velocity["}) {
    for (int n = 1; n <= lattice.count; ++n) {
      for (const char* axis : {",1]", ",2]", ",3]"}) names.push_back(what + std::to_string(n) + axis);
    }
  }
  return names;
}

std::vector<double> output_row(const Scene& scene, const Motion& motion, bool nodes, const Sample& sample) {
  const Lattice& lattice = motion.lattice;
  const VectorXd r = sample.y.head(3 * lattice.count),
                 v = sample.y.segment(3 * lattice.count, 3 * lattice.count);
  std::vector<double> row{sample.time};
  for (const Point& probe : lattice.probes) {
    push(row, point_value(probe, r));
    push(row, point_value(probe, v));
  }
  for (std::size_t k = 0; k < lattice.pins.size(); ++k) {
    push(row, sample.pins.force.segment<3>(3 * Eigen::Index(k)));
    push(row, sample.pins.torque.segment<3>(3 * Eigen::Index(k)));
  }
  for (std::size_t k = 0; k < lattice.seams.size(); ++k)
    push_seam(row, lattice.seams[k], motion.sewing[k], r);
  if (!motion.contact.bodies.empty()) {
    const ContactSummary found = contact_summary(lattice, motion.contact, r);
    row.insert(row.end(), {double(found.count), found.depth});
  }
  push_strain(row, lattice.warp, r);
  push_strain(row, lattice.weft, r);
  push_strain(row, lattice.bias, r);
  row.insert(row.end(), {tension_max(lattice, r), beyond_test_count(lattice, r), sample.step_size,
                         double(sample.step_count)});
  if (scene.mode == scene::Mode::kFit) row.push_back(residual(motion, sample.outside, r).ratio);
  if (scene.energy) {
    push_energies(row, motion, sample);
    if (scene.mode == scene::Mode::kFit) row.resize(row.size() - 3);
  }
  if (!nodes) return row;
  row.insert(row.end(), r.begin(), r.end());
  row.insert(row.end(), v.begin(), v.end());
  return row;
}

}  // namespace drape::reference
