// Meshes as people have them: the same closed surface, or a sentence that says what is wrong.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "body/library.h"
#include "body/surface.h"
#include "scene_file.h"

namespace drape::body {

using namespace tests;
namespace {

// A tetrahedron.
const std::vector<std::array<double, 3>> kPoint{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const std::vector<std::array<int, 3>> kCorner{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};

struct Read {
  std::string problem;
  std::size_t points = 0;
  SurfaceFindings findings;
  bool solid = false;
};

Read read(const std::string& name, const std::string& bytes) {
  const SceneFolder folder;
  std::string hindrance;
  const std::shared_ptr<const drape_contact_library> library = contact_library(hindrance);
  EXPECT_TRUE(library) << hindrance;
  char problem[200] = "";
  Read found;
  drape_mesh_file* mesh = library->mesh_read(folder.write(name, bytes).c_str(), problem, sizeof problem);
  found.problem = problem;
  if (!mesh) return found;
  std::vector<Vec3> point;
  std::vector<std::array<int, 3>> corner;
  for (std::size_t k = 0; k < mesh->points; ++k)
    point.push_back({mesh->point[3 * k], mesh->point[3 * k + 1], mesh->point[3 * k + 2]});
  for (std::size_t k = 0; k < mesh->triangles; ++k)
    corner.push_back({mesh->corner[3 * k], mesh->corner[3 * k + 1], mesh->corner[3 * k + 2]});
  library->mesh_free(mesh);
  found.points = point.size();
  found.solid = surface_make(point, corner, found.findings, found.problem).solid;
  return found;
}

void expect_closed(const std::string& name, const std::string& bytes, std::size_t points = 4) {
  const Read found = read(name, bytes);
  EXPECT_EQ(found.problem, "") << bytes;
  EXPECT_EQ(found.points, points) << bytes;
  EXPECT_TRUE(found.solid && found.findings.open == 0) << bytes;
}

void expect_problem(const std::string& name, const std::string& bytes, const std::string& part) {
  const std::string problem = read(name, bytes).problem;
  EXPECT_NE(problem.find(part), std::string::npos) << problem;
}

std::string vertex(const std::array<double, 3>& p, const std::string& keyword = "v") {
  char text[120];
  std::snprintf(text, sizeof text, "%s %.17g %.17g %.17g\n", keyword.c_str(), p[0], p[1], p[2]);
  return text;
}

// Every triangle with points of its own, moved by up to `off` (m).
std::string split_obj(double off = 0) {
  std::string text, faces;
  int k = 0;
  for (const auto& corner : kCorner) {
    for (const int c : corner) {
      std::array<double, 3> p = kPoint[std::size_t(c)];
      p[std::size_t(k % 3)] += off * (k % 2 ? 1 : -1);
      text += vertex(p);
      ++k;
    }
    faces += "f " + std::to_string(k - 2) + " " + std::to_string(k - 1) + " " + std::to_string(k) + "\n";
  }
  return text + faces;
}

std::string shared_obj(const std::string& v = "v", const std::string& f = "f",
                       const std::string& eol = "\n") {
  std::string text;
  for (const auto& p : kPoint) text += vertex(p, v);
  for (const auto& c : kCorner)
    text += f + " " + std::to_string(c[0] + 1) + " " + std::to_string(c[1] + 1) + " " +
            std::to_string(c[2] + 1) + "\n";
  std::string whole;
  for (const char c : text) whole += c == '\n' ? eol : std::string(1, c);
  return whole;
}

std::string stl_text(const std::string& end = "endsolid part\n") {
  std::string text = "solid part\n";
  for (const auto& corner : kCorner) {
    text += " facet normal 0 0 0\n  outer loop\n";
    for (const int c : corner) text += "   " + vertex(kPoint[std::size_t(c)], "vertex");
    text += "  endloop\n endfacet\n";
  }
  return text + end;
}

std::string stl_binary(const std::string& head, float off = 0, int more_facets = 0) {
  std::string bytes = head + std::string(80 - head.size(), '\0');
  const auto add = [&](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  add(std::uint32_t(int(kCorner.size()) + more_facets));
  int k = 0;
  for (const auto& corner : kCorner) {
    for (int i = 0; i < 3; ++i) add(0.0F);
    for (const int c : corner)
      for (const double x : kPoint[std::size_t(c)]) add(float(x) + off * float(++k % 3 - 1));
    add(std::uint16_t(0));
  }
  return bytes;
}

std::string upper(std::string text) {
  for (char& c : text) c = char(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

TEST(MeshReading, ClosesSplitPoints) {
  expect_closed("a.obj", split_obj());
  expect_closed("a.obj", split_obj(2e-7));
  expect_closed("a.stl", stl_binary("made by nobody", 1e-7F));
  EXPECT_FALSE(read("a.obj", split_obj(1e-4)).solid);
}

TEST(MeshReading, LeavesSurfacesThatTouchApart) {
  std::string two = shared_obj();
  for (const auto& p : kPoint) two += vertex({-p[0], p[1], p[2]});
  for (const auto& c : kCorner)
    two += "f " + std::to_string(c[0] + 5) + " " + std::to_string(c[2] + 5) + " " + std::to_string(c[1] + 5) +
           "\n";
  expect_closed("a.obj", two, 8);
}

TEST(MeshReading, ReadsDialectsOfObj) {
  expect_closed("a.obj", shared_obj());
  expect_closed("a.obj", "\xEF\xBB\xBF" + shared_obj());
  expect_closed("a.obj", shared_obj("V", "F"));
  expect_closed("a.obj", shared_obj("v", "f", "\r\n"));
  expect_closed("a.obj", shared_obj("v", "f \\\n"));
  expect_closed("a.obj", "# from C:\\meshes\\\n" + shared_obj());
  expect_closed("a.obj", "vt 1e2147483648 0\nvn nothing\n" + shared_obj("v", "usemtl wool\nf") + "# f 1 2\n");
  std::string exponents = shared_obj();  // more than tinyobjloader counts
  for (std::size_t at; (at = exponents.find(" 0\n")) != std::string::npos;)
    exponents.replace(at, 3, " 0e2147483648\n");
  expect_closed("a.obj", exponents);
}

TEST(MeshReading, ReadsDialectsOfStl) {
  expect_closed("a.stl", stl_text());
  expect_closed("a.stl", upper(stl_text()));
  expect_closed("a.stl", "\xEF\xBB\xBF" + stl_text());
  expect_closed("a.stl", "  " + stl_text());
  expect_closed("a.stl", stl_text("endsolid part\nsolid two\nendsolid two\n"));
  expect_closed("a.stl", "solid vertex facet\n" + stl_text("endsolid facet\n").substr(11));
  expect_closed("a.stl", stl_binary("solid part"));
  expect_closed("a.stl", stl_binary("solid part") + "\n");
  expect_closed("a.stl", stl_binary("") + std::string(2, '\0'));
}

TEST(MeshReading, SaysWhatIsWrong) {
  expect_problem("a.obj", shared_obj() + "f 1 2\n", "has a face of 2 corners, face 5; allowed: 3 and more");
  expect_problem("a.obj", "v 0 zero 0\n", "has a vertex that is no number, vertex 1");
  const std::string corner = "; wanted: the number of a vertex, from 1, or counted back from -1";
  expect_problem("a.obj", shared_obj() + "f 1 2 3x\n", "has the corner '3x', face 5" + corner);
  expect_problem("a.obj", shared_obj() + "f 1 0 2\n", "has the corner '0', face 5" + corner);
  expect_problem("a.obj", shared_obj() + "f 1 2 /3\n", "has the corner '/3', face 5" + corner);
  expect_problem("a.obj", shared_obj() + "f 1 2 4294967299\n",
                 "has the corner '4294967299', face 5" + corner);
  expect_problem("a.stl", stl_binary("", NAN), "has a vertex that is no number, facet 1");
  expect_problem("a.stl", "solid a\nvertex nan 0 0\nendsolid\n", "after 'vertex' stands 'nan', no number");
  expect_problem("a.stl", stl_text(""), "is cut off: 'endsolid' is missing at its end");
  expect_problem("a.stl", stl_binary("", 0, 1000), "is no STL file");
  expect_problem("a.stl", stl_binary("").substr(0, 200), "is no STL file");
  expect_problem("a.stl", "", "is no STL file");
}

}  // namespace
}  // namespace drape::body
