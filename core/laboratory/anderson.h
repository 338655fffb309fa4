// Anderson's mixing (1965) for x = x + f(x): with the changes X and R of x and f over the last sweeps,
//
//     x <- x + f - (X + R) c,      c the least squares of |f - R c|,
//
// the plain sweep x <- x + f without what the ones before foretell.
#pragma once
#include <Eigen/Core>
#include <vector>

namespace drape::laboratory {

struct Anderson {
  std::vector<Eigen::VectorXd> x, left;  // [sweeps kept]
};

// The next x; keeps the present one, and f in `left`.
Eigen::VectorXd anderson_next(Anderson& mixing, const Eigen::VectorXd& x, const Eigen::VectorXd& left);

}  // namespace drape::laboratory
