#include "fmi_master.h"

#include <cmath>
#include <fstream>
#include <stdexcept>

#include "guid.h"

namespace drape::fuzz {

namespace fs = std::filesystem;

Resources resources_make(const fs::path& work, const std::string& scene) {
  const fs::path seeds = fs::path(DRAPE_SOURCE_DIR) / "tests/stress/fuzz/seeds",
                 folder = work / "resources" / scene;
  fs::create_directories(folder);
  for (const char* mesh : {"box.obj", "ball.obj"})
    fs::copy_file(seeds / mesh, folder / mesh, fs::copy_options::overwrite_existing);
  const fs::path given = folder / "given.toml";
  fs::copy_file(seeds / "fmi" / (scene + ".toml"), given, fs::copy_options::overwrite_existing);
  drape_cloth* cloth = drape_open(given.c_str(), nullptr, nullptr);
  if (!cloth) throw std::runtime_error("cannot open " + given.string());
  std::ofstream(folder / "scene.toml", std::ios::binary) << drape_scene_text(cloth);
  for (int k = 0; k < drape_file_count(cloth); ++k)
    fs::copy_file(drape_file_path(cloth, k), folder / drape_file_name(cloth, k),
                  fs::copy_options::overwrite_existing);
  constexpr description::Nodes kNodes = description::Nodes::kOutline;
  Resources made{folder.string(),
                 description::guid_of(description::guid_content(cloth), kNodes),
                 description::variables_of(cloth, kNodes),
                 {},
                 drape_communication(cloth)};
  for (const description::Variable& v : made.table) made.start.push_back(*v.value);
  drape_close(cloth);  // of the table only names, ranges and kinds are used from here on
  return made;
}

void fmi_logger(fmi2ComponentEnvironment sequence, fmi2String, fmi2Status status, fmi2String, fmi2String text,
                ...) {
  Sequence& s = *static_cast<Sequence*>(sequence);
  ++s.sentences;
  if (status >= fmi2Discard) s.outcome.sentences.push_back(text ? text : "");
}

fmi2Status called(Sequence& s, const Slave& slave, const char* name, fmi2Status status) {
  if (status > fmi2Warning && slave.component && s.callbacks.logger && s.sentences == 0)
    s.outcome.faults.push_back(std::string(name) + " was refused without a sentence");
  s.sentences = 0;
  return status;
}
namespace {

std::vector<fmi2ValueReference> outputs_of(const Resources& resources) {
  std::vector<fmi2ValueReference> references;
  for (std::size_t k = 0; k < resources.table.size(); ++k)
    if (resources.table[k].causality == description::Causality::kOutput)
      references.push_back(fmi2ValueReference(k + 1));
  return references;
}

}  // namespace

std::vector<double> outputs_read(Sequence& s, Slave& slave) {
  const std::vector<fmi2ValueReference> references = outputs_of(s.resources);
  std::vector<double> values(references.size());
  if (CALL(fmi2GetReal, references.data(), references.size(), values.data()) != fmi2OK) return {};
  for (std::size_t k = 0; k < values.size(); ++k)
    if (!std::isfinite(values[k]))
      s.outcome.faults.push_back(s.resources.table[references[k] - 1].name() + " is not finite");
  return values;
}

void slave_instantiate(Sequence& s, Slave& slave) {
  const Resources& r = s.resources;
  std::string name = "cloth", guid = r.guid, location = "file://" + r.folder;
  fmi2Type type = fmi2CoSimulation;
  const bool odd = s.random.chance(12);
  if (odd) {
    const char* const places[] = {"",
                                  "file:",
                                  "file://",
                                  "file:///nowhere",
                                  "http://example.org/x",
                                  "file:///%",
                                  "file:///%00",
                                  "file:///%FF%zz",
                                  "/",
                                  "\xFF\xFE"};
    if (s.random.chance(3)) location = s.random.pick(places);
    if (s.random.chance(3)) guid = std::string(s.random.below(5000), '%');
    if (s.random.chance(3)) name = s.random.chance(2) ? "" : "%s%n%d";
    if (s.random.chance(3)) type = fmi2ModelExchange;
  }
  const auto given = [&](const auto* argument) { return odd && s.random.chance(6) ? nullptr : argument; };
  slave = Slave{};
  slave.component = fmi2Instantiate(given(name.c_str()), type, given(guid.c_str()), given(location.c_str()),
                                    given(&s.callbacks), fmi2False, fmi2Boolean(s.random.below(2)));
  if (!odd && !slave.component)
    s.outcome.faults.push_back("a slave cannot be instantiated: " +
                               (s.outcome.sentences.empty() ? "" : s.outcome.sentences.back()));
  s.sentences = 0;
}

void slave_free(Sequence& s, Slave& slave) {
  fmi2FreeInstance(slave.component);
  slave = Slave{};
  s.sentences = 0;
}

}  // namespace drape::fuzz
