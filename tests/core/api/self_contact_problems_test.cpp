// With self-contact, cloth that passes through cloth at the start is a fault.
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "api/cloth.h"
#include "scene_file.h"

namespace drape::api {

using namespace tests;
namespace {

// The errors of a scene with these pieces.
std::vector<std::string> problems_of(const std::string& self_contact, const std::string& pieces) {
  const SceneFolder folder;
  const auto scene =
      folder.write("scene.toml", "[scene]\nname = \"s\"\nself_contact = " + self_contact +
                                     "\n[fabric.f]\nareal_density = 0.2\nthickness = 0.001\n"
                                     "warp = { elongation_percent = [0, 10], force = [0, 100] }\n" +
                                     pieces);
  std::vector<std::string> reported;
  const auto log = [](void* to, drape_log_kind kind, const char* message) {
    if (kind == DRAPE_LOG_ERROR) static_cast<std::vector<std::string>*>(to)->push_back(message);
  };
  drape_close(drape_open(scene.c_str(), log, &reported));
  for (std::string& text : reported)
    for (std::size_t at; (at = text.find(folder.path.string() + "/")) != std::string::npos;)
      text.erase(at, folder.path.string().size() + 1);
  return reported;
}

std::string piece(const std::string& name, const std::string& outline, const std::string& place) {
  return "[[piece]]\nname = \"" + name + "\"\nfabric = \"f\"\ncell = 0.05\noutline = " + outline +
         "\nplace = { " + place + " }\n";
}

TEST(SelfFault, PiecesThatGoThroughEachOther) {
  const std::string square = "[[0, 0], [0.2, 0], [0.2, 0.2], [0, 0.2]]";
  const std::string pieces =
      piece("flat", square, "origin = [0, 0, 0], axis_x = [1, 0, 0], axis_y = [0, 1, 0]") +
      piece("upright", square, "origin = [0.01, 0.07, -0.11], axis_x = [1, 0, 0], axis_y = [0, 0, 1]");
  EXPECT_TRUE(problems_of("false", pieces).empty());
  const std::vector<std::string> reported = problems_of("true", pieces);
  ASSERT_GE(reported.size(), 1u);
  EXPECT_EQ(reported[0].rfind("scene.toml:", 0), 0u) << reported[0];
  EXPECT_NE(
      reported[0].find("piece.upright.place puts it through the piece \"flat\" with self_contact = true: "),
      std::string::npos)
      << reported[0];
  EXPECT_NE(reported[0].find("; wanted: none"), std::string::npos) << reported[0];
}

// Both sides of a narrow notch lie in one plane, but for rounding, and go nowhere through each other.
TEST(SelfFault, IsNoFlatPieceWithANotch) {
  const std::string outline =
      "[[-0.4, -0.4], [0.4, -0.4], [0.4, 0.06], [-0.07, -0.02], [-0.09, 0.4], [-0.4, 0.4]]";
  for (int k = 0; k < 40; ++k) {
    const double a = 0.37 * k, b = 1.9 * k;  // the plane turned by a about z, then by b about x
    std::string place;
    for (const auto& [key, x, y] :
         {std::tuple{"axis_x", std::cos(a), std::sin(a)}, std::tuple{"axis_y", -std::sin(a), std::cos(a)}})
      place += std::string(", ") + key + " = [" + scene::number_text(x) + ", " +
               scene::number_text(y * std::cos(b)) + ", " + scene::number_text(y * std::sin(b)) + "]";
    const std::vector<std::string> reported =
        problems_of("true", piece("cloth", outline, "origin = [0.1, 0.2, 0.3]" + place));
    EXPECT_TRUE(reported.empty()) << k << ": " << reported[0];
  }
}

}  // namespace
}  // namespace drape::api
