// One pass over the particles near a body, as the kernels see it. The law is in response.h.
#pragma once
#include "model/contact.h"

namespace drape::contact {

inline constexpr double kContactBlend = 0.125;   // of the contact distance: depth where phi' reaches 1
inline constexpr double kContactDeepest = 0.9;   // of the contact distance: the largest depth allowed
inline constexpr double kContactPush = 0.2;      // of an excess depth, which one step removes
inline constexpr double kContactUnbound = 1e30;  // 1/s: a stop_rate that stops nothing

// What a kick does to the free velocity. Times are per mass, and per what damping takes out of v after the
// kick.
struct ContactCoefficients {
  double drift = 0;                   // s, of r = r_n + drift v
  double kick = 0;                    // s, of the penalty
  double old_time = 0, new_time = 0;  // s, of the normal damping at v_{n-1/2} and at v_{n+1/2}
  double stop_rate = 0;   // 1/s: after 1/stop_rate s a particle is not nearer than the stop allows
  double push_rate = 0;   // 1/s, the same of a particle that is nearer now
  double reach_time = 0;  // s, for which a particle is extrapolated to see whether it may touch
  double impulse = 1;     // factor from a change of velocity to an impulse, besides the mass
  double decay = 1;       // v <- decay v + kick a
  double warm_stop = 0;   // share of the impulse of a stop in the warm start: 1 in a fit, else 0
  double reported_share = 0,
         reported_centred = 1;  // v_n = (v_{n-1/2} + reported_share (v - decay v_{n-1/2}))/reported_centred
};

// What a pass writes if it moves the particles. Sticking and warm starts in the blocks become the present
// ones.
struct ContactMoves {
  model::ContactBlock* pool;  // of the body, as ContactBlocks::pool
  double* r[3];               // [nodes] m
};

// Input and output of one pass. Every pass changes v; only one with `moves` changes positions and blocks.
struct ContactPass {
  const model::BodyContact* body;
  const double* r[3];         // [nodes] m
  double* v[3];               // [nodes] m/s; or accelerations, m/s^2
  const ContactMoves* moves;  // null: the pass only reports
  const double* old;          // [blocks in order x 3 x kRowUnit] m/s, v_{n-1/2}; null: v stands for it
  const double *mass, *inverse_mass_scale;  // [nodes] kg; 1, or null for 1 everywhere
  const double* inverse_penalty_scale;  // [nodes] of the accelerations in a fit, whose penalties scale with
                                        // the inertia: the inverse mass scale; null: 1 everywhere
  const double* tied;  // [nodes] 1 where pins or welds tie a particle to others, else 0; or null
  char* touched;       // [nodes / kRowUnit] a pass that moves sets it where it changes tied nodes; or null
  const model::ContactLaw* law;  // [lattices]
  double damping;                // of the body, over the critical one
  ContactCoefficients c, reported;
  bool begins;  // first step of an advance: subtracts the half kick that the advance before has reported
  // Of particles that pins, welds or several surfaces share: the change of velocity that the last pass of the
  // step gave, x y z, m/s, and whether the particle stuck before the step.
  double* response;  // [blocks in order x kResponseRows x kRowUnit]
  bool on;           // goes on from the last pass: only such particles respond, and loads are what it adds
  double* change;    // m/s, raised to the largest change of a velocity by the pass
  double* sum;       // [6] force and torque on the body, as impulses, N s and N m s
  double* given;     // [blocks in order x kGivenRows x kRowUnit] for the energy balance; or null
};

// What the energy balance needs of a pass: the impulse on the body, the part of the impulse on the particle
// that the potential of the penalty gives (N s), and the velocity of the body there (m/s); x y z each.
inline constexpr std::size_t kGivenRows = 9;

inline constexpr std::size_t kResponseRows = 4;

inline constexpr std::size_t kProximityGroup = 64;  // nodes that share one group clearance

// Finds nodes whose neighbours have to be updated.
struct ProximityPass {
  model::BodyContact* body;   // its group_clearance is written
  const double *r[3], *v[3];  // [nodes] m, m/s
  double drift;               // s, for which the nodes have moved with v since the last pass; below 0: back
  double ahead;               // s, the next step
  std::size_t begin, end;     // nodes, multiples of kRowUnit
};

// One kernel for bodies that stay [0] and one for bodies that move [1].
struct ContactKernel {
  void (*run[2])(const ContactPass&);
  // Writes the first nodes of stale blocks to `stale` [nodes / kRowUnit] and returns their number.
  std::size_t (*update_proximity[2])(const ProximityPass&, std::size_t* stale);
};

}  // namespace drape::contact
