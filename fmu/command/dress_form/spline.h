// A natural cubic spline: C2 through the points (t_k, y_k), without curvature at both ends. With h_k =
// t_{k+1} - t_k its second derivatives M solve
//
//   h_{k-1} M_{k-1} + 2 (h_{k-1} + h_k) M_k + h_k M_{k+1} = 6 [(y_{k+1} - y_k)/h_k - (y_k -
//   y_{k-1})/h_{k-1}],
//
// M_0 = M_n = 0, and between two points, with p = (t_{k+1} - t)/h_k and q = 1 - p,
//
//   y(t) = p y_k + q y_{k+1} + h_k^2/6 [(p^3 - p) M_k + (q^3 - q) M_{k+1}].
#pragma once
#include <vector>

namespace drape::command {

// M, by elimination (the matrix is tridiagonal and dominated by its diagonal).
inline std::vector<double> spline_fit(const std::vector<double>& t, const std::vector<double>& y) {
  const std::size_t n = t.size();
  std::vector<double> second(n, 0), diagonal(n, 1);
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const double before = t[k] - t[k - 1], after = t[k + 1] - t[k];
    const double factor = k > 1 ? before / diagonal[k - 1] : 0;
    diagonal[k] = 2 * (before + after) - factor * before;
    second[k] = 6 * ((y[k + 1] - y[k]) / after - (y[k] - y[k - 1]) / before) - factor * second[k - 1];
  }
  for (std::size_t k = n - 1; k-- > 1;)
    second[k] = (second[k] - (t[k + 1] - t[k]) * second[k + 1]) / diagonal[k];
  return second;
}

// y at a t of the piece from t_k to t_{k+1}.
inline double spline_at(const std::vector<double>& t, const std::vector<double>& y,
                        const std::vector<double>& second, std::size_t k, double at) {
  const double h = t[k + 1] - t[k], p = (t[k + 1] - at) / h, q = 1 - p;
  return p * y[k] + q * y[k + 1] +
         h * h / 6 * ((p * p * p - p) * second[k] + (q * q * q - q) * second[k + 1]);
}

}  // namespace drape::command
