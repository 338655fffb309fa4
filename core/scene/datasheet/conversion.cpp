// Conversion of data sheets to plain keys: weight, thickness and bending. Tension and shear are in
// tensile.cpp.
#include "scene/datasheet/conversion.h"

#include <cmath>

#include "scene/limits.h"
#include "scene/reader/schema.h"
#include "standards/cantilever.h"
#include "standards/fast.h"
#include "standards/kes.h"

namespace drape::scene {

namespace {

constexpr double kMicroNcm2 = 1e10;  // uN cm^2 per N m^2

void weight_convert(const Conversion& s, FabricText& t) {
  const std::string source = property_source(s, "areal density", {"areal_density", "kes.W", "fast.W"});
  if (source.empty()) missing(s, t, "areal_density");
  if (!valid(s, source)) return;
  if (source == "kes.W") t.datasheet.plain.insert("areal_density", t.datasheet.kes.W * standards::kKesWeight);
  if (source == "fast.W") t.datasheet.plain.insert("areal_density", t.datasheet.fast.W / 1e3);
}

void thickness_convert(const Conversion& s, FabricText& t) {
  const FastText& fast = t.datasheet.fast;
  if (stated(s, "fast.T100") && !stated(s, "fast.T2")) missing(s, t, "fast.T2");
  if (valid(s, "fast.T2") && valid(s, "fast.T100") && fast.T100 > fast.T2)
    fault_at(s, "fast.T100",
             "= " + number_text(fast.T100) + " mm is more than T2, " + number_text(fast.T2) +
                 " mm; allowed: at most as much, since the pressure is higher");
  const std::string source = property_source(s, "thickness", {"thickness", "kes.T0", "fast.T2"});
  if (source.empty() && !stated(s, "fast.T100")) missing(s, t, "thickness");
  if (!valid(s, source)) return;
  if (source == "kes.T0") t.datasheet.plain.insert("thickness", t.datasheet.kes.T0 / 1e3);
  if (source == "fast.T2") t.datasheet.plain.insert("thickness", fast.T2 / 1e3);
}

// The areal density of the fabric after conversion, kg/m^2; 0 where there is no valid one.
double weight_of(const FabricText& t) {
  return t.datasheet.plain["areal_density"].value<double>().value_or(t.spec.areal_density);
}

// B (N m) of warp (k = 0) or weft (k = 1) from a data-sheet key.
double bending_of(const std::string& source, const FabricText& t, std::size_t k) {
  const DatasheetText& sheet = t.datasheet;
  if (source == "kes.B") return sheet.kes.B[k] * standards::kKesBending;
  if (source == "fast.C")
    return standards::fast_bending(std::isnan(sheet.fast.W) ? 1e3 * weight_of(t) : sheet.fast.W,
                                   sheet.fast.C[k]);
  if (source == "bending.length_mm")
    return standards::bending_length_rigidity(weight_of(t), sheet.bending_length[k]);
  if (source == "bending.overhang_mm")
    return standards::bending_length_rigidity(weight_of(t), sheet.overhang[k] / 2);
  return standards::gost_10550_rigidity(sheet.gost_mass[k], sheet.gost_deflection[k]) / standards::kGostWidth;
}

void bending_convert(const Conversion& s, FabricText& t) {
  const std::string plain = "bending.rigidity_uN_cm2";
  const std::string source = property_source(
      s, "bending rigidity",
      {plain, "bending.gost_10550", "bending.length_mm", "bending.overhang_mm", "kes.B", "fast.C"});
  const toml::node* table = stated(s, "bending");
  if (source.empty() && table && table->is_table()) missing(s, t, plain);
  if (source == plain || !valid(s, source)) return;
  if (stated(s, "bending.width") && same_text(s, "bending.width", source))
    return fault_at(s, "bending.width", "belongs to bending.rigidity_uN_cm2, not to " + source);
  toml::array rigidity;
  for (std::size_t k = 0; k < 2; ++k)
    rigidity.push_back(bending_of(source, t, k) * standards::kGostWidth * kMicroNcm2);
  t.datasheet.plain.insert("bending",
                           toml::table{{"rigidity_uN_cm2", rigidity}, {"width", standards::kGostWidth}});
}

}  // namespace

void missing(const Conversion& s, FabricText& t, const std::string& key) {
  for (const Key& row : fabric_keys(t))
    if (row.name == key) return fault_at(s, key, "is missing; wanted: " + key_expected(row));
}

void datasheet_convert(Faults& faults, const toml::table& table, const std::string& path, FabricText& text) {
  const Conversion s{faults, table, path};
  weight_convert(s, text);
  thickness_convert(s, text);
  if (text.datasheet.strip_by_name)
    text.datasheet.plain.insert(
        "strip", toml::table{{"width", text.spec.strip_width}, {"gauge", text.spec.strip_gauge}});
  tensile_convert(s, text);
  shear_convert(s, text);
  for (std::size_t k = 0; k < std::size(kDiagrams); ++k) raw_convert(s, text, k);
  bending_convert(s, text);
}

FabricText fabric_read(Faults& faults, const toml::table& table, const std::string& path, Diagrams diagrams) {
  FabricText text;
  text.diagrams = diagrams;
  keys_read(faults, table, path, fabric_keys(text));
  datasheet_convert(faults, table, path, text);
  keys_read(faults, text.datasheet.plain, path, fabric_keys(text));
  text.spec.bending_warp = text.rigidity[0] / text.bending_width;
  text.spec.bending_weft = text.rigidity[1] / text.bending_width;
  text.spec.bending_width = text.bending_width;
  return text;
}

void fabric_flatten(toml::table& table, const FabricText& text) {
  for (const char* sheet : {"kes", "fast"}) table.erase(sheet);
  for (const std::string& name : text.datasheet.replaced) table.erase(name);
  if (toml::table* calibration = table["calibration"].as_table())
    for (const char* name : kDiagrams) calibration->erase(name);
  if (text.datasheet.strip_by_name) table.erase("strip");
  if (toml::table* bending = table["bending"].as_table())
    for (const char* key : {"gost_10550", "length_mm", "overhang_mm"}) bending->erase(key);
  for (const char* name : kDiagrams)
    if (toml::table* diagram = table[name].as_table()) {
      diagram->erase("raw");
      for (const OtherUnit& unit : kExtensions) diagram->erase(unit.as.key);
      for (const OtherUnit& unit : kForces) diagram->erase(unit.as.key);
    }
  for (auto&& [key, node] : text.datasheet.plain) {
    toml::table* own = table[key.str()].as_table();
    if (!own || !node.is_table()) table.insert_or_assign(key.str(), node);
    else
      for (auto&& [inner, value] : *node.as_table()) own->insert_or_assign(inner.str(), value);
  }
}

}  // namespace drape::scene
