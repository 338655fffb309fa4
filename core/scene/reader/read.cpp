#include "scene/reader/read.h"

#include <algorithm>
#include <set>

#include "scene/files.h"
#include "scene/reader/normalize.h"
#include "scene/reader/schema.h"
#include "scene/reader/table_reader.h"
#include "scene/spelling.h"

namespace drape::scene {

namespace {

std::vector<FabricSpec> fabrics_read(Faults& faults, const Document& document) {
  std::vector<FabricSpec> fabrics;
  const toml::node* node = document.root.get("fabric");
  if (!node) return fabrics;
  if (!node->is_table())
    return fault_add(faults, "fabric",
                     std::string("is ") + node_kind(*node) + "; wanted: tables [fabric.<name>]"),
           fabrics;
  for (auto&& [key, entry] : *node->as_table()) {
    const std::string name(key.str()), path = "fabric." + name;
    location_note(faults, path, entry);
    FabricSpec& fabric = fabrics.emplace_back();
    if (!name_fits(name)) fault_add(faults, path, kNameRule);
    if (!entry.is_table())
      fault_add(faults, path, std::string("is ") + node_kind(entry) + "; wanted: a table [" + path + "]");
    else if (!document.unread.contains(name)) fabric = fabric_read(faults, *entry.as_table(), path).spec;
    fabric.name = name;
  }
  return fabrics;
}

// Reads all tables of [[kind]]. `rows` gives the rows of one table; `normalize` checks and completes it after
// reading.
template <class Spec, class Rows, class Normalize>
std::vector<Spec> specs_read(Faults& faults, const toml::table& root, const std::string& kind, Rows rows,
                             Normalize normalize) {
  std::vector<Spec> specs;
  const toml::node* node = root.get(kind);
  if (!node) return specs;
  const toml::array* list = node->as_array();
  if (!list || !list->is_array_of_tables())
    return fault_add(faults, kind,
                     std::string("is ") + node_kind(*node) + "; wanted: tables [[" + kind + "]]"),
           specs;
  std::set<std::string> names;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const toml::table& table = *(*list)[i].as_table();
    const std::string name = table["name"].value_or(std::string());
    const bool again = !names.insert(name).second;
    const std::string path =
        name_fits(name) && !again ? kind + "." + name : kind + "[" + std::to_string(i) + "]";
    location_note(faults, path, table);
    Spec& spec = specs.emplace_back();
    keys_read(faults, table, path, rows(spec));
    normalize(table, path, spec);
    if (again && name_fits(name))
      fault_add(faults, path + ".name",
                "= " + in_quotes(name) + " is taken by another " + kind + "; names differ within a kind");
  }
  return specs;
}

template <class Spec>
std::vector<std::string> names_of(const std::vector<Spec>& specs) {
  std::vector<std::string> names;
  for (const Spec& spec : specs) names.push_back(spec.name);
  return names;
}

void document_read(Faults& faults, const Document& document, Scene& scene) {
  const toml::table& root = document.root;
  keys_read(faults, root, "", scene_keys(scene));
  scene.has_air = root["air"]["normal"] || root["air"]["tangential"];
  if (!root.contains("scene"))
    fault_add(faults, "scene.name", "is missing; wanted: a table [scene] with a name");

  scene.fabrics = fabrics_read(faults, document);
  const std::vector<std::string> fabrics = names_of(scene.fabrics);
  scene.pieces = specs_read<PieceSpec>(
      faults, root, "piece", [&](PieceSpec& p) { return piece_keys(p, fabrics); },
      [&](const toml::table& t, const std::string& path, PieceSpec& p) {
        piece_normalize(faults, t, path, p);
      });
  if (!root.contains("piece")) fault_add(faults, "piece", "is missing; wanted: at least one [[piece]]");

  const std::vector<std::string> pieces = names_of(scene.pieces);
  scene.pins = specs_read<PinSpec>(
      faults, root, "pin", [&](PinSpec& p) { return pin_keys(p, pieces); },
      [&](const toml::table& t, const std::string& path, PinSpec&) { pin_normalize(faults, t, path); });
  scene.seams = specs_read<SeamSpec>(
      faults, root, "seam", [&](SeamSpec& s) { return seam_keys(s, pieces); },
      [&](const toml::table& t, const std::string& path, SeamSpec&) { seam_normalize(faults, t, path); });
  const std::filesystem::path folder = path_of(faults.file).parent_path();
  BodyText text;
  scene.bodies = specs_read<BodySpec>(
      faults, root, "body", [&](BodySpec& b) { return body_keys(b, text = BodyText{}); },
      [&](const toml::table&, const std::string& path, BodySpec& b) {
        body_normalize(faults, path, folder, text, b);
      });
  scene.probes = specs_read<ProbeSpec>(
      faults, root, "probe", [&](ProbeSpec& p) { return probe_keys(p, pieces); },
      [](const toml::table&, const std::string&, ProbeSpec&) {});
}

}  // namespace

SceneText scene_read(const std::filesystem::path& file) {
  SceneText text;
  const Document document = document_load(file, text.faults);
  text.loaded = document.loaded;
  if (text.loaded) document_read(text.faults, document, text.scene);
  return text;
}

FabricFile fabric_read(const std::filesystem::path& file, Corrections corrections, Diagrams diagrams) {
  FabricFile text;
  Document document = document_load_file(file, text.faults);
  text.loaded = document.loaded;
  if (!text.loaded) return text;
  text.calibration_cell = document.root["calibration"]["cell"].value_or(0.0);
  if (corrections == Corrections::kDropped) calibration_drop(document.root);
  const std::string name = path_text(file.stem()), path = "fabric." + name;
  FabricText read = fabric_read(text.faults, document.root, path, diagrams);
  text.fabric = std::move(read.spec);
  text.fabric.name = name;
  std::move(std::begin(read.raw), std::end(read.raw), text.raw);
  if (document.root.contains("file"))
    fault_add(text.faults, path + ".file", "stands in a fabric file; a fabric file cannot name another one");
  return text;
}

std::string scene_location(const std::filesystem::path& file, const std::string& path) {
  return fault_place(scene_read(file).faults, path);
}

std::vector<std::filesystem::path> scene_files(const std::filesystem::path& file) {
  Faults faults;
  Document document = document_load(file, faults);
  std::vector<std::filesystem::path> files = document.files;
  if (toml::array* bodies = document.root["body"].as_array())
    for (toml::node& node : *bodies)
      if (const toml::table* body = node.as_table())
        if (const auto mesh = (*body)["mesh"].value<std::string>())
          files.push_back(file.parent_path() / path_of(*mesh));
  return files;
}

}  // namespace drape::scene
