// Cloth that touches cloth, at the kick of t_n. core/README.md, section 8.
//
// A pair is a sum over four nodes, sum W_k = 0: a particle less its foot on a triangle, W = (1, -w_a, -w_b,
// -w_c), or a point of an edge less one of another, W = (1 - s, s, -(1 - t), -t). Its arm D = sum W_k r_k,
// d = |D|, n = D/d, is as objective as the motion of its end against a frame that turns with the cloth,
//
//   w = sum W_k v_k - omega x D,      omega = I^-1 sum u_k p_k x v_k,    I = sum u_k (p_k^2 - p_k p_k^T),
//
// p_k the places of nodes from their mean, over the triangle (u = 0, 1, 1, 1) or over both edges. An impulse
// J on w is f_k = W_k J - u_k [I^-1 (D x J)] x p_k on the nodes: sum f_k = 0 and sum r_k x f_k = 0, whatever
// J. (For J along n, f_k = W_k J.)
#pragma once
#include "contact/particle/contact_pass.h"
#include "model/self_contact.h"
#include "model/system.h"

namespace drape::contact {

// A node of pairs that touch. All are v_{n-1/2} or free velocities over what centred damping leaves.
struct SelfNode {
  model::NodeIndex node;
  bool fixed;             // a pin holds it
  double inverse, mass;   // 1/kg, kg of its inertia; a fixed node's inverse is 0
  Vec3 old, v;            // m/s
  Vec3 impulse{0, 0, 0};  // N s
};

struct SelfContactPair {
  std::array<model::NodeIndex, 4> node;
  bool cross, drop = false;
  double weight[4], turn[4];          // W, u
  double distance, contact_distance;  // m
  Vec3 arm, n;
  double share;                        // of the penalty, 1 but for edges that hardly stand out of the cloth
  double stiffness, drag;              // N/m, N s/m: k and 2 zeta sqrt(k mu)
  double stick, slide;                 // coefficients of friction
  bool stuck = false, slides = false;  // before; now
  Vec3 hold{0, 0, 0};                  // N, friction of the step before
  int at[4];                           // in SelfTouches::node
  double inverse_effective_mass;       // sum W_k^2/m_k
  Vec3 lever[4];                       // p_k
  double inverse[6];                   // I^-1: xx xy xz yy yz zz
  double normal = 0, stored = 0, stop = 0;  // N s
  double resist, before;                    // 2 zeta sqrt(k K) phi', 1/s; w_n of v_{n-1/2}
  Vec3 friction{0, 0, 0};                   // N s
};

struct SelfContactPairs {
  std::vector<Vec3> place;      // [nodes] m, of particles
  std::vector<char> protrudes;  // [edges] whether they may stand out, once somebody has asked
  std::vector<SelfContactPair> pair;
  std::vector<SelfNode> node;
  std::vector<int> index;  // [nodes] in `node`, or -1
};

// Finds the pairs of a state that are nearer than their layer and `reach` (m), each local minimum of the
// distance once; points first, in the order of their nodes. With `wake`, tells pairs when they are to be
// looked at again.
void self_narrow_phase(const System& system, const State& state, double reach, SelfContactPairs& touches,
                       model::SelfState* wake);

// Room for the nodes of `touch`, and all that does not depend on velocities.
void self_prepare(const System& system, const State& state, bool inertia_of_fit, SelfContactPairs& touches);

// What a kick gives: impulses of all nodes. Needs old and v of the nodes. Sweeps over the pairs until the
// velocities change by less than `settled` of the first change, `sweeps` times at most.
void self_respond(const ContactCoefficients& c, double settled, int sweeps, SelfContactPairs& touches);

// J that damping, stops and friction have taken.
double self_dissipated(const ContactCoefficients& c, SelfContactPairs& touches);

inline constexpr double kSelfBlend = kContactBlend / 2;  // of the layer, which is that of two cloths

}  // namespace drape::contact
