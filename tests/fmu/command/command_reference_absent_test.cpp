// `drape reference` in a build without the reference solver.
#include <gtest/gtest.h>

#include "command/command.h"

namespace drape::command {

TEST(CommandReferenceAbsent, SaysHowToGetIt) {
  std::string words[] = {"drape", "reference", "scene.toml", "-o", "out", "--help"};
  char* arguments[] = {words[0].data(), words[1].data(), words[2].data(),
                       words[3].data(), words[4].data(), words[5].data()};
  testing::internal::CaptureStderr();
  EXPECT_EQ(line_run(6, arguments, {command_reference}), kBadInput);
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "error: this build has no reference; it comes with `bash tests/run.sh`, or with "
            "-DDRAPE_REFERENCE=ON for CMake\n");
}

}  // namespace drape::command
