// Anderson mixing (Anderson 1965) for the fixed point x = x + f(x). X and R are the changes of x and f over
// the last sweeps:
//
//     x <- x + f - (X + R) c,      c minimises |f - R c| (least squares)
//
// This is the plain sweep x <- x + f without the part that the previous sweeps predict.
#pragma once
#include <Eigen/Core>
#include <vector>

namespace drape::laboratory {

struct Anderson {
  std::vector<Eigen::VectorXd> x, residual;  // [stored sweeps] x and f
};

// Returns the next x, and stores the present x and residual f(x) in `mixing`.
Eigen::VectorXd anderson_next(Anderson& mixing, const Eigen::VectorXd& x, const Eigen::VectorXd& residual);

}  // namespace drape::laboratory
