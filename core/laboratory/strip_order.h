// A 45 degree strip on three cells: how its forces change with the cell.
//
//     S(b) = S + A b^p:     [S(b_0) - S(b_1)]/[S(b_1) - S(b_2)] = (b_0^p - b_1^p)/(b_1^p - b_2^p)
#pragma once
#include <array>

#include "laboratory/strip.h"

namespace drape::laboratory {

struct StripOrder {
  std::array<double, 3> cell{};  // m, about twice, one and half the cell asked for
  std::array<double, 3> off{};   // the largest |S/F - 1|, F the diagram
  double order = 0;              // p of the largest changes over the force; not a number where they grow
  bool has_order = false;        // false: twice the cell leaves less than four across
  std::string why;               // where there is none
};
StripOrder strip_order(const scene::FabricSpec& fabric, double cell, const std::vector<double>& elongation,
                       std::vector<Problem>& problems);

// p of the changes S(b_0) - S(b_1) and S(b_1) - S(b_2), b falling.
double order_of(const std::array<double, 3>& cell, double first, double second);

}  // namespace drape::laboratory
