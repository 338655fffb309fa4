#include "model/composition.h"

namespace drape::model {
namespace {

// Order 4, four forces: I. P. Omelyan, I. M. Mryglod, R. Folk (2002), "Optimized Forest-Ruth- and Suzuki-like
// algorithms for integration of motion in many-body systems", Comput. Phys. Commun. 146, 188, the velocity
// version (VEFRL): kicks xi, chi, 1 - 2 (chi + xi), drifts (1 - 2 lambda)/2, lambda.
constexpr double kXi = 0.1644986515575760, kLambda = -0.02094333910398989, kChi = 1.235692651138917;
constexpr double kKick4[] = {kXi, kChi, 1 - 2 * (kChi + kXi), kChi, kXi};
constexpr double kDrift4[] = {(1 - 2 * kLambda) / 2, kLambda, kLambda, (1 - 2 * kLambda) / 2};

// Order 6, eleven forces: S. Blanes, P. C. Moan (2002), "Practical symplectic partitioned Runge-Kutta and
// Runge-Kutta-Nystroem methods", J. Comput. Appl. Math. 142, 313, table 3, SRKN_11^b.
constexpr double kB[] = {0.0414649985182624, 0.198128671918067, -0.0400061921041533, 0.0752539843015807,
                         -0.0115113874206879};
constexpr double kB6 = 0.5 - (kB[0] + kB[1] + kB[2] + kB[3] + kB[4]);
constexpr double kA[] = {0.123229775946271, 0.290553797799558, -0.127049212625417, -0.246331761062075,
                         0.357208872795928};
constexpr double kA6 = 1 - 2 * (kA[0] + kA[1] + kA[2] + kA[3] + kA[4]);
constexpr double kKick6[] = {kB[0], kB[1], kB[2], kB[3], kB[4], kB6, kB6, kB[4], kB[3], kB[2], kB[1], kB[0]};
constexpr double kDrift6[] = {kA[0], kA[1], kA[2], kA[3], kA[4], kA6, kA[4], kA[3], kA[2], kA[1], kA[0]};

// The limit is the smallest h omega at which the trace of one step of an oscillator leaves [-2, 2].
constexpr Composition kOrder4{4, 4, kKick4, kDrift4, 3.4696};
constexpr Composition kOrder6{6, 11, kKick6, kDrift6, 3.1414};  // NOLINT(modernize-use-std-numbers): not pi

}  // namespace

const Composition* composition_of(int order) {
  return order == 4 ? &kOrder4 : order == 6 ? &kOrder6 : nullptr;
}

}  // namespace drape::model
