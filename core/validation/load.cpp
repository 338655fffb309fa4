#include "validation/load.h"

#include "validation/checks.h"

namespace drape::validation {

Scene scene_load(const std::filesystem::path& file, std::vector<Problem>& problems) {
  scene::SceneText text = scene::scene_read(file);
  if (text.loaded) {
    std::vector<Problem> found;
    scene_check(text.scene, found);
    if (found.empty() && text.faults.found.empty()) scene_check_layout(text.scene, found);
    for (const Problem& p : found) scene::fault_add(text.faults, p.place, p.message);
  }
  scene::faults_report(text.faults, problems);
  return std::move(text.scene);
}

scene::FabricSpec fabric_load(const std::filesystem::path& file, std::vector<Problem>& problems,
                              scene::Corrections corrections) {
  scene::FabricFile text = scene::fabric_read(file, corrections);
  if (text.loaded) {
    std::vector<Problem> found;
    fabric_check({}, text.fabric, found);
    for (const Problem& p : found) scene::fault_add(text.faults, p.place, p.message);
  }
  scene::faults_report(text.faults, problems);
  return std::move(text.fabric);
}

}  // namespace drape::validation
