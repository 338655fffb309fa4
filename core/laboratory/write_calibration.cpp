#include "laboratory/write_calibration.h"

#include "laboratory/text_edits.h"

namespace drape::laboratory {
namespace {

// Corrections of diagrams from data sheets, which have no table of their own: by direction.
using SheetCorrections = std::vector<std::pair<std::string, std::vector<double>>>;

void calibration_set(Draft& draft, const toml::table& root, const Calibration& c, const std::string& date,
                     const SheetCorrections& sheets) {
  const std::string &text = draft.text, &newline = draft.newline;
  const std::pair<const char*, std::string> keys[] = {
      {"cell", six_digits(c.cell)}, {"residual", six_digits(c.residuals.back())}, {"date", '"' + date + '"'}};
  const toml::table* table = root["calibration"].as_table();
  if (!table) {
    const char* const units[] = {"   # m", "   # largest difference between simulated strips and diagrams",
                                 ""};
    std::string added = text.empty() || text.back() == '\n' ? "" : newline;
    added += newline + "# By drape fabric calibrate: where the corrections come from" + newline +
             "[calibration]" + newline;
    for (int k = 0; k < 3; ++k)
      added += std::string(keys[k].first) + " = " + keys[k].second + units[k] + newline;
    for (const auto& [name, values] : sheets)
      added += name + " = " + list_text(values, false, newline) + newline;
    draft.edits.push_back({text.size(), text.size(), added});
    return;
  }
  for (const auto& [key, value] : keys)
    if (const toml::node* there = table->get(key)) value_replace(draft, *there, value);
  for (const auto& [name, values] : sheets) key_set(draft, *table, "date", name, values);
}

}  // namespace

std::string write_calibration(const std::string& text, const Calibration& c, const std::string& date,
                              std::vector<Problem>& problems) {
  const model::YarnDirection directions[] = {model::YarnDirection::kWarp, model::YarnDirection::kWeft,
                                             model::YarnDirection::kBias};
  std::string stored;
  bool good = false;
  try {
    const toml::table root = toml::parse(text);
    Draft draft = draft_of(text);
    SheetCorrections sheets;
    for (model::YarnDirection along : directions) {
      const scene::DiagramSpec& d = strip_diagram(c.fabric, along);
      const toml::table* table = root[yarn_direction_name(along)].as_table();
      if (d.correction.empty()) continue;
      if (!table) {
        sheets.push_back({yarn_direction_name(along), d.correction});
        continue;
      }
      if (d.correction_elongation.empty()) key_remove(draft, *table, "correction_elongation");
      else key_set(draft, *table, d.force_as.key, "correction_elongation", d.correction_elongation);
      key_set(draft, *table, d.force_as.key, "correction", d.correction);
    }
    calibration_set(draft, root, c, date, sheets);
    stored = draft_text(draft);
    const toml::table after = toml::parse(stored);
    good = after["calibration"]["date"].value_or(std::string()) == date;
    for (model::YarnDirection along : directions) {
      const scene::DiagramSpec& d = strip_diagram(c.fabric, along);
      const bool sheet = !after[yarn_direction_name(along)].is_table();
      const char* name = yarn_direction_name(along);
      good = good && (sheet ? has_values(after["calibration"][name], d.correction)
                            : has_values(after[name]["correction"], d.correction) &&
                                  has_values(after[name]["correction_elongation"], d.correction_elongation));
    }
  } catch (const toml::parse_error&) {
    good = false;
  }
  if (good) return stored;
  problems.push_back({"fabric." + c.fabric.name,
                      "does not take corrections where its tables stand; wanted: "
                      "tables [warp], [weft] and [bias] with a key on each line"});
  return "";
}

}  // namespace drape::laboratory
