#include "fmi2/slave.h"

#include <dlfcn.h>
#include <unistd.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "description.h"

namespace drape::fmi2 {
namespace {

Fmi2 load() {
  void* library = dlopen(DRAPE_FMI2_BINARY, RTLD_NOW | RTLD_LOCAL);
  if (!library) {
    std::fprintf(stderr, "%s\n", dlerror());
    std::abort();
  }
  Fmi2 f{};
  const auto find = [&](const char* name, auto*& function) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(library, name));
    if (!function) std::fprintf(stderr, "%s is not exported\n", name), std::abort();
  };
#define FIND(name) find("fmi2" #name, f.name)
  FIND(GetTypesPlatform), FIND(GetVersion), FIND(SetDebugLogging), FIND(Instantiate), FIND(FreeInstance);
  FIND(SetupExperiment), FIND(EnterInitializationMode), FIND(ExitInitializationMode), FIND(Terminate),
      FIND(Reset);
  FIND(GetReal), FIND(GetInteger), FIND(GetBoolean), FIND(GetString);
  FIND(SetReal), FIND(SetInteger), FIND(SetBoolean), FIND(SetString);
  FIND(GetFMUstate), FIND(SetFMUstate), FIND(FreeFMUstate);
  FIND(SerializedFMUstateSize), FIND(SerializeFMUstate), FIND(DeSerializeFMUstate);
  FIND(GetDirectionalDerivative), FIND(SetRealInputDerivatives), FIND(GetRealOutputDerivatives);
  FIND(DoStep), FIND(CancelStep);
  FIND(GetStatus), FIND(GetRealStatus), FIND(GetIntegerStatus), FIND(GetBooleanStatus), FIND(GetStringStatus);
  FIND(EnterEventMode), FIND(NewDiscreteStates), FIND(EnterContinuousTimeMode), FIND(CompletedIntegratorStep);
  FIND(SetTime), FIND(SetContinuousStates), FIND(GetDerivatives), FIND(GetEventIndicators);
  FIND(GetContinuousStates), FIND(GetNominalsOfContinuousStates);
#undef FIND
  return f;
}

Swatch make_swatch(description::Nodes nodes, const std::string& file = DRAPE_SAMPLES "/swatch.toml") {
  namespace fs = std::filesystem;
  drape_cloth* cloth = drape_open(file.c_str(), nullptr, nullptr);
  if (!cloth) std::fprintf(stderr, "cannot open %s\n", file.c_str()), std::abort();
  const description::Description d = description::description_of(cloth, nodes);
  const fs::path folder =
      fs::path(testing::TempDir()) / ("drape swatch " + d.guid);  // a space, to be percent-encoded
  fs::create_directories(folder);
  const fs::path own = folder / ("scene.toml." + std::to_string(getpid()));  // tests run side by side
  std::ofstream(own) << drape_scene_text(cloth);
  fs::rename(own, folder / "scene.toml");
  drape_close(cloth);
  Swatch s;
  s.guid = d.guid;
  s.resources = "file://";
  for (const char c : folder.string()) s.resources += c == ' ' ? "%20" : std::string(1, c);
  for (const description::Variable& v : d.table) s.names.push_back(v.name());
  return s;
}

void logger(fmi2ComponentEnvironment slave, fmi2String, fmi2Status status, fmi2String category,
            fmi2String format, ...) {
  char message[2000];
  std::va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(message, sizeof message, format, arguments);
  va_end(arguments);
  static_cast<Slave*>(slave)->log.push_back({status, category, message});
}

}  // namespace

const Fmi2& fmi2() {
  static const Fmi2 functions = load();
  return functions;
}

const Swatch& swatch(description::Nodes nodes) {
  static const Swatch none = make_swatch(description::Nodes::kNone),
                      outline = make_swatch(description::Nodes::kOutline),
                      all = make_swatch(description::Nodes::kAll);
  return nodes == description::Nodes::kNone ? none : nodes == description::Nodes::kOutline ? outline : all;
}

fmi2ValueReference Swatch::reference(const std::string& name) const {
  const auto row = std::find(names.begin(), names.end(), name);
  if (row == names.end()) ADD_FAILURE() << "no variable " << name;
  return fmi2ValueReference(row - names.begin() + 1);
}

