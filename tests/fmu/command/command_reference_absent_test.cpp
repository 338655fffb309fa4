// `drape reference` in a build without the reference solver; linked with command_reference_absent.cpp alone.
#include <gtest/gtest.h>

#include <cstdio>

#include "command/command.h"

namespace drape::command {

int fail(ExitCode code, const std::string& sentence) {
  std::fprintf(stderr, "error: %s\n", sentence.c_str());
  return code;
}

TEST(CommandReferenceAbsent, ReportsHowToGetIt) {
  CLI::App app;
  int exit_code = kDone;
  command_reference(app, exit_code);
  testing::internal::CaptureStderr();
  app.parse("reference scene.toml -o out --help");
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "error: this build has no reference; configure with -DDRAPE_REFERENCE=ON\n");
  EXPECT_EQ(exit_code, kBadInput);
}

}  // namespace drape::command
