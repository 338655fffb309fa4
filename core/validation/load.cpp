#include "validation/load.h"

#include "scene/limits.h"
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

scene::FabricFile samples_load(const std::filesystem::path& file, std::vector<Problem>& problems) {
  scene::FabricFile text = scene::fabric_read(file, scene::Corrections::kDropped, scene::Diagrams::kSamples);
  const std::string path = "fabric." + text.fabric.name;
  const auto check = [&](const scene::DiagramSpec& d, const char* name) {
    const std::size_t e = d.elongation.size(), f = d.force.size();
    const std::string at = path + "." + name + ".";
    if (e > scene::kMaxSamples)
      scene::fault_add(
          text.faults, at + d.elongation_as.key,
          "has " + scene::entries_text(e) + "; allowed: at most " + std::to_string(scene::kMaxSamples));
    if (e > 0 && f > 0 && e != f)
      scene::fault_add(text.faults, at + d.force_as.key,
                       "has " + scene::entries_text(f) + ", " + d.elongation_as.key + " has " +
                           std::to_string(e) + "; wanted: as many");
  };
  if (text.loaded) {
    check(text.fabric.warp, "warp");
    check(text.fabric.weft, "weft");
    check(text.fabric.bias, "bias");
  }
  scene::faults_report(text.faults, problems);
  return text;
}

}  // namespace drape::validation
