// One pass over the particles near a body, as the kernels see it: response.h.
#pragma once
#include "model/contact.h"

namespace drape::contact {

inline constexpr double kContactBlend = 0.125;   // of the layer: where the penalty reaches its slope
inline constexpr double kContactDeepest = 0.9;   // of the layer: no particle is pressed deeper
inline constexpr double kContactPush = 0.2;      // of what is deeper all the same, a step
inline constexpr double kContactUnbound = 1e30;  // 1/s, as a stop_rate: nothing stops

// What a kick does with the free velocity. Times are over mass and what is taken out of v after the kick.
struct ContactCoefficients {
  double drift = 0;                   // s, of r = r_n + drift v
  double kick = 0;                    // s, of the penalty
  double old_time = 0, new_time = 0;  // s, of the normal damping at v_{n-1/2} and at v_{n+1/2}
  double stop_rate = 0;   // 1/s, 1 over the time after which a particle is not nearer than it may be
  double push_rate = 0;   // 1/s, likewise of those that are
  double reach_time = 0;  // s, for which a particle may come nearer before it counts
  double impulse = 1;     // over mass and what is taken out of v after the kick
  double keep = 1;        // v <- keep v + kick a
  double reported_share = 0,
         reported_centred = 1;  // v_n = (v_{n-1/2} + told_share (v - keep v_{n-1/2}))/told_centred
};

// What a pass writes that moves the particles: their places, and what sticks and is warm-started of now.
struct ContactMoves {
  model::ContactBlock* pool;  // of the body, as ContactBlocks::pool
  double* r[3];               // [nodes] m
};

struct ContactPass {
  const model::BodyContact* body;
  const double* r[3];         // [nodes] m
  double* v[3];               // [nodes] m/s
  const ContactMoves* moves;  // null: the pass only reports
  const double* old;          // [blocks in order x 3 x kRowUnit] v_{n-1/2}; null: v stands for it
  const double *mass, *inverse_mass_scale;  // [nodes]; lightness: or null
  const double* stiff;  // [nodes] accelerations of a fit: the lightness, as its penalties go; or null
  const double* tied;   // [nodes] 1 where pins or welds tie a particle to others, else 0; or null
  char* hit;  // [nodes / kRowUnit] set where tied nodes have been touched by a pass that moves; or null
  const model::ContactLaw* law;  // [lattices]
  double damping;                // of the body
  ContactCoefficients c, reported;
  bool begins, energy;
  double* sum;  // [8] force, torque on the body (impulses), dissipated, input
};

inline constexpr std::size_t kProximityGroup = 64;  // nodes that are watched together
struct ProximityPass {
  model::BodyContact* body;   // its ease is written
  const double *r[3], *v[3];  // [nodes]
  double drift, ahead;     // s, how long they have moved with v since they were watched last (below 0: back);
                           // the next step
  std::size_t begin, end;  // nodes, multiples of kRowUnit
};

// Each of bodies that stay and of bodies that move.
struct ContactKernel {
  void (*run[2])(const ContactPass&);
  // The first nodes of the blocks to look at anew, into `due`; their number.
  std::size_t (*update_proximity[2])(const ProximityPass&, std::size_t* due);
};

}  // namespace drape::contact
