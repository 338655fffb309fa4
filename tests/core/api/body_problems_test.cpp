// The messages about bodies with faults.
#include <gtest/gtest.h>

#include "api/cloth.h"
#include "scene_file.h"

namespace drape::api {

using namespace tests;
namespace {

const std::string kTetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

struct Reported {
  std::vector<std::string> errors, warnings;
};

// Opens a cloth above the mesh. `lines` are added to its body, others to the scene.
Reported problems_of(const std::string& file, const std::string& mesh, const std::string& lines = "",
                     const std::string& origin = "[0, 0, 2]", const std::string& scene_lines = "") {
  const SceneFolder folder;
  folder.write(file, mesh);
  const auto scene = folder.write("scene.toml", R"([scene]
name = "s"
)" + scene_lines + R"(
[fabric.f]
areal_density = 0.2
thickness = 0.001
warp = { elongation_percent = [0, 10], force = [0, 100] }
[[piece]]
name = "p"
fabric = "f"
cell = 0.05
outline = [[0, 0], [0.2, 0], [0.2, 0.2], [0, 0.2]]
place = { origin = )" + origin + R"(, axis_x = [1, 0, 0], axis_y = [0, 1, 0] }
[[body]]
name = "b"
mesh = ")" + file + "\"\n" + lines);
  Reported reported;
  const auto log = [](void* to, drape_log_kind kind, const char* message) {
    Reported& all = *static_cast<Reported*>(to);
    if (kind == DRAPE_LOG_ERROR) all.errors.push_back(message);
    if (kind == DRAPE_LOG_WARNING) all.warnings.push_back(message);
  };
  drape_close(drape_open(scene.c_str(), log, &reported));
  for (auto* list : {&reported.errors, &reported.warnings})
    for (std::string& text : *list)
      for (std::size_t at; (at = text.find(folder.path.string() + "/")) != std::string::npos;)
        text.erase(at, folder.path.string().size() + 1);
  return reported;
}

void expect_error(const Reported& reported, const std::string& part) {
  ASSERT_EQ(reported.errors.size(), 1u);
  EXPECT_NE(reported.errors[0].find(part), std::string::npos) << reported.errors[0];
}

TEST(BodyFault, OfMeshes) {
  EXPECT_TRUE(problems_of("a.obj", kTetrahedron).errors.empty());
  EXPECT_TRUE(problems_of("a.obj", kTetrahedron).warnings.empty());
  expect_error(problems_of("a.ply", "ply"), "body.b.mesh = \"a.ply\" ends in .ply; wanted: .obj or .stl");
  expect_error(problems_of("a.obj", "v 0 0 0\n"), "holds no triangles");
  expect_error(problems_of("a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"), "has no triangle with an area");
  expect_error(problems_of("a.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
               "has a vertex that is no number, vertex 1");
  expect_error(problems_of("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"), "face");
  expect_error(problems_of("a.stl", "solid a\nfacet\nvertex 0 0 x\n"),
               "after 'vertex' stands 'x', no number");
  expect_error(problems_of("a.stl", "nothing"), "is no STL file");
}

TEST(BodyFault, OfOrder) {
  for (const std::string order : {"4", "6"})
    expect_error(
        problems_of("a.obj", kTetrahedron, "", "[0, 0, 2]", "order = " + order),
        "scene.order = " + order +
            " does not go with bodies, whose contact is damped and rubs; wanted: order = 2, or no body");
}

TEST(BodyFault, OfKeys) {
  expect_error(problems_of("a.obj", kTetrahedron, "scale = 0"),
               "body.b.scale = 0 m per unit of the mesh; allowed: above 0");
  expect_error(problems_of("a.obj", kTetrahedron, "orientation = [0, 0, 0, 0]"), "has length 0");
  expect_error(problems_of("a.obj", kTetrahedron, "orientation = [1, 0, 0]"),
               "has 3 entries; wanted: 4 numbers");
  expect_error(problems_of("a.obj", kTetrahedron, "friction = -1"), "allowed");
  expect_error(problems_of("a.obj", kTetrahedron, "mass = 1"), "is no known key");
}

TEST(BodyFault, OfStarts) {
  expect_error(problems_of("a.obj", kTetrahedron, "", "[0.1, 0.1, 0.2]"), "inside the body \"b\"");
  expect_error(problems_of("a.obj", kTetrahedron, "", "[0.1, 0.1, -0.00001]"),
               "nearer to it than half the thickness");
}

TEST(BodyFault, WarnsOfOddMeshes) {
  const Reported open = problems_of("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_TRUE(open.errors.empty());
  ASSERT_EQ(open.warnings.size(), 1u);
  EXPECT_NE(open.warnings[0].find("a sheet with two sides"), std::string::npos);
  const Reported large = problems_of("a.obj", kTetrahedron, "scale = 170", "[0, 0, 200]");
  ASSERT_EQ(large.warnings.size(), 1u);
  EXPECT_NE(large.warnings[0].find("is the mesh in another unit?"), std::string::npos);
}

}  // namespace
}  // namespace drape::api
