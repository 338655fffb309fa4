// The cloth as explicit lists of elements. Equations: core/README.md, sections 1, 3 and 4. Particles are
// numbered piece by piece: row by row (j outer, i inner), then the piece's twins. Nodes without mass are not
// particles.
#pragma once
#include <Eigen/Dense>
#include <array>
#include <string>
#include <vector>

#include "reference/law.h"
#include "scene/scene.h"

namespace drape::reference {

struct Link {
  int i, j;
  double rest, width;  // m
  int law;             // index into Lattice::laws
};

struct Hinge {
  int i, j, k;   // x0, x1, x2 along a yarn
  double kappa;  // N m
};

// A hinge between the link from i, a held node or one behind a clamped edge, to j, and the direction D, which
// rotates with the pin.
struct ClampHinge {
  int i, j;
  double kappa;                                         // N m
  int pin;                                              // index into Lattice::pins
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  // unit vector D of the link at the start
};

struct Cell {
  std::array<int, 4> node;  // corners a, b, c, d
  double share;             // phi
};

// A point of the cloth: sum_k weight[k] r(node[k]), without zero weights.
struct Point {
  std::vector<int> node;
  std::vector<double> weight;
};

// A pin holds a point with start position X in the frame of the pin: sum_k weight[k] r(node[k]) = p + R (X -
// p_0).
struct Row {
  Point point;
  int pin;  // index into Lattice::pins
  Eigen::Vector3d start = Eigen::Vector3d::Zero();
};

struct Pin {
  std::string name;
  Eigen::Vector3d centre;  // p_0
  scene::Drive drive;
  bool clamp;
};

// Pairs of particles on two outlines.
struct Seam {
  std::string name;
  std::vector<std::array<Point, 2>> pairs;
  double closed_at, gap_tolerance, speed;   // s, m, m/s
  double pull;                              // w, 1/s
  std::vector<std::array<Point, 2>> inner;  // [pairs] outer points of the hinges
  std::vector<double> kappa;                // [pairs] N m
  bool linked, closed;                      // it has links along it; it is a ring
  double rest, width, tape;                 // m, m, N; of the links
  int law;                                  // of the links, index into Lattice::laws
};

struct Lattice {
  int count = 0;                       // N
  std::vector<double> mass;            // [N] kg
  Eigen::VectorXd position, velocity;  // [3 N] m, m/s, at the start, before the pins act
  std::vector<Law> laws;
  std::vector<Link> warp, weft, bias;
  std::vector<Hinge> hinges;
  std::vector<ClampHinge> clamps;
  std::vector<Cell> cells;  // for the air
  std::vector<Row> rows;
  std::vector<Pin> pins;
  std::vector<Point> probes;
  std::vector<Seam> seams;
  double cell = 0;  // m, smallest cell size of all pieces
};

Lattice lattice_make(const Scene& scene);

// sum_k weight[k] x(node[k]) for any field x [3 N].
Eigen::Vector3d point_value(const Point& point, const Eigen::VectorXd& x);

}  // namespace drape::reference
