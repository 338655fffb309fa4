// The units of the variable table as exponents of the SI base units.
#pragma once

namespace drape::description {

struct Unit {
  const char* name;
  int kg, m, s, rad;
};

inline constexpr Unit kUnits[] = {
    {"1", 0, 0, 0, 0},    {"1/s", 0, 0, -1, 0}, {"J", 1, 2, -2, 0},    {"N", 1, 1, -2, 0},
    {"N.m", 1, 2, -2, 0}, {"N/m", 1, 0, -2, 0}, {"Pa", 1, -1, -2, 0},  {"kg/m2", 1, -2, 0, 0},
    {"m", 0, 1, 0, 0},    {"m/s", 0, 1, -1, 0}, {"m/s2", 0, 1, -2, 0}, {"rad/s", 0, 0, -1, 1},
    {"s", 0, 0, 1, 0},
};

}  // namespace drape::description
