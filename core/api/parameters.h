// The storage behind drape_parameters: the tunable values of a cloth, their copies and their checks.
#pragma once
#include "drape/drape.h"
#include "model/system.h"
#include "scene/limits.h"

namespace drape::api {

// The numbers of drape_parameters as one flat array, so that copying, comparing and restoring them are loops.
struct ParameterValues {
  std::vector<double> value;
  bool operator==(const ParameterValues&) const = default;
};

// A message such as "= -1 kg/m2; allowed: from 0.0001 to 100 kg/m2".
std::string limits_text(const scene::Quantity& limits, double value);

// The struct that users see, and the arrays that it points to.
struct Parameters {
  drape_parameters c_view{};
  std::vector<drape_fabric> fabrics;
  std::vector<drape_seam_parameters> seams;
  bool has_bodies = false;                             // friction has an effect
  std::vector<std::vector<double>> elongation, force;  // [fabrics x 3] warp, weft, bias; without the origin
};

// Fills the parameters from a scene. The scene's names must outlive the result, and the result must not move
// in memory.
void parameters_make(Parameters& parameters, const Scene& scene, double step_max);

ParameterValues parameters_read(const Parameters& parameters);
void parameters_write(Parameters& parameters, const ParameterValues& values);

// True where two sets of values give different motions: they differ in more than parameter_ramp, threads,
// friction in a scene without bodies, and the closing of seams, which takes effect at the next interval.
bool parameters_change_motion(const Parameters& parameters, const ParameterValues& a,
                              const ParameterValues& b);

// The group of each value for ramps. All points of a diagram form one group; any other value has a group of
// its own. Group -1 takes its new value at once: parameter_ramp, step.max, threads, the closing of seams.
std::vector<int> parameters_groups(const Parameters& parameters);

// The fabrics of the scene with the values of the parameters.
std::vector<scene::FabricSpec> parameters_fabrics(const Parameters& parameters, const Scene& scene);

// The values that differ from `before`, as "fabric.wool.damping = 0.005 s and 2 more values".
std::string parameters_changes_text(const Parameters& parameters, const Scene& scene,
                                    const ParameterValues& before);

// Resets invalid values to those in force: single values out of their range, and whole diagrams that fall.
// One problem each.
void parameters_validate(Parameters& parameters, const Scene& scene, const ParameterValues& in_force,
                         std::vector<Problem>& problems);

// Resets all values whose names begin with `stem` to those in force. False where none of them differed.
bool parameters_restore(Parameters& parameters, const Scene& scene, const ParameterValues& in_force,
                        const std::string& stem);

}  // namespace drape::api
