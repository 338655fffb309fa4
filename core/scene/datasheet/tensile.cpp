// Conversion of data sheets to plain keys: warp, weft and bias.
#include <algorithm>
#include <cmath>

#include "scene/datasheet/conversion.h"
#include "standards/fast.h"
#include "standards/kes.h"
#include "standards/trellis.h"

namespace drape::scene {

namespace {

DiagramSpec& spec_of(FabricText& t, std::size_t k) {
  return k == 0 ? t.spec.warp : k == 1 ? t.spec.weft : t.spec.bias;
}

toml::array array_of(const std::vector<double>& values) {
  toml::array list;
  for (const double value : values) list.push_back(value);
  return list;
}

// Inserts a diagram computed from a data sheet. It replaces a diagram that the fabric file may have.
void diagram_insert(FabricText& t, std::size_t k, const standards::Diagram& d, bool jaws) {
  std::vector<double> force;
  for (const double f : d.force_per_width) force.push_back(f * t.spec.strip_width);
  toml::table diagram{{"elongation_percent", array_of(d.percent)}, {"force", array_of(force)}};
  if (!jaws) diagram.insert("jaws", false);
  if (!t.calibration[k].empty()) diagram.insert("correction", array_of(t.calibration[k]));
  spec_of(t, k) = {};
  t.datasheet.replaced.push_back(kDiagrams[k]);
  t.datasheet.plain.insert_or_assign(kDiagrams[k], diagram);
}

template <std::size_t N>
const GivenAs* given_as(const OtherUnit (&units)[N], const std::string& key, std::size_t& u) {
  for (u = 0; u < N; ++u)
    if (key == units[u].as.key) return &units[u].as;
  return nullptr;
}

toml::array percent_of(const std::vector<double>& extension, double gauge) {
  toml::array percent;
  for (const double e : extension) percent.push_back(100 * e / gauge);
  return percent;
}

// Checks that the elongation is at most 1000 percent, as for elongation_percent.
bool extension_fits(const Conversion& s, const std::string& key, const GivenAs& as,
                    const std::vector<double>& extension, double gauge) {
  constexpr double kMax = 10;
  bool fits = true;
  for (std::size_t i = 0; i < extension.size(); ++i) {
    if (100 * extension[i] / gauge <= 100 * kMax) continue;
    fault_at(s, key, i,
             "= " + rounded(extension[i] / gauge * as.per_si) + " " + as.unit + "; allowed: from 0 to " +
                 rounded(kMax * as.per_si) + " " + as.unit + ", ten times the gauge");
    fits = false;
  }
  return fits;
}

// Converts the lists of a diagram from the units in which they are given.
void lists_convert(const Conversion& s, FabricText& t, std::size_t k) {
  const std::string name = kDiagrams[k];
  if (const toml::node* table = stated(s, name); !table || !table->is_table()) return;
  std::vector<std::string> keys_e{name + ".elongation_percent"}, keys_f{name + ".force"};
  for (const OtherUnit& unit : kExtensions) keys_e.push_back(name + "." + unit.as.key);
  for (const OtherUnit& unit : kForces) keys_f.push_back(name + "." + unit.as.key);
  if (const std::string own = "calibration." + name; stated(s, own))
    fault_at(s, own, "belongs to a diagram from a sheet; wanted: " + name + ".correction");
  const std::string source_e = property_source(s, "elongation", keys_e),
                    source_f = property_source(s, "force", keys_f);
  if (source_e.empty()) missing(s, t, keys_e[0]);
  if (source_f.empty()) missing(s, t, keys_f[0]);

  toml::table plain;
  DiagramSpec& d = spec_of(t, k);
  std::size_t u;
  if (const GivenAs* as = given_as(kExtensions, source_e.substr(source_e.find('.') + 1), u)) {
    d.elongation_as = {as->key, as->unit, as->per_si * t.spec.strip_gauge};
    const std::vector<double>& extension = t.datasheet.diagram[k].extension[u];
    if (valid(s, source_e) && extension_fits(s, source_e, d.elongation_as, extension, t.spec.strip_gauge))
      plain.insert("elongation_percent", percent_of(extension, t.spec.strip_gauge));
  }
  if (const GivenAs* as = given_as(kForces, source_f.substr(source_f.find('.') + 1), u)) {
    d.force_as = *as;
    if (valid(s, source_f)) plain.insert("force", array_of(t.datasheet.diagram[k].force[u]));
  }
  if (!plain.empty()) t.datasheet.plain.insert_or_assign(name, plain);
}

// WT of direction k from WT or LT of the sheet; NaN where WT is not consistent with EMT.
double kes_energy_of(const Conversion& s, const KesText& kes, std::size_t k) {
  constexpr double kMeans = 0.05;  // tolerance: the mean of LT is not LT of the means; both are rounded
  const double emt = kes.EMT[k], fm = kes.Fm;
  if (!stated(s, "kes.WT")) return standards::kes_energy(emt, kes.LT[k], fm);
  const double wt = kes.WT[k], lt = standards::kes_linearity(emt, wt, fm);
  if (!(lt >= standards::kKesLinearityLow && lt <= standards::kKesLinearityHigh)) {
    const auto at = [&](double limit) { return rounded(standards::kes_energy(emt, limit, fm)); };
    fault_at(s, "kes.WT", k,
             "= " + number_text(wt) + " gf cm/cm^2 does not go with EMT = " + number_text(emt) +
                 " percent at " + number_text(fm) + " gf/cm; allowed: from " +
                 at(standards::kKesLinearityLow) + " to " + at(standards::kKesLinearityHigh) +
                 " gf cm/cm^2, for LT = 2 WT/(Fm EMT) from 0.2 to 1.8");
    return kNotStated;
  }
  if (stated(s, "kes.LT") && !(std::abs(kes.LT[k] / lt - 1) <= kMeans))
    fault_at(s, "kes.LT", k,
             "= " + number_text(kes.LT[k]) +
                 " does not go with WT and EMT, which give LT = 2 WT/(Fm EMT) = " + rounded(lt) +
                 "; allowed: within 5 percent of it");
  return wt;
}

void kes_convert(const Conversion& s, FabricText& t, std::size_t k) {
  for (const char* key : {"kes.EMT", "kes.WT", "kes.LT", "kes.Fm"})
    if (stated(s, key) && !valid(s, key)) return;
  if (!stated(s, "kes.WT") && !stated(s, "kes.LT")) return;
  const KesText& kes = t.datasheet.kes;
  const double wt = kes_energy_of(s, kes, k);
  if (!std::isnan(wt)) diagram_insert(t, k, standards::kes_tension(kes.EMT[k], wt, kes.Fm), true);
}

void fast_convert(const Conversion& s, FabricText& t, std::size_t k) {
  for (const char* key : {"fast.E5", "fast.E20", "fast.E100"})
    if (!valid(s, key)) return;
  const FastText& fast = t.datasheet.fast;
  const double e5 = fast.E5[k], e20 = fast.E20[k], e100 = fast.E100[k];
  const auto rises = [&](const char* key, double e, const char* before, double less) {
    if (e - less >= 1e-6) return true;
    fault_at(s, key, k,
             "= " + number_text(e) + " percent after " + before + " = " + number_text(less) +
                 " percent; wanted: a rise of at least 1e-06 percent");
    return false;
  };
  const bool first = rises("fast.E20", e20, "E5", e5), second = rises("fast.E100", e100, "E20", e20);
  if (first && second)
    diagram_insert(t, k,
                   {{0, e5, e20, e100}, {std::begin(standards::kFastForce), std::end(standards::kFastForce)}},
                   true);
}

// Reports keys of a diagram that are given without the diagram itself, while the data come from a sheet. True
// where there are any; the caller then skips the property.
bool stray_report(const Conversion& s, const std::string& name, const std::vector<std::string>& sheets) {
  const toml::node* node = stated(s, name);
  const auto sheet =
      std::find_if(sheets.begin(), sheets.end(), [&](const auto& key) { return stated(s, key); });
  if (!node || !node->is_table() || sheet == sheets.end()) return false;
  std::vector<std::string> strays;
  for (auto&& [key, value] : *node->as_table()) {
    const std::string k(key.str());
    if (k != "jaws" && k != "correction" && k != "correction_elongation") return false;
    strays.push_back(k);
  }
  for (const std::string& key : strays)
    fault_at(s, name + "." + key,
             "belongs to a diagram, but the " + name + " comes from " + *sheet + "; wanted: " + name +
                 ".elongation_percent and " + name + ".force beside it, or neither");
  return !strays.empty();
}

// Reports tensile figures whose companions are missing.
void companions_check(const Conversion& s, FabricText& t) {
  const bool work = stated(s, "kes.WT") || stated(s, "kes.LT");
  if (work && !stated(s, "kes.EMT")) missing(s, t, "kes.EMT");
  if (stated(s, "kes.EMT") && !work) missing(s, t, "kes.WT");
  if (stated(s, "fast.E5") || stated(s, "fast.E20") || stated(s, "fast.E100"))
    for (const char* key : {"fast.E5", "fast.E20", "fast.E100"})
      if (!stated(s, key)) missing(s, t, key);
}

}  // namespace

void tensile_convert(const Conversion& s, FabricText& t) {
  companions_check(s, t);
  for (std::size_t k = 0; k < 2; ++k) {
    const std::string name = kDiagrams[k];
    if (stray_report(s, name, {"kes.EMT", "fast.E100"})) continue;
    const std::string source = property_source(s, name + " tension", {name, "kes.EMT", "fast.E100"});
    if (source == name) lists_convert(s, t, k);
    else if (source == "kes.EMT") kes_convert(s, t, k);
    else if (source == "fast.E100") fast_convert(s, t, k);
  }
}

void shear_convert(const Conversion& s, FabricText& t) {
  if (stray_report(s, "bias", {"kes.G", "fast.EB5"})) return;
  const std::string source = property_source(s, "shear", {"bias", "kes.G", "fast.EB5"});
  if (source == "bias") return lists_convert(s, t, 2);
  if (!valid(s, source)) return;
  const Vec2& g = t.datasheet.kes.G;
  const double shear = source == "kes.G" ? (g[0] + g[1]) / 2 * standards::kKesShear
                                         : standards::fast_shear(t.datasheet.fast.EB5);
  diagram_insert(t, 2, standards::trellis_bias(shear), false);
}

}  // namespace drape::scene
