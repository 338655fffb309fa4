#include "validation/load.h"

#include "validation/checks.h"

namespace drape {

Scene scene_load(const std::filesystem::path& file, std::vector<Problem>& problems) {
  SceneText text = scene_read(file);
  if (text.loaded) {
    std::vector<Problem> found;
    scene_check(text.scene, found);
    if (found.empty() && text.faults.found.empty()) scene_check_layout(text.scene, found);
    for (const Problem& p : found) fault_add(text.faults, p.place, p.message);
  }
  faults_report(text.faults, problems);
  return std::move(text.scene);
}

FabricSpec fabric_load(const std::filesystem::path& file, std::vector<Problem>& problems,
                       Corrections corrections) {
  FabricFile text = fabric_read(file, corrections);
  if (text.loaded) {
    std::vector<Problem> found;
    fabric_check({}, text.fabric, found);
    for (const Problem& p : found) fault_add(text.faults, p.place, p.message);
  }
  faults_report(text.faults, problems);
  return std::move(text.fabric);
}

}  // namespace drape
