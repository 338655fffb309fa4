// tinyobjloader reads OBJ. The only permissively licensed STL reader in Debian is Assimp, which would add 12
// MB to every FMU with a body. So the two forms of STL are read here:
//
//   text    solid ... facet normal n  outer loop  vertex x y z (three times)  endloop  endfacet ... endsolid
//   binary  80 bytes, uint32 count, count x { float normal[3], float vertex[3][3], uint16 }, little-endian
#include "body/mesh_reading.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#define TINYOBJLOADER_IMPLEMENTATION
#define TINYOBJLOADER_USE_DOUBLE
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#include <tiny_obj_loader.h>
#pragma GCC diagnostic pop

namespace drape::body {
namespace {

struct Triangles {
  std::vector<double> point;
  std::vector<int> corner;
};

// Checks that vertices are finite numbers, because tinyobjloader reads anything else as 0.
std::string vertices_trouble(std::istream& stream) {
  std::size_t vertex = 0;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string word;
    if (!(words >> word) || word != "v") continue;
    ++vertex;
    for (int k = 0; k < 3; ++k) {
      char* end = nullptr;
      if (!(words >> word) || !std::isfinite(std::strtod(word.c_str(), &end)) || *end)
        return "has a vertex that is no number, vertex " + std::to_string(vertex);
    }
  }
  return "";
}

std::string obj_read(const char* file, Triangles& to) {
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warning, error;
  std::ifstream stream(file);
  if (!stream) return "cannot be opened";
  if (std::string trouble = vertices_trouble(stream); !trouble.empty()) return trouble;
  stream.clear();
  stream.seekg(0);
  struct NoMaterials : tinyobj::MaterialReader {  // materials are ignored
    bool operator()(const std::string&, std::vector<tinyobj::material_t>*, std::map<std::string, int>*,
                    std::string*, std::string*) override {
      return true;
    }
  } none;
  if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &stream, &none, true))
    return error.empty() ? "is no OBJ file" : "is no OBJ file: " + error;
  to.point = attributes.vertices;
  for (const tinyobj::shape_t& shape : shapes)
    for (const tinyobj::index_t& index : shape.mesh.indices) to.corner.push_back(index.vertex_index);
  return "";
}

// Corners with equal coordinates become one point.
struct Merged {
  Triangles& to;
  std::map<std::array<double, 3>, int> known;
  void add(const std::array<double, 3>& p) {
    const auto [at, fresh] = known.emplace(p, int(to.point.size() / 3));
    if (fresh) to.point.insert(to.point.end(), p.begin(), p.end());
    to.corner.push_back(at->second);
  }
};

std::string stl_text_read(const std::string& text, Triangles& to) {
  std::istringstream words(text);
  Merged merged{to, {}};
  for (std::string word; words >> word;) {
    if (word != "vertex") continue;
    std::array<std::string, 3> number;
    std::array<double, 3> p{};
    for (std::size_t k = 0; k < 3; ++k) {
      words >> number[k];
      char* end = nullptr;
      p[k] = std::strtod(number[k].c_str(), &end);
      if (number[k].empty() || *end)
        return "is no STL file: after 'vertex' stands '" + number[k] + "', no number";
    }
    merged.add(p);
  }
  return to.corner.size() % 3 ? "is no STL file: its last facet lacks a vertex" : "";
}

constexpr std::size_t kHead = 84, kFacet = 50, kNormal = 12;

std::uint32_t binary_count(const std::string& bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, 4);
  return count;
}

std::string stl_read(const char* file, Triangles& to) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return "cannot be opened";
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  // Binary files may begin with "solid" too. The file size distinguishes the two forms.
  const bool binary =
      bytes.size() >= kHead && bytes.size() == kHead + kFacet * std::size_t(binary_count(bytes));
  if (!binary) {
    if (bytes.starts_with("solid")) return stl_text_read(bytes, to);
    return "is no STL file: neither text nor as long as its number of facets says";
  }
  Merged merged{to, {}};
  for (std::size_t t = 0; t < binary_count(bytes); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      float p[3];
      std::memcpy(p, bytes.data() + kHead + kFacet * t + kNormal + 12 * k, 12);
      merged.add({p[0], p[1], p[2]});
    }
  return "";
}

std::string ending(const std::string& file) {
  const std::size_t dot = file.rfind('.');
  std::string end = dot == std::string::npos ? "" : file.substr(dot + 1);
  for (char& c : end) c = char(std::tolower(static_cast<unsigned char>(c)));
  return end;
}

}  // namespace

drape_mesh_file* mesh_read(const char* file, char* problem, size_t capacity) {
  Triangles found;
  std::string trouble;
  try {
    const std::string kind = ending(file);
    if (kind == "obj") trouble = obj_read(file, found);
    else if (kind == "stl") trouble = stl_read(file, found);
    else trouble = "ends in ." + kind + "; wanted: .obj or .stl";
  } catch (const std::exception& e) {
    trouble = std::string("cannot be read: ") + e.what();
  }
  if (trouble.empty() && found.corner.empty()) trouble = "holds no triangles";
  if (!trouble.empty()) {
    while (!trouble.empty() && trouble.back() == '\n') trouble.pop_back();
    std::snprintf(problem, capacity, "%s", trouble.c_str());
    return nullptr;
  }
  auto* mesh = new drape_mesh_file{found.point.size() / 3, nullptr, found.corner.size() / 3, nullptr};
  mesh->point = new double[found.point.size()];
  mesh->corner = new int[found.corner.size()];
  std::copy(found.point.begin(), found.point.end(), mesh->point);
  std::copy(found.corner.begin(), found.corner.end(), mesh->corner);
  return mesh;
}

void mesh_free(drape_mesh_file* mesh) {
  if (!mesh) return;
  delete[] mesh->point;
  delete[] mesh->corner;
  delete mesh;
}

}  // namespace drape::body
