// The samples of a tensile tester that a smoothed diagram keeps beside its points.
#include <algorithm>

#include "scene/datasheet/conversion.h"
#include "scene/limits.h"

namespace drape::scene {

namespace {

// A list of samples and the key that it was given by.
struct GivenList {
  const std::vector<double>* values = nullptr;
  GivenAs as{};
};

// The list that the text gives, of a plain one and of those in other units. Reports two of them, or none.
template <std::size_t N>
GivenList list_given(const Conversion& s, FabricText& t, const std::string& table, const GivenList& plain,
                     const OtherUnit (&units)[N], const std::vector<double> (&lists)[N]) {
  std::vector<std::string> keys{table + "." + plain.as.key};
  for (const OtherUnit& unit : units) keys.push_back(table + "." + unit.as.key);
  const std::string source = property_source(s, "samples of " + table, keys);
  if (source.empty()) return missing(s, t, keys[0]), GivenList{};
  if (!valid(s, source)) return {};
  for (std::size_t u = 0; u < N; ++u)
    if (source == keys[u + 1]) return {&lists[u], units[u].as};
  return plain;
}

}  // namespace

void raw_convert(const Conversion& s, FabricText& t, std::size_t k) {
  const std::string table = std::string(kDiagrams[k]) + ".raw";
  const toml::node* node = stated(s, table);
  if (!node || !node->is_table()) return;
  const RawText& raw = t.datasheet.raw[k];
  const DiagramSpec plain;
  const GivenList elongation =
      list_given(s, t, table, {&raw.percent, plain.elongation_as}, kExtensions, raw.other.extension);
  const GivenList force = list_given(s, t, table, {&raw.newtons, plain.force_as}, kForces, raw.other.force);
  if (!elongation.values || !force.values) return;
  const std::size_t count = elongation.values->size();
  if (count != force.values->size())
    fault_at(s, table + "." + force.as.key,
             "has " + entries_text(force.values->size()) + ", " + elongation.as.key + " has " +
                 std::to_string(count) + "; wanted: as many");
  if (count < kMinSamples || count > kMaxSamples)
    fault_at(s, table + "." + elongation.as.key,
             "has " + entries_text(count) + "; allowed: " + std::to_string(kMinSamples) + " to " +
                 std::to_string(kMaxSamples));
  DiagramSpec& to = t.raw[k];
  to.elongation = *elongation.values;
  to.force = *force.values;
  to.force_as = force.as;
  to.elongation_as = elongation.as;
  if (elongation.values == &raw.percent) return;
  to.elongation_as.per_si *= t.spec.strip_gauge;
  for (double& e : to.elongation) e /= t.spec.strip_gauge;
}

}  // namespace drape::scene
