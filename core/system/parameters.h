// The tunable values of a cloth behind drape_parameters: storage, copies, checks.
#pragma once
#include "drape.h"
#include "system/system.h"

namespace drape {

// The numbers of drape_parameters in one flat run, so that copying, comparing and restoring them are loops.
struct ParameterValues {
  std::vector<double> value;
  bool operator==(const ParameterValues&) const = default;
};

// The struct handed to users and what it points to.
struct Parameters {
  drape_parameters shown{};
  std::vector<drape_fabric> fabrics;
  std::vector<std::vector<double>> elongation, force;  // [3 x fabrics] warp, weft, bias; without the origin
};

// Fills from a scene; the scene's fabric names must outlive the result, which must not move afterwards.
void parameters_make(Parameters& parameters, const Scene& scene, double step_max);

ParameterValues parameters_read(const Parameters& parameters);
void parameters_write(Parameters& parameters, const ParameterValues& values);

// The fabrics of the scene with the values of the parameters.
std::vector<FabricSpec> parameters_fabrics(const Parameters& parameters, const Scene& scene);

// Faults that no single value can show, and numbers that are not finite.
void parameters_check(const Parameters& parameters, const Scene& scene, std::vector<Problem>& problems);

}  // namespace drape
