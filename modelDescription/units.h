// The units of the variable table as exponents of the SI base units.
#pragma once

namespace drape::description {

// `nominal`: the usual size of its variables, for solvers that scale.
struct Unit {
  const char* name;
  int kg, m, s, rad;
  double nominal;
};

inline constexpr Unit kUnits[] = {
    {"1", 0, 0, 0, 0, 1},       {"1/s", 0, 0, -1, 0, 1},     {"J", 1, 2, -2, 0, 0.01},
    {"N", 1, 1, -2, 0, 1},      {"N.m", 1, 2, -2, 0, 0.1},   {"N/m", 1, 0, -2, 0, 100},
    {"Pa", 1, -1, -2, 0, 1000}, {"kg/m2", 1, -2, 0, 0, 0.1}, {"m", 0, 1, 0, 0, 0.1},
    {"m/s", 0, 1, -1, 0, 1},    {"m/s2", 0, 1, -2, 0, 10},   {"rad/s", 0, 0, -1, 1, 1},
    {"s", 0, 0, 1, 0, 0.001},
};

// A unit in which people read a value: the value times `factor`.
struct DisplayUnit {
  const char *name, *unit;
  double factor;
};
inline constexpr DisplayUnit kDisplayUnits[] = {
    {"%", "1", 100}, {"mm", "m", 1000}, {"deg/s", "rad/s", 57.29577951308232}};

}  // namespace drape::description
