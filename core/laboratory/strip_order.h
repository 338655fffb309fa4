// The order of convergence p of a 45 degree strip, from its forces S on three cell sizes b.
//
//     S(b) = S + A b^p:     [S(b_0) - S(b_1)]/[S(b_1) - S(b_2)] = (b_0^p - b_1^p)/(b_1^p - b_2^p)
#pragma once
#include <array>

#include "laboratory/strip.h"

namespace drape::laboratory {

struct StripOrder {
  std::array<double, 3> cell{};  // m, about twice, once and half the requested cell size
  std::array<double, 3> off{};   // 1, largest |S/F - 1|, with F of the diagram
  double order = 0;              // p, from the largest relative changes of force; NaN where the changes grow
  bool has_order = false;        // false where twice the cell size leaves fewer than four cells across
  std::string why;               // the reason, where there is no order
};
StripOrder strip_order(const scene::FabricSpec& fabric, double cell, const std::vector<double>& elongation,
                       std::vector<Problem>& problems);

// p from the changes S(b_0) - S(b_1) and S(b_1) - S(b_2), for b_0 > b_1 > b_2. NaN where there is none.
double order_of(const std::array<double, 3>& b, double first, double second);

}  // namespace drape::laboratory
