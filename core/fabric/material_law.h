// The constitutive laws of a piece, force per width against strain, made from the diagrams of its fabric.
// core/README.md, section 3.
#pragma once
#include "math/monotone_curve.h"
#include "scene/scene.h"

namespace drape::fabric {

struct Law {
  double areal_density = 0;                   // kg/m^2
  math::Curve warp, weft, bias;               // N/m against strain
  double bending_warp = 0, bending_weft = 0;  // B, N m
  double damping = 0;                         // beta, s
};

inline bool law_bends(const Law& law) { return law.bending_warp > 0 || law.bending_weft > 0; }

// The options of a scene that affect every law.
struct LawOptions {
  scene::Scaling scaling = scene::Scaling::kWidth;
  scene::BiasModel bias_model = scene::BiasModel::kOdd;
  bool clamp_correction = true;
};

// True where the bias diagram is divided by the jaw factor K = r (r - 1.25)/(r - 1)^2, r = gauge/width. Jaws
// stiffen short strips, so K should increase as r decreases. The formula does so down to r = kMinJawRatio;
// below, it decreases to 0 at r = 1.25.
inline constexpr double kMinJawRatio = 5.0 / 3;
bool law_corrects_for_jaws(const scene::FabricSpec& fabric, const LawOptions& options);

// The law of a fabric on cells of edge length `cell` (m). `place` names the fabric in problems. A bias law
// that cannot be found is a problem, and is then off or not converged.
Law law_make(const scene::FabricSpec& stated, const LawOptions& options, double cell,
             const std::string& place, std::vector<Problem>& problems);

}  // namespace drape::fabric
