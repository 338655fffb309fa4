// The doors of a fabric file: figures as laboratory sheets state them. They are converted here, once, to the
// keys that a fabric file has without doors (`plain`), and these are read like any others: a resolved scene
// holds only plain keys, so that no mathematical library of another machine can change a bit.
#pragma once
#include <limits>
#include <string>
#include <vector>

#include "scene/reader/value_reader.h"
#include "standards/units.h"

namespace drape::scene {

struct FabricText;

inline constexpr double kNotStated = std::numeric_limits<double>::quiet_NaN();

struct KesText {  // in the units of the sheet; pairs are warp, weft
  double W = kNotStated, T0 = kNotStated, Fm = 500;
  Vec2 EMT{}, WT{}, LT{}, G{}, B{};
};

struct FastText {  // in the units of the sheet; pairs are warp, weft
  double W = kNotStated, T2 = kNotStated, T100 = kNotStated, EB5 = kNotStated;
  Vec2 C{}, E5{}, E20{}, E100{};
};

// Other keys for a diagram's lists.
struct OtherUnit {
  GivenAs as;
  double high;  // in the unit
};
inline constexpr OtherUnit kExtensions[] = {{{"extension_mm", "mm", 1e3}, 1e6},
                                            {{"extension_in", "in", 1 / standards::kInch}, 1e4}};
inline constexpr OtherUnit kForces[] = {{{"force_cN", "cN", 1e2}, 1e8},
                                        {{"force_daN", "daN", 0.1}, 1e5},
                                        {{"force_gf", "gf", 1 / standards::kGramForce}, 1e8},
                                        {{"force_kgf", "kgf", 1 / standards::kKilogramForce}, 1e5},
                                        {{"force_lbf", "lbf", 1 / standards::kPoundForce}, 2e5}};
inline constexpr const char* kDiagrams[] = {"warp", "weft", "bias"};

struct DiagramText {
  std::vector<double> extension[2];  // m, by kExtensions
  std::vector<double> force[5];      // N, by kForces
};

struct DatasheetText {
  KesText kes;
  FastText fast;
  DiagramText diagram[3];               // by kDiagrams
  Vec2 gost_mass{}, gost_deflection{};  // kg of five strips, m
  Vec2 bending_length{}, overhang{};    // m
  bool strip_by_name = false;
  std::vector<std::string> replaced;  // tables of the text that those of `plain` replace as a whole
  toml::table plain;                  // what the sheets say, by plain keys
};

// The rows of the doors; they stand beside the fabric's own.
std::vector<Key> datasheet_keys(FabricText& text);

// What the rows of a fabric leave open: each property stated once, figures that belong together, conversion.
void datasheet_convert(Faults& faults, const toml::table& table, const std::string& path, FabricText& text);

// Reads a fabric, sheets and all.
FabricText fabric_read(Faults& faults, const toml::table& table, const std::string& path);

// Puts plain keys in the place of the sheets.
void fabric_flatten(toml::table& table, const FabricText& text);

}  // namespace drape::scene
