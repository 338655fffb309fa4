#include <sstream>

#include "scene/document.h"
#include "scene/read.h"
#include "scene/rows.h"

namespace drape {

// Sheets become plain keys. Doubles are printed as the shortest decimal that gives the same double, so that
// nothing is lost on the way.
std::string scene_resolve(const std::filesystem::path& file, std::vector<Problem>& problems) {
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
  std::ostringstream text;
  text << document.root << '\n';
  return text.str();
}

}  // namespace drape
