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
#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "contact/particle/contact_pass.h"
#include "model/self_contact.h"
#include "model/system.h"

namespace drape::contact {

struct SelfContactPair {
  std::array<model::NodeIndex, 4> node;
  std::uint32_t candidate;  // its number in SelfState::pairs, points first
  bool cross, drop = false;
  double weight[4];                   // W
  double distance, contact_distance;  // m
  double start, final_distance;       // m, of the contact distance: at the start; after layers have parted
  Vec3 n;
  double share;  // of the penalty: 1, less for edges that hardly protrude
};

// Particles and triangles, and where they are closest: lanes of as many pairs.
struct alignas(math::kLine) SelfPointBlock {
  int node[4][math::kRowUnit];       // particle, corners of the triangle
  double weight[3][math::kRowUnit];  // of the corners in the closest point
  double arm[3][math::kRowUnit];     // m, from that point to the particle
  double distance[math::kRowUnit];   // m
};

// Sets all but the nodes of blocks, from the positions [nodes], m.
using SelfPointsKernel = void (*)(const double* const r[3], SelfPointBlock* begin, SelfPointBlock* end);

// The pairs that touch, and scratch to find them.
struct SelfContactPairs {
  std::vector<Vec3> place;            // [nodes] m, of particles
  std::vector<char> protrudes;        // [edges] whether they may protrude; 0: not yet known
  std::vector<std::uint32_t> point;   // numbers of the candidates that are examined
  std::vector<SelfPointBlock> block;  // of these
  std::vector<std::pair<std::size_t, double>>
      left;  // their numbers, and the travel at which they are due again, m
  std::vector<double> level_until, active, block_active;  // as in SelfState, where that is not written
  std::vector<model::NodeIndex> risen;                    // edges that can protrude since this step
  std::vector<std::uint32_t> woken;                       // crosses of these
  std::shared_ptr<const model::SelfPairs> of_edges;       // what the next two belong to
  std::vector<std::uint32_t> edge_start, edge_cross;      // crosses of edge e: edge_cross[edge_start[e]] ..
  std::vector<SelfContactPair> pair;
};

// Finds the pairs of a state that are nearer than their contact distance and `reach` (m), each local minimum
// of the distance once; points first, in the order of their nodes. With `schedule`, which is null or the
// state's own, records there after what travel each pair is to be examined again.
void self_narrow_phase(const System& system, const State& state, double reach, SelfPointsKernel points,
                       SelfContactPairs& pairs, model::SelfState* schedule);

// The reach (m) of a step of cloth that does not move: pairs as near are examined.
inline constexpr double kReachDistance = 0.1;  // of the largest contact distance
inline double self_still_reach(const System& system) { return kReachDistance * system.self.contact_distance; }

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
