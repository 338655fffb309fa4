// The rows of the data-sheet keys, in the units of the data sheets.
#include <iterator>

#include "scene/limits.h"
#include "scene/reader/schema.h"
#include "standards/kes.h"
#include "standards/strip.h"

namespace drape::scene {

namespace {

constexpr const char* kPair = "[warp, weft]";
constexpr Range kPercents{0.01, 1e3}, kMillimetres{1e-3, 100};

Key strip_key(FabricText& t) {
  Choice choice;
  for (const standards::StripStandard& standard : standards::kStripStandards)
    choice.words.push_back(standard.name);
  choice.apply = [&t](int k) {
    t.spec.strip_width = standards::kStripStandards[k].width;
    t.spec.strip_gauge = standards::kStripStandards[k].gauge;
    t.datasheet.strip_by_name = true;
  };
  return {"strip", choice};
}

// samples: noise may take the numbers below 0.
template <std::size_t N>
void lists_add(std::vector<Key>& keys, const std::string& name, const OtherUnit (&units)[N],
               std::vector<double> (&lists)[N], bool samples) {
  for (std::size_t u = 0; u < N; ++u) {
    const GivenAs& as = units[u].as;
    const double high = units[u].high;
    keys.push_back(
        {name + "." + as.key, &lists[u], kOptional, {samples ? -high : 0, high}, as.unit, as.per_si});
  }
}

}  // namespace

std::vector<Key> datasheet_keys(FabricText& t) {
  KesText& kes = t.datasheet.kes;
  FastText& fast = t.datasheet.fast;
  const auto pair = [](Vec2& v) { return Pair{&v, kPair}; };
  std::vector<Key> keys = {
      strip_key(t),
      {"bending.gost_10550.mass_g", pair(t.datasheet.gost_mass), kRequired, {1e-3, 1e3}, "g", 1e3},
      {"bending.gost_10550.deflection_mm", pair(t.datasheet.gost_deflection), kRequired, {1, 69}, "mm", 1e3},
      {"bending.length_mm", pair(t.datasheet.bending_length), kOptional, {0.1, 100}, "mm", 1e3},
      {"bending.overhang_mm", pair(t.datasheet.overhang), kOptional, {0.2, 200}, "mm", 1e3},
      {"kes.W",
       &kes.W,
       kOptional,
       {kArealDensity.low / standards::kKesWeight, kArealDensity.high / standards::kKesWeight},
       "mg/cm^2"},
      {"kes.T0", &kes.T0, kOptional, kMillimetres, "mm"},
      {"kes.Fm", &kes.Fm, kOptional, {1, 1e5}, "gf/cm"},
      {"kes.EMT", pair(kes.EMT), kOptional, kPercents, "percent"},
      {"kes.WT", pair(kes.WT), kOptional, {0, 1e6, kAbove}, "gf cm/cm^2"},
      {"kes.LT", pair(kes.LT), kOptional, {standards::kKesLinearityLow, standards::kKesLinearityHigh}},
      {"kes.G", pair(kes.G), kOptional, {0, 1e3}, "gf/(cm deg)"},
      {"kes.B", pair(kes.B), kOptional, {0, 1e3}, "gf cm^2/cm"},
      {"fast.W", &fast.W, kOptional, {1e3 * kArealDensity.low, 1e3 * kArealDensity.high}, "g/m^2"},
      {"fast.T2", &fast.T2, kOptional, kMillimetres, "mm"},
      {"fast.T100", &fast.T100, kOptional, kMillimetres, "mm"},
      {"fast.C", pair(fast.C), kOptional, {0.1, 100}, "mm"},
      {"fast.E5", pair(fast.E5), kOptional, kPercents, "percent"},
      {"fast.E20", pair(fast.E20), kOptional, kPercents, "percent"},
      {"fast.E100", pair(fast.E100), kOptional, kPercents, "percent"},
      {"fast.EB5", &fast.EB5, kOptional, {0.1, 41}, "percent"},
  };
  for (std::size_t k = 0; k < std::size(kDiagrams); ++k) {
    const bool samples = t.diagrams == Diagrams::kSamples;
    DiagramText &diagram = t.datasheet.diagram[k], &raw = t.datasheet.raw[k].other;
    const std::string name = kDiagrams[k], beside = name + ".raw";
    lists_add(keys, name, kExtensions, diagram.extension, samples);
    lists_add(keys, name, kForces, diagram.force, samples);
    lists_add(keys, beside, kExtensions, raw.extension, true);
    lists_add(keys, beside, kForces, raw.force, true);
  }
  return keys;
}

}  // namespace drape::scene
