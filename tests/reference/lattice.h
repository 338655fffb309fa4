// The cloth as explicit lists. Equations: core/README.md, sections 1 and 3. Particles are numbered piece by
// piece, row by row (j outer, i inner); nodes without mass are no particles.
#pragma once
#include <Eigen/Dense>
#include <string>
#include <vector>

#include "reference/curve.h"
#include "scene/scene.h"

namespace drape::reference {

// A law per width and where its test ended; a law switched off has a curve without points and no end.
struct Law {
  Curve curve;      // N/m over strain
  double test_end;  // last elongation of the diagram
};

struct Link {
  int i, j;
  double rest, width;  // m
  int law;             // index into Lattice::laws
};

struct Hinge {
  int i, j, k;   // x0, x1, x2 along a thread
  double kappa;  // N m
};

// A point of the cloth: sum_k weight[k] r(node[k]), zero weights left out.
struct Point {
  std::vector<int> node;
  std::vector<double> weight;
};

// A pin holds a point where it starts: sum_k weight[k] r(node[k]) = const.
struct Row {
  Point point;
  int pin;  // index into Lattice::pins
};

struct Lattice {
  int count = 0;                       // N
  std::vector<double> mass;            // [N] kg
  Eigen::VectorXd position, velocity;  // [3 N] at the start, before the pins act
  std::vector<Law> laws;
  std::vector<Link> warp, weft, bias;
  std::vector<Hinge> hinges;
  std::vector<Row> rows;
  std::vector<std::string> pins;
  std::vector<Point> probes;
  double cell = 0;  // m, the smallest of all pieces
};

Lattice lattice_make(const Scene& scene);

// sum_k weight[k] x(node[k]) of any field x [3 N].
Eigen::Vector3d point_value(const Point& point, const Eigen::VectorXd& x);

}  // namespace drape::reference