const Swatch& flag() {
  static const Swatch made = make_swatch(description::Nodes::kAll, DRAPE_SAMPLES "/flag.toml");
  return made;
}

Swatch swatch_with(const std::string& from, const std::string& to) {
  std::ostringstream text;
  text << std::ifstream(DRAPE_SAMPLES "/swatch.toml").rdbuf();
  std::string scene = text.str();
  scene.replace(scene.find(from), from.size(), to);
  const std::string file = testing::TempDir() + "drape_swatch_" + std::to_string(getpid()) + ".toml";
  std::ofstream(file) << scene;
  Swatch made = make_swatch(description::Nodes::kNone, file);
  std::filesystem::remove(file);
  return made;
}

const Swatch& swatch_brittle() {
  static const Swatch brittle =
      swatch_with("[0, 1, 2, 5], force = [0, 2, 6, 30]", "[0, 1, 2, 2.00001], force = [0, 2, 6, 1e6]");
  return brittle;
}

Slave::Slave(const Swatch& of, bool logging_on)
    : callbacks{logger, nullptr, nullptr, nullptr, this}, cloth(&of) {
  component = fmi2().Instantiate("cloth", fmi2CoSimulation, of.guid.c_str(), of.resources.c_str(), &callbacks,
                                 fmi2False, logging_on);
}

Slave::Slave(const std::string& guid, const std::string& resources)
    : callbacks{logger, nullptr, nullptr, nullptr, this}, cloth(&swatch()) {
  component = fmi2().Instantiate("cloth", fmi2CoSimulation, guid.c_str(), resources.c_str(), &callbacks,
                                 fmi2False, fmi2False);
}

Slave::~Slave() { fmi2().FreeInstance(component); }

void Slave::initialize() const {
  ASSERT_NE(component, nullptr) << last_message();
  ASSERT_EQ(fmi2().SetupExperiment(component, fmi2False, 0, 0, fmi2False, 0), fmi2OK) << last_message();
  ASSERT_EQ(fmi2().EnterInitializationMode(component), fmi2OK) << last_message();
  ASSERT_EQ(fmi2().ExitInitializationMode(component), fmi2OK) << last_message();
}

fmi2Status Slave::set(const std::string& name, double value) const {
  const fmi2ValueReference reference = cloth->reference(name);
  return fmi2().SetReal(component, &reference, 1, &value);
}

double Slave::get(const std::string& name) const {
  const fmi2ValueReference reference = cloth->reference(name);
  double value = 0;
  EXPECT_EQ(fmi2().GetReal(component, &reference, 1, &value), fmi2OK) << last_message();
  return value;
}

fmi2Status Slave::set_rate(const std::string& name, double value, fmi2Integer order) const {
  const fmi2ValueReference reference = cloth->reference(name);
  return fmi2().SetRealInputDerivatives(component, &reference, 1, &order, &value);
}

std::vector<double> Slave::outputs() const {
  std::vector<fmi2ValueReference> references;
  const auto probe = std::find_if(cloth->names.begin(), cloth->names.end(),
                                  [](const std::string& name) { return name.starts_with("probe."); });
  const auto first = std::size_t(probe - cloth->names.begin()) + 1;  // the outputs, up to the end
  for (std::size_t reference = first; reference <= cloth->names.size(); ++reference)
    references.push_back(fmi2ValueReference(reference));
  std::vector<double> values(references.size());
  EXPECT_EQ(fmi2().GetReal(component, references.data(), references.size(), values.data()), fmi2OK)
      << last_message();
  return values;
}

void expect_sentence(Slave& slave, fmi2Status status, const std::vector<std::string>& words) {
  ASSERT_EQ(slave.log.size(), 1u) << slave.last_message();
  EXPECT_EQ(slave.log[0].status, status);
  EXPECT_EQ(slave.log[0].category, "logStatusError");
  for (const std::string& word : words)
    EXPECT_NE(slave.log[0].message.find(word), std::string::npos)
        << word << " is missing in: " << slave.log[0].message;
  slave.log.clear();
}

void expect_refused(Slave& slave, const std::string& name, double value,
                    const std::vector<std::string>& words) {
  const double before = slave.get(name);
  EXPECT_EQ(slave.set(name, value), fmi2Discard) << name << " = " << value;
  expect_sentence(slave, fmi2Discard, words);
  EXPECT_EQ(slave.get(name), before);
}

}  // namespace drape::fmi2
