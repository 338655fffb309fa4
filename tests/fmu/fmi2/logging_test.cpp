// Log categories: refusals are always logged, other messages as the master asks.
#include <algorithm>

#include "fmi2/slave.h"

namespace drape::fmi2 {
namespace {

TEST(Logging, UnknownCategoryIsRefused) {
  Slave slave;
  const fmi2String categories[] = {"logEvents", "logEverything"};
  EXPECT_EQ(fmi2().SetDebugLogging(slave.component, fmi2True, 2, categories), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"logEverything", "allowed", "logStatusError", "logStability"});
  EXPECT_EQ(fmi2().SetDebugLogging(slave.component, fmi2True, 1, nullptr), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"missing"});
}

TEST(Logging, RefusalsPassEveryFilter) {
  Slave slave;
  ASSERT_EQ(fmi2().SetDebugLogging(slave.component, fmi2False, 0, nullptr), fmi2OK);
  EXPECT_EQ(slave.set("damping", -1), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"damping"});
}

// The end of initialization reports the step limit; so does a stiffer warp, which shortens the step.
TEST(Logging, CategoriesAreObeyed) {
  const auto categories_logged = [](bool on, std::vector<fmi2String> categories) {
    Slave slave;
    EXPECT_EQ(fmi2().SetDebugLogging(slave.component, on, categories.size(), categories.data()), fmi2OK);
    slave.initialize();
    EXPECT_EQ(slave.step(0, 0.001), fmi2OK);
    for (const char* point : {"1", "2", "3"}) {
      const std::string force = std::string("fabric.wool.warp.force[") + point + "]";
      EXPECT_EQ(slave.set(force, 16 * slave.get(force)), fmi2OK);
    }
    EXPECT_EQ(slave.step(0.001, 0.01), fmi2OK);
    std::vector<std::string> logged;
    for (const LogEntry& entry : slave.log) {
      EXPECT_EQ(entry.status, entry.category == "logStatusWarning" ? fmi2Warning : fmi2OK) << entry.message;
      logged.push_back(entry.category);
    }
    return logged;
  };
  const std::vector<std::string> all = categories_logged(true, {});
  const std::vector<std::string> stability = categories_logged(true, {"logStability"});
  EXPECT_EQ(stability.size(), 2u);
  EXPECT_EQ(std::size_t(std::count(all.begin(), all.end(), "logStability")), stability.size());
  EXPECT_EQ(std::size_t(std::count(stability.begin(), stability.end(), "logStability")), stability.size());
  for (const std::string& category : categories_logged(true, {"logEvents"})) EXPECT_EQ(category, "logEvents");
  for (const std::string& category : categories_logged(false, {})) EXPECT_EQ(category, "logStatusWarning");
}

}  // namespace
}  // namespace drape::fmi2
