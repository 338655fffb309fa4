// The `drape` command in a folder of its own, with the sample scene.
#pragma once
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace drape::command {

namespace fs = std::filesystem;

struct Done {
  int code;
  std::string text;  // standard output and error
};

class Command : public testing::Test {
 protected:
  fs::path folder;

  void SetUp() override {
    std::string name = (fs::path(testing::TempDir()) / "drape_command_XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder = name;
    fs::copy_file(DRAPE_SAMPLES "/swatch.toml", folder / "scene.toml");
  }
  void TearDown() override { fs::remove_all(folder); }

  Done drape(const std::string& arguments) const {
    const std::string line = "cd '" + folder.string() + "' && '" DRAPE_COMMAND "' " + arguments + " 2>&1";
    // NOLINTNEXTLINE(bugprone-command-processor): tests use the shell as people do
    std::FILE* pipe = popen(line.c_str(), "r");
    if (!pipe) return {-1, "no shell"};
    Done done{-1, ""};
    std::array<char, 1000> part;
    while (std::fgets(part.data(), part.size(), pipe)) done.text += part.data();
    const int status = pclose(pipe);
    if (WIFEXITED(status)) done.code = WEXITSTATUS(status);
    return done;
  }
  std::string text_of(const std::string& file) const {
    std::ifstream stream(folder / file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
  }
  std::vector<std::string> lines_of(const std::string& file) const {
    std::istringstream text(text_of(file));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    return lines;
  }
  // Expects a refusal with one sentence that contains these words.
  void expect_refused(const std::string& arguments, const std::vector<std::string>& words) const {
    const Done done = drape(arguments);
    EXPECT_EQ(done.code, 1) << done.text;
    EXPECT_EQ(std::count(done.text.begin(), done.text.end(), '\n'), 1) << done.text;
    for (const std::string& word : words)
      EXPECT_NE(done.text.find(word), std::string::npos) << word << " is missing in: " << done.text;
  }
};

}  // namespace drape::command
