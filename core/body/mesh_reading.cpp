// tinyobjloader reads OBJ. The only permissively licensed STL reader in Debian is Assimp, which would add 12
// MB to every FMU with a body. So the two forms of STL are read here:
//
//   text    solid ... facet normal n  outer loop  vertex x y z (three times)  endloop  endfacet ... endsolid
//   binary  80 bytes, uint32 count, count x { float normal[3], float vertex[3][3], uint16 }, little-endian
#include "body/mesh_reading.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "body/seam_merging.h"

#define TINYOBJLOADER_IMPLEMENTATION
#define TINYOBJLOADER_USE_DOUBLE
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#include <tiny_obj_loader.h>
#pragma GCC diagnostic pop

namespace drape::body {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF", kSpace = " \t\r\n";

std::string lower(std::string text) {
  for (char& c : text) c = char(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::string bytes_read(std::istream& stream) { return {std::istreambuf_iterator<char>(stream), {}}; }

// "v x y z": tinyobjloader reads a vertex that is no number as 0. Its exponents overflow, so a number with
// an exponent is written anew.
std::string vertex_plain(std::istringstream& words, std::size_t vertex, std::string& trouble) {
  std::string plain = "v", word;
  for (int k = 0; k < 3; ++k) {
    char* end = nullptr;
    const double value = words >> word ? std::strtod(word.c_str(), &end) : NAN;
    if (!std::isfinite(value) || *end)
      return trouble = "has a vertex that is no number, vertex " + std::to_string(vertex), "";
    if (word.find_first_of("eE") != std::string::npos) {
      char written[32];
      std::snprintf(written, sizeof written, "%.17g", value);
      word = written;
    }
    plain += ' ' + word;
  }
  return plain;
}

// "f i j k ...": tinyobjloader leaves out a face of two corners, and reads a corner up to what is no digit.
std::string face_plain(std::istringstream& words, std::size_t face, std::string& trouble) {
  std::string plain = "f", word;
  int corners = 0;
  for (; words >> word && word[0] != '#'; ++corners) {
    const std::string vertex = word.substr(0, word.find('/'));
    const char* const end = vertex.data() + vertex.size();
    int number = 0;
    const auto [read, error] = std::from_chars(vertex.data() + (vertex[0] == '+'), end, number);
    if (error != std::errc() || read != end || number == 0)
      return trouble = "has the corner '" + word.substr(0, 40) + "', face " + std::to_string(face) +
                       "; wanted: the number of a vertex, from 1, or counted back from -1",
             "";
    plain += ' ' + vertex;
  }
  if (corners < 3)
    trouble = "has a face of " + std::to_string(corners) + " corners, face " + std::to_string(face) +
              "; allowed: 3 and more";
  return plain;
}

// What tinyobjloader is given: vertices and faces, without texture and normals; no byte order mark, lines
// continued by a backslash in one piece, keywords in lower case. All other lines are empty.
std::string obj_plain(const std::string& bytes, std::string& trouble) {
  std::string plain, whole;
  std::size_t vertices = 0, faces = 0;
  std::istringstream stream(bytes.starts_with(kByteOrderMark) ? bytes.substr(kByteOrderMark.size()) : bytes);
  for (std::string line; trouble.empty() && std::getline(stream, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    whole += line;
    const std::size_t first = whole.find_first_not_of(kSpace);
    const bool comment = first != std::string::npos && whole[first] == '#';
    if (!whole.empty() && whole.back() == '\\' && !comment && !stream.eof()) {
      whole.back() = ' ';
      continue;
    }
    std::istringstream words(whole);
    std::string keyword;
    if (words >> keyword) {
      keyword = lower(keyword);
      if (keyword == "v") plain += vertex_plain(words, ++vertices, trouble);
      if (keyword == "f") plain += face_plain(words, ++faces, trouble);
    }
    plain += '\n';
    whole.clear();
  }
  return plain;
}

std::string obj_read(const std::filesystem::path& file, Triangles& to) {
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warning, error;
  std::ifstream file_stream(file, std::ios::binary);
  if (!file_stream) return "cannot be opened";
  std::string trouble;
  std::istringstream stream(obj_plain(bytes_read(file_stream), trouble));
  if (!trouble.empty()) return trouble;
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

// STL gives every triangle its own corners. Those with equal coordinates become one point.
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
  bool ended = false;
  for (std::string word; words >> word;) {
    if (word == "facet") ended = false;
    if (word == "endsolid") ended = true;
    if (word == "solid" || word == "endsolid") std::getline(words, word);  // its name may be any word
    if (word != "vertex") continue;
    std::array<std::string, 3> number;
    std::array<double, 3> p{};
    for (std::size_t k = 0; k < 3; ++k) {
      words >> number[k];
      char* end = nullptr;
      p[k] = std::strtod(number[k].c_str(), &end);
      if (number[k].empty() || *end || !std::isfinite(p[k]))
        return "is no STL file: after 'vertex' stands '" + number[k] + "', no number";
    }
    merged.add(p);
  }
  if (to.corner.size() % 3) return "is no STL file: its last facet lacks a vertex";
  return ended ? "" : "is cut off: 'endsolid' is missing at its end";
}

constexpr std::size_t kHead = 84, kFacet = 50, kNormal = 12;

std::size_t binary_count(const std::string& bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, 4);
  return count;
}

// Some programs add bytes at the end, less than a facet.
bool is_binary(const std::string& bytes) {
  if (bytes.size() < kHead) return false;
  const std::size_t size = kHead + kFacet * binary_count(bytes);
  return bytes.size() >= size && bytes.size() < size + kFacet;
}

std::string stl_read(const std::filesystem::path& file, Triangles& to) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return "cannot be opened";
  const std::string bytes = bytes_read(stream);
  // Binary files may begin with "solid" too. The file size distinguishes the two forms.
  if (!is_binary(bytes)) {
    const std::size_t mark = bytes.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
    const std::size_t begin = bytes.find_first_not_of(kSpace, mark);
    if (begin != std::string::npos && lower(bytes.substr(begin, 5)) == "solid" &&
        bytes.find('\0') == std::string::npos)
      return stl_text_read(lower(bytes.substr(begin)), to);
    return "is no STL file: neither text nor as long as its number of facets says";
  }
  Merged merged{to, {}};
  for (std::size_t t = 0; t < binary_count(bytes); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      float p[3];
      std::memcpy(p, bytes.data() + kHead + kFacet * t + kNormal + 12 * k, 12);
      if (!std::isfinite(p[0] + p[1] + p[2]))
        return "has a vertex that is no number, facet " + std::to_string(t + 1);
      merged.add({p[0], p[1], p[2]});
    }
  return "";
}

std::string ending(const std::string& file) {
  const std::size_t dot = file.rfind('.');
  return dot == std::string::npos ? "" : lower(file.substr(dot + 1));
}

drape_mesh_file* mesh_copy(const Triangles& from) {
  auto mesh = std::make_unique<drape_mesh_file>();
  auto point = std::make_unique<double[]>(from.point.size());
  auto corner = std::make_unique<int[]>(from.corner.size());
  std::copy(from.point.begin(), from.point.end(), point.get());
  std::copy(from.corner.begin(), from.corner.end(), corner.get());
  *mesh = {from.point.size() / 3, point.release(), from.corner.size() / 3, corner.release()};
  return mesh.release();
}

}  // namespace

drape_mesh_file* mesh_read(const char* file, char* problem, size_t capacity) noexcept {
  try {
    std::string trouble;
    Triangles found;
    const std::string name = file, kind = ending(name);
    const std::filesystem::path path = std::u8string(name.begin(), name.end());
    if (kind == "obj") trouble = obj_read(path, found);
    else if (kind == "stl") trouble = stl_read(path, found);
    else trouble = "ends in ." + kind + "; wanted: .obj or .stl";
    if (trouble.empty() && found.corner.empty()) trouble = "holds no triangles";
    if (trouble.empty()) seams_merge(found);
    if (trouble.empty()) return mesh_copy(found);
    while (!trouble.empty() && trouble.back() == '\n') trouble.pop_back();
    std::snprintf(problem, capacity, "%s", trouble.c_str());
  } catch (const std::exception& e) {
    std::snprintf(problem, capacity, "cannot be read: %s", e.what());
  }
  return nullptr;
}

void mesh_free(drape_mesh_file* mesh) noexcept {
  if (!mesh) return;
  delete[] mesh->point;
  delete[] mesh->corner;
  delete mesh;
}

}  // namespace drape::body
