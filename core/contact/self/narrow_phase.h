// Self-contact: cloth that touches cloth, at the kick of t_n. core/README.md, section 8.
//
// A pair is a weighted sum over four nodes with sum W_k = 0. It is a particle less its closest point on a
// triangle, W = (1, -w_a, -w_b, -w_c), or a point of an edge less one of another, W = (1 - s, s, -(1 - t),
// -t). Its arm is D = sum W_k r_k, with d = |D| and n = D/d. The arm is objective, and so is the motion of
// its end in a frame that turns with the cloth,
//
//   w = sum W_k v_k - omega x D,      omega = I^-1 sum u_k p_k x v_k,    I = sum u_k (p_k^2 - p_k p_k^T),
//
// where p_k are the positions of the nodes from their mean, over the triangle (u = 0, 1, 1, 1) or over both
// edges. An impulse J on w is f_k = W_k J - u_k [I^-1 (D x J)] x p_k on the nodes. For any J, sum f_k = 0 and
// sum r_k x f_k = 0. (For J along n, f_k = W_k J.)
#pragma once
#include <algorithm>

#include "contact/particle/contact_pass.h"
#include "model/self_contact.h"
#include "model/system.h"

namespace drape::contact {

// A node of pairs that touch.
struct SelfNode {
  model::NodeIndex node;
  bool fixed;             // a pin holds it
  double inverse, mass;   // 1/kg, kg of its inertia; the inverse of a fixed node is 0
  Vec3 old, v;            // m/s: v_{n-1/2}; free velocity, per what centred damping leaves
  Vec3 impulse{0, 0, 0};  // N s
};

struct SelfContactPair {
  std::array<model::NodeIndex, 4> node;
  bool cross, drop = false;
  double weight[4], turn[4];          // W, u
  double distance, contact_distance;  // m
  double start, final_distance;       // m, of the contact distance: at the start; after layers have parted
  Vec3 arm, n;
  double share;                             // of the penalty: 1, less for edges that hardly protrude
  double stiffness, drag;                   // N/m, N s/m: k and 2 zeta sqrt(k mu)
  double stick, slide;                      // coefficients of friction, static and kinetic
  bool stuck = false, slides = false;       // in the last step; now
  Vec3 hold{0, 0, 0};                       // N, friction of the last step
  int at[4];                                // index in SelfContactPairs::node
  double inverse_effective_mass;            // sum W_k^2/m_k
  Vec3 lever[4];                            // p_k
  double inverse[6];                        // I^-1: xx xy xz yy yz zz
  double normal = 0, stored = 0, stop = 0;  // N s
  double resist, before;                    // 2 zeta sqrt(k K) phi', 1/s; w_n of v_{n-1/2}
  Vec3 friction{0, 0, 0};                   // N s
};

// The pairs that touch, and scratch to find and solve them.
struct SelfContactPairs {
  std::vector<Vec3> place;      // [nodes] m, of particles
  std::vector<char> protrudes;  // [edges] whether they may protrude; 0: not yet known
  std::vector<SelfContactPair> pair;
  std::vector<SelfNode> node;
  std::vector<int> index;  // [nodes] in `node`, or -1
};

// Finds the pairs of a state that are nearer than their contact distance and `reach` (m), each local minimum
// of the distance once; points first, in the order of their nodes. With `schedule`, which is null or the
// state's own, records there after what travel each pair is to be examined again.
void self_narrow_phase(const System& system, const State& state, double reach, SelfContactPairs& pairs,
                       model::SelfState* schedule);

// Collects the nodes of the pairs, and computes all that does not depend on velocities. Removes pairs that
// pins hold on both sides. `inertia_of_fit`: with the inverse mass scales.
void self_prepare(const System& system, const State& state, bool inertia_of_fit, SelfContactPairs& pairs);

// Computes the impulses of all nodes in a kick. Needs old and v of the nodes. Sweeps over the pairs until the
// velocities change by less than `tolerance` of the first change, at most `sweeps` times.
void self_respond(const ContactCoefficients& c, double tolerance, int sweeps, SelfContactPairs& pairs);

// Energy (J, over ContactCoefficients::impulse) that damping, stops and friction have dissipated.
double self_dissipated(SelfContactPairs& pairs);

// Layers that start nearer than their contact distance part within this time: the distance that counts grows.
inline constexpr double kParting = 0.1;  // s

// The contact distance (m) of a pair at an age (s) of the state.
inline double self_contact_distance_at(double start, double final_distance, double age) {
  if (start == final_distance || age >= kParting) return final_distance;
  const double t = std::max(age, 0.0) / kParting;
  return start + (final_distance - start) * t * t * t * (10 + t * (6 * t - 15));
}

// Of the contact distance, which in self-contact is that of two layers.
inline constexpr double kSelfBlend = kContactBlend / 2;

}  // namespace drape::contact
