#include <cmath>
#include <fstream>
#include <sstream>

#include "command/garmentcode/garment.h"
#include "scene/diagnostics.h"
#include "scene/files.h"

namespace drape::command {
namespace {

constexpr double kMin = 0.3, kMax = 3;  // m, of a body
constexpr double kUnits[] = {1, 0.01, 0.001};

}  // namespace

std::optional<BodyMesh> body_measure(const std::filesystem::path& file, std::vector<Problem>& problems) {
  const std::size_t before = problems.size();
  const auto fault = [&](std::size_t line, const std::string& message) {
    problems.push_back({file.string() + ":" + (line ? std::to_string(line) + ":" : ""), message});
  };
  if (const std::string hindrance = scene::file_hindrance(file, scene::kMaxData); !hindrance.empty())
    return fault(0, hindrance), std::nullopt;
  std::ifstream stream(file);
  if (!stream) return fault(0, "cannot be read"), std::nullopt;
  Vec3 low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
  std::vector<Vec3> vertex;
  std::size_t vertices = 0, faces = 0, number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (number == 1 && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);  // byte order mark
    std::istringstream words(line);
    std::string word;
    words >> word;
    faces += word == "f" || word == "F";
    if (word != "v" && word != "V") continue;
    ++vertices;
    Vec3 p{};
    if (!(words >> p[0] >> p[1] >> p[2])) fault(number, "is no vertex; wanted: v and three numbers");
    else vertex.push_back(p);
    for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
    if (problems.size() > before + 10) return std::nullopt;
  }
  if (!vertices || !faces)
    fault(0, "holds " + std::to_string(vertices) + " vertices and " + std::to_string(faces) +
                 " faces; wanted: a mesh in OBJ");
  if (problems.size() > before) return {};
  const double tall = high[1] - low[1], deep = high[2] - low[2];
  if (deep > tall) {  // who stands is taller than deep
    fault(0, "is " + scene::number_text(deep) + " long along z and " + scene::number_text(tall) +
                 " high along y; allowed: y up and z to the front: turn it, (x, y, z) to (x, z, -y)");
    return {};
  }
  for (double unit : kUnits)
    if (const double height = unit * tall; height >= kMin && height <= kMax) {
      for (Vec3& v : vertex)
        for (double& x : v) x *= unit;
      return BodyMesh{file.string(), unit, height, std::move(vertex)};
    }
  fault(0, "is " + scene::number_text(tall) + " high along y; allowed: " + scene::number_text(kMin) + " to " +
               scene::number_text(kMax) + " m, in metres, centimetres or millimetres");
  return {};
}

}  // namespace drape::command
