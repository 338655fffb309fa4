// Contact with fixed bodies without friction, by a search through all triangles. Equations: core/README.md,
// section 7. Only the nearest point of a body is used, not further local minima of the distance: for bodies
// without grooves.
#pragma once
#include <Eigen/Dense>
#include <array>
#include <string>
#include <vector>

#include "reference/lattice.h"

namespace drape::reference {

struct Obstacle {
  std::vector<Eigen::Vector3d> point;
  std::vector<std::array<int, 3>> corner;
  double damping = 1;  // zeta, 1
};

// The contact law of a particle.
struct Skin {
  double contact_distance = 0, omega = 0;  // m, 1/s
};

struct Contact {
  std::vector<Obstacle> bodies;
  std::vector<Skin> skin;  // [N]
};

// Throws std::runtime_error, with one sentence, for self contact, bodies that move or have friction, and
// meshes that cannot be read.
Contact contact_make(const Scene& scene);

// Adds the normal forces to F [3 N], N. Returns the power that their damping dissipates, W.
double add_contact(const Lattice& lattice, const Contact& contact, const Eigen::VectorXd& r,
                   const Eigen::VectorXd& v, Eigen::VectorXd& F);

double contact_energy(const Lattice& lattice, const Contact& contact, const Eigen::VectorXd& r);  // J

// The number of particles in contact, and the largest depth, m.
struct ContactSummary {
  int count = 0;
  double depth = 0;
};
ContactSummary contact_summary(const Lattice& lattice, const Contact& contact, const Eigen::VectorXd& r);

}  // namespace drape::reference
