// With self-contact, cloth that passes through cloth at the start is a fault.
#include <gtest/gtest.h>

#include "api/cloth.h"
#include "scene_file.h"

namespace drape::api {

using namespace tests;
namespace {

std::vector<std::string> problems_of(const std::string& self_contact) {
  const SceneFolder folder;
  const auto piece = [](const std::string& name, const std::string& place) {
    return "[[piece]]\nname = \"" + name + "\"\nfabric = \"f\"\ncell = 0.05\n" +
           "outline = [[0, 0], [0.2, 0], [0.2, 0.2], [0, 0.2]]\nplace = { " + place + " }\n";
  };
  const auto scene = folder.write(
      "scene.toml",
      "[scene]\nname = \"s\"\nself_contact = " + self_contact +
          "\n[fabric.f]\nareal_density = 0.2\nthickness = 0.001\n"
          "warp = { elongation_percent = [0, 10], force = [0, 100] }\n" +
          piece("flat", "origin = [0, 0, 0], axis_x = [1, 0, 0], axis_y = [0, 1, 0]") +
          piece("upright", "origin = [0.01, 0.07, -0.11], axis_x = [1, 0, 0], axis_y = [0, 0, 1]"));
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

TEST(SelfFault, PiecesThatGoThroughEachOther) {
  EXPECT_TRUE(problems_of("false").empty());
  const std::vector<std::string> reported = problems_of("true");
  ASSERT_GE(reported.size(), 1u);
  EXPECT_EQ(reported[0].rfind("scene.toml:", 0), 0u) << reported[0];
  EXPECT_NE(
      reported[0].find("piece.upright.place puts it through the piece \"flat\" with self_contact = true: "),
      std::string::npos)
      << reported[0];
  EXPECT_NE(reported[0].find("; wanted: none"), std::string::npos) << reported[0];
}

}  // namespace
}  // namespace drape::api
