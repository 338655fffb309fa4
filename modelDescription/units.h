// The units of the variable table as exponents of the SI base units.
#pragma once

namespace drape {

struct Unit {
  const char* name;
  int kg, m, s;
};

inline constexpr Unit kUnits[] = {
    {"1", 0, 0, 0},    {"1/s", 0, 0, -1},  {"J", 1, 2, -2},     {"N", 1, 1, -2},
    {"N.m", 1, 2, -2}, {"N/m", 1, 0, -2},  {"kg/m2", 1, -2, 0}, {"m", 0, 1, 0},
    {"m/s", 0, 1, -1}, {"m/s2", 0, 1, -2}, {"s", 0, 0, 1},
};

}  // namespace drape
