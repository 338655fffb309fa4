// From a fabric's diagrams to the laws of a piece: force per width against strain. core/README.md, section 3.
#pragma once
#include "math/monotone_curve.h"
#include "scene/scene.h"

namespace drape::fabric {

struct Law {
  double areal_density = 0;                   // kg/m^2
  math::Curve warp, weft, bias;               // N/m over strain
  double bending_warp = 0, bending_weft = 0;  // B, N m
  double damping = 0;                         // beta, s
};

inline bool law_bends(const Law& law) { return law.bending_warp > 0 || law.bending_weft > 0; }

// The choices of a scene that shape every law.
struct LawOptions {
  scene::Scaling scaling = scene::Scaling::kWidth;
  scene::BiasModel bias_model = scene::BiasModel::kOdd;
  bool clamp_correction = true;
};

// True where the diagram of bias is divided by K = r (r - 1.25)/(r - 1)^2, r = gauge/width. As a factor of
// jaws it rises as strips get shorter, down to r = kJawRatioLeast; from there on it falls, to 0 at 1.25.
inline constexpr double kMinJawRatio = 5.0 / 3;
bool law_takes_jaws_out(const scene::FabricSpec& fabric, const LawOptions& options);

// The law of a fabric on cells of edge `cell`. `place` names the fabric in problems.
Law law_make(const scene::FabricSpec& fabric, const LawOptions& options, double cell,
             const std::string& place, std::vector<Problem>& problems);

}  // namespace drape::fabric
