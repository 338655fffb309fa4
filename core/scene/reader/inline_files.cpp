#include <sstream>

#include "scene/files.h"
#include "scene/reader/document.h"
#include "scene/reader/read.h"
#include "scene/reader/schema.h"

namespace drape::scene {

std::string body_file(const std::string& name, const std::string& mesh) {
  return "body_" + name + path_text(path_of(mesh).extension());
}

// Data sheets become plain keys. Doubles are printed as the shortest decimals that give the same doubles, so
// that no value changes.
std::string scene_inline_files(const std::filesystem::path& file, std::vector<Problem>& problems) {
  Faults faults;
  Document document = document_load(file, faults);
  faults_report(faults, problems);
  if (!faults.found.empty()) return "";
  if (toml::table* fabrics = document.root["fabric"].as_table())
    for (auto&& [name, node] : *fabrics)
      if (toml::table* fabric = node.as_table()) {
        fabric->erase("file");
        fabric_flatten(*fabric, fabric_read(faults, *fabric, "fabric"));
      }
  if (toml::array* bodies = document.root["body"].as_array())
    for (toml::node& node : *bodies)
      if (toml::table* body = node.as_table())
        body->insert_or_assign("mesh", body_file((*body)["name"].value_or(""), (*body)["mesh"].value_or("")));
  std::ostringstream text;
  text << document.root << '\n';
  return text.str();
}

}  // namespace drape::scene
