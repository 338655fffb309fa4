// Bodies that stay and have no friction, by a search through all triangles. Equations: core/README.md,
// section 7. Of several minima of the distance only the least is taken: bodies without grooves.
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
  double damping = 1;  // zeta
};

// What a particle's fabric does to surfaces.
struct Skin {
  double layer = 0, omega = 0;  // m, 1/s
};

struct Contact {
  std::vector<Obstacle> bodies;
  std::vector<Skin> skin;  // [N]
};

// Throws std::runtime_error, with a sentence, for bodies that move or rub and meshes that cannot be read.
Contact contact_make(const Scene& scene);

// Adds the normal forces to F [3 N]; the power that their damping takes, W.
double add_contact(const Lattice& lattice, const Contact& contact, const Eigen::VectorXd& r,
                   const Eigen::VectorXd& v, Eigen::VectorXd& F);

double contact_energy(const Lattice& lattice, const Contact& contact, const Eigen::VectorXd& r);  // J

// The number of particles that touch, and the greatest depth, m.
struct Touching {
  int count = 0;
  double depth = 0;
};
Touching touching(const Lattice& lattice, const Contact& contact, const Eigen::VectorXd& r);

}  // namespace drape::reference
