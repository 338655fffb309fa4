// The strip specimens of the standards for tensile tests.
#pragma once

namespace drape::standards {

// Width and distance between the jaws (gauge), m. GOST 3813: the small strip is for scarce cloth. ISO
// 13934-1: 200 mm for cloth that breaks at up to 75 % of elongation, 100 mm beyond. ASTM D5035: 1 and 2 are
// the width in inches, R is ravelled, C is cut; the figures are the standard's own metric ones.
struct StripStandard {
  const char* name;
  double width, gauge;
};

inline constexpr StripStandard kStripStandards[] = {
    {"GOST 3813", 0.05, 0.2},       {"GOST 3813 wool", 0.05, 0.1},     {"GOST 3813 small", 0.025, 0.05},
    {"ISO 13934-1", 0.05, 0.2},     {"ISO 13934-1 100 mm", 0.05, 0.1}, {"ASTM D5035 1R", 0.025, 0.075},
    {"ASTM D5035 2R", 0.05, 0.075}, {"ASTM D5035 1C", 0.025, 0.075},   {"ASTM D5035 2C", 0.05, 0.075},
};

}  // namespace drape::standards
