#include "laboratory/write_smoothed.h"

#include "laboratory/text_edits.h"
#include "scene/datasheet/datasheet.h"

namespace drape::laboratory {
namespace {

// The numbers of a list in the unit of its key.
std::vector<double> in_unit(const std::vector<double>& values, const scene::GivenAs& as) {
  std::vector<double> list;
  for (const double v : values) list.push_back(v * as.per_si);
  return list;
}

// Replaces the lists of a diagram. Those that stood there become `raw`, unless it holds one already. Its
// corrections go: they belong to other points.
bool diagram_replace(Draft& draft, const toml::table* table, const scene::DiagramSpec& d) {
  const toml::node* elongation = table ? table->get(d.elongation_as.key) : nullptr;
  const toml::node* force = table ? table->get(d.force_as.key) : nullptr;
  if (!elongation || !force) return false;
  if (!table->contains("raw"))
    key_add(draft, *table, d.force_as.key, "raw",
            std::string("{ ") + d.elongation_as.key + " = " + value_text(draft, *elongation) + ", " +
                d.force_as.key + " = " + value_text(draft, *force) + " }");
  const auto put = [&](const toml::node& node, const std::vector<double>& values, const scene::GivenAs& as) {
    value_replace(draft, node, list_text(in_unit(values, as), table->is_inline(), draft.newline));
  };
  put(*elongation, d.elongation, d.elongation_as);
  put(*force, d.force, d.force_as);
  for (const char* key : {"correction", "correction_elongation"}) key_remove(draft, *table, key);
  return true;
}

bool is_written(toml::node_view<const toml::node> table, const scene::DiagramSpec& d) {
  return has_values(table[d.elongation_as.key], in_unit(d.elongation, d.elongation_as)) &&
         has_values(table[d.force_as.key], in_unit(d.force, d.force_as)) && table["raw"].is_table() &&
         !table["correction"];
}

}  // namespace

std::array<bool, 3> diagrams_in_text(const std::string& text) {
  try {
    const toml::table root = toml::parse(text);
    std::array<bool, 3> there{};
    for (std::size_t k = 0; k < 3; ++k)
      if (const toml::table* table = root[scene::kDiagrams[k]].as_table()) {
        there[k] = table->contains("elongation_percent");
        for (const scene::OtherUnit& unit : scene::kExtensions)
          there[k] = there[k] || table->contains(unit.as.key);
      }
    return there;
  } catch (const toml::parse_error&) {
    return {};
  }
}

std::string write_smoothed(const std::string& text, const std::string& fabric,
                           const std::optional<scene::DiagramSpec> (&diagrams)[3],
                           std::vector<Problem>& problems) {
  std::string stored;
  bool good = true;
  try {
    const toml::table root = toml::parse(text);
    Draft draft = draft_of(text);
    for (int k = 0; k < 3; ++k)
      if (const std::optional<scene::DiagramSpec>& d = diagrams[k])
        good = good && diagram_replace(draft, root[scene::kDiagrams[k]].as_table(), *d);
    stored = draft_text(draft);
    const toml::table after = toml::parse(stored);
    const toml::node_view<const toml::node> tables(after);
    for (int k = 0; k < 3; ++k)
      if (const std::optional<scene::DiagramSpec>& d = diagrams[k])
        good = good && is_written(tables[scene::kDiagrams[k]], *d);
  } catch (const toml::parse_error&) {
    good = false;
  }
  if (good) return stored;
  problems.push_back({"fabric." + fabric,
                      "does not take smoothed diagrams where its tables stand; wanted: tables [warp], [weft] "
                      "and [bias] with a key on each line"});
  return "";
}

}  // namespace drape::laboratory
