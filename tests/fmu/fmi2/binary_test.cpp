// What the binary exports and needs: the functions of the standard, and the C library.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <string>
#include <vector>

namespace drape::fmi2 {
namespace {

std::vector<std::string> lines_of(const std::string& command) {
  std::vector<std::string> lines;
  // NOLINTNEXTLINE(bugprone-command-processor): the commands are the tests' own
  std::FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) return lines;
  std::array<char, 4096> line;
  while (std::fgets(line.data(), line.size(), pipe)) lines.emplace_back(line.data());
  EXPECT_EQ(pclose(pipe), 0) << command;
  return lines;
}

TEST(Binary, ExportsFmi2FunctionsOnly) {
  const std::vector<std::string> symbols = lines_of("nm -D --defined-only '" DRAPE_FMI2_BINARY "'");
  EXPECT_EQ(symbols.size(), 44u);  // 25 common, 10 of model exchange, 9 of co-simulation
  for (const std::string& symbol : symbols) EXPECT_NE(symbol.find(" T fmi2"), std::string::npos) << symbol;
}

TEST(Binary, NeedsTheCLibraryOnly) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer's runtime is a library of its own";
#endif
  int needed = 0;
  for (const std::string& line : lines_of("readelf -d '" DRAPE_FMI2_BINARY "'")) {
    if (line.find("(NEEDED)") == std::string::npos) continue;
    ++needed;
    const bool of_glibc = line.find("[libc.so.6]") != std::string::npos ||
                          line.find("[libm.so.6]") != std::string::npos ||
                          line.find("[ld-linux-x86-64.so.2]") != std::string::npos;
    EXPECT_TRUE(of_glibc) << line;
  }
  EXPECT_GT(needed, 0);
}

}  // namespace
}  // namespace drape::fmi2
