// Texts of JSON as values.
#include "command/garmentcode/json.h"

#include <gtest/gtest.h>

#include <sstream>

namespace drape::command {
namespace {

std::string nested(std::size_t levels, const std::string& open, const std::string& close) {
  std::string text, end;
  for (std::size_t k = 0; k < levels; ++k) text += open, end += close;
  return text + "1" + end;
}

// Empty if the text is read and can be written.
std::string problem_of(const std::string& text) {
  std::istringstream stream(text);
  Json value;
  std::string problem;
  if (json_parse(stream, value, problem)) {
    EXPECT_TRUE(text.starts_with(json_text(value).substr(0, 80)));
  }
  return problem;
}

// Values nested in 200,000 levels are read in a loop, but written and copied by calls, which overran the
// stack.
TEST(Json, IsNestedInAtMost256Levels) {
  const std::string refused = "is nested in more than 256 levels; allowed: up to 256";
  for (const auto& [open, close] : {std::pair{"[", "]"}, std::pair{"{\"a\":", "}"}}) {
    EXPECT_EQ(problem_of(nested(256, open, close)), "");
    EXPECT_EQ(problem_of(nested(257, open, close)), refused);
    EXPECT_EQ(problem_of(nested(200000, open, close)), refused);
  }
  EXPECT_EQ(problem_of("[" + nested(200000, "[", "]")), refused);  // whatever stands at its end
}

TEST(Json, ThatIsNoneIsReported) {
  EXPECT_TRUE(problem_of("{\"pattern\": ").starts_with("is not valid JSON: "));
}

}  // namespace
}  // namespace drape::command
