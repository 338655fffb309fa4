// Where an instance cannot be made, one sentence gives the reason, and none is made.
#include <filesystem>
#include <fstream>

#include "fmi2/slave.h"

namespace drape::fmi2 {
namespace {

void expect_refused(Slave& slave, const std::vector<std::string>& words) {
  EXPECT_EQ(slave.component, nullptr);
  expect_sentence(slave, fmi2Error, words);
}

TEST(Instantiate, ReportsItsVersionAndPlatform) {
  EXPECT_STREQ(fmi2().GetVersion(), "2.0");
  EXPECT_STREQ(fmi2().GetTypesPlatform(), "default");
}

TEST(Instantiate, WrongGuid) {
  Slave slave("{00000000-0000-0000-0000-000000000000}", swatch().resources);
  expect_refused(slave, {"guid is {00000000-0000-0000-0000-000000000000}", "none, outline, all",
                         swatch(description::Nodes::kNone).guid, swatch(description::Nodes::kOutline).guid,
                         swatch(description::Nodes::kAll).guid});
}

TEST(Instantiate, MissingResources) {
  Slave slave(swatch().guid, "file:///no/such/folder");
  expect_refused(slave, {"/no/such/folder/scene.toml"});
}

TEST(Instantiate, ResourceLocationOfAnotherKind) {
  Slave slave(swatch().guid, "https://example.org/fmu/resources");
  expect_refused(slave, {"https://example.org/fmu/resources", "allowed", "file:"});
}

TEST(Instantiate, FaultyScene) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "drape_faulty_scene";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "scene.toml") << "[scene]\nnam = \"typing error\"\n";
  Slave slave(swatch().guid, folder.string());
  EXPECT_EQ(slave.component, nullptr);
  EXPECT_FALSE(slave.log.empty());
  for (const LogEntry& entry : slave.log) EXPECT_EQ(entry.status, fmi2Error) << entry.message;
}

TEST(Instantiate, MissingArguments) {
  Slave slave;  // for its logger
  const fmi2CallbackFunctions* callbacks = &slave.callbacks;
  const char *guid = swatch().guid.c_str(), *location = swatch().resources.c_str();
  const auto instantiate = [&](const char* name, fmi2Type type, const char* guid_given,
                               const char* location_given) {
    return fmi2().Instantiate(name, type, guid_given, location_given, callbacks, fmi2False, fmi2False);
  };
  EXPECT_EQ(instantiate(nullptr, fmi2CoSimulation, guid, location), nullptr);
  expect_sentence(slave, fmi2Error, {"name"});
  EXPECT_EQ(instantiate("", fmi2CoSimulation, guid, location), nullptr);
  expect_sentence(slave, fmi2Error, {"name"});
  EXPECT_EQ(instantiate("cloth", fmi2ModelExchange, guid, location), nullptr);
  expect_sentence(slave, fmi2Error, {"co-simulation"});
  EXPECT_EQ(instantiate("cloth", fmi2CoSimulation, nullptr, location), nullptr);
  expect_sentence(slave, fmi2Error, {"guid"});
  EXPECT_EQ(instantiate("cloth", fmi2CoSimulation, guid, nullptr), nullptr);
  expect_sentence(slave, fmi2Error, {"resource location"});
  callbacks = nullptr;
  EXPECT_EQ(instantiate("cloth", fmi2CoSimulation, guid, location), nullptr);
}

TEST(Instantiate, WithoutALogger) {
  fmi2CallbackFunctions callbacks{};
  fmi2Component c = fmi2().Instantiate("cloth", fmi2CoSimulation, swatch().guid.c_str(),
                                       swatch().resources.c_str(), &callbacks, fmi2False, fmi2True);
  ASSERT_NE(c, nullptr);
  EXPECT_EQ(fmi2().CancelStep(c), fmi2Error);
  fmi2().FreeInstance(c);
}

}  // namespace
}  // namespace drape::fmi2
