// The data-sheet keys of a fabric file: figures as laboratory data sheets give them. They are converted once
// to the plain keys of a fabric file, which are then read like any others. A scene with inlined files has
// plain keys only, so the mathematical library of another machine cannot change its values by a bit.
#pragma once
#include <limits>
#include <string>
#include <vector>

#include "scene/reader/value_reader.h"
#include "standards/units.h"

namespace drape::scene {

struct FabricText;

inline constexpr double kNotStated = std::numeric_limits<double>::quiet_NaN();

// KES-F figures in the units of the data sheet; pairs are warp, weft.
struct KesText {
  double W = kNotStated, T0 = kNotStated, Fm = 500;
  Vec2 EMT{}, WT{}, LT{}, G{}, B{};
};

// FAST figures in the units of the data sheet; pairs are warp, weft.
struct FastText {
  double W = kNotStated, T2 = kNotStated, T100 = kNotStated, EB5 = kNotStated;
  Vec2 C{}, E5{}, E20{}, E100{};
};

// An alternative key and unit for a list of a diagram.
struct OtherUnit {
  GivenAs as;
  double high;  // largest allowed value, in the unit
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
  std::vector<double> extension[2];  // m, in the order of kExtensions
  std::vector<double> force[5];      // N, in the order of kForces
};

// The samples of a tester that a smoothed diagram keeps beside its points.
struct RawText {
  std::vector<double> percent, newtons;
  DiagramText other;  // in other units
};

struct DatasheetText {
  KesText kes;
  FastText fast;
  DiagramText diagram[3];  // in the order of kDiagrams
  RawText raw[3];
  Vec2 gost_mass{}, gost_deflection{};  // kg, mass of five strips; m
  Vec2 bending_length{}, overhang{};    // m
  bool strip_by_name = false;           // the strip was given as the name of a standard
  std::vector<std::string> replaced;    // tables of the text that are replaced as a whole by those of `plain`
  toml::table plain;                    // the data of the sheets, converted to plain keys
};

// The rows of the data-sheet keys, in addition to the plain rows of fabric_keys.
std::vector<Key> datasheet_keys(FabricText& text);

// Checks what single rows cannot: each property is given once, and figures that belong together are complete.
// Then converts the data sheets to plain keys.
void datasheet_convert(Faults& faults, const toml::table& table, const std::string& path, FabricText& text);

// Reads a fabric, including its data sheets.
FabricText fabric_read(Faults& faults, const toml::table& table, const std::string& path,
                       Diagrams diagrams = Diagrams::kFinished);

// Replaces the data-sheet keys of a table by plain keys.
void fabric_flatten(toml::table& table, const FabricText& text);

}  // namespace drape::scene
