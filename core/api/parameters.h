// The tunable values of a cloth behind drape_parameters: storage, copies, checks.
#pragma once
#include "drape/drape.h"
#include "model/system.h"
#include "scene/limits.h"

namespace drape::api {

// The numbers of drape_parameters in one flat run, so that copying, comparing and restoring them are loops.
struct ParameterValues {
  std::vector<double> value;
  bool operator==(const ParameterValues&) const = default;
};

// "= -1 kg/m2; allowed: from 0.0001 to 100 kg/m2"
std::string limits_text(const scene::Quantity& limits, double value);

// The struct handed to users and what it points to.
struct Parameters {
  drape_parameters c_view{};
  std::vector<drape_fabric> fabrics;
  std::vector<drape_seam_parameters> seams;
  bool touches = false;                                // there are bodies, so that friction matters
  std::vector<std::vector<double>> elongation, force;  // [3 x fabrics] warp, weft, bias; without the origin
};

// Fills from a scene; the scene's fabric names must outlive the result, which must not move afterwards.
void parameters_make(Parameters& parameters, const Scene& scene, double step_max);

ParameterValues parameters_read(const Parameters& parameters);
void parameters_write(Parameters& parameters, const ParameterValues& values);

// True where two sets of values move the cloth otherwise: they differ in more than parameter_ramp, threads,
// friction where nothing can touch, and the closing of seams, which waits for the next interval.
bool parameters_move_otherwise(const Parameters& parameters, const ParameterValues& a,
                               const ParameterValues& b);

// For each value, what moves together when it is tuned: a number of its own, but one for all points of a
// diagram; -1 for what takes its new value at once (parameter_ramp, step.max, threads, the closing of seams).
std::vector<int> parameters_groups(const Parameters& parameters);

// The fabrics of the scene with the values of the parameters.
std::vector<scene::FabricSpec> parameters_fabrics(const Parameters& parameters, const Scene& scene);

// Puts back what may not be: single values out of their range, and diagrams that fall as a whole. One problem
// each.
void parameters_validate(Parameters& parameters, const Scene& scene, const ParameterValues& in_force,
                         std::vector<Problem>& problems);

// Puts back all values whose names begin so; false if they were there already.
bool parameters_restore(Parameters& parameters, const Scene& scene, const ParameterValues& in_force,
                        const std::string& stem);

}  // namespace drape::api
