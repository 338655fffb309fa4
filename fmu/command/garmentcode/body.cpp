#include <cmath>
#include <fstream>
#include <sstream>

#include "command/garmentcode/garment.h"
#include "scene/diagnostics.h"

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
  std::ifstream stream(file);
  if (!stream || std::filesystem::is_directory(file)) return fault(0, "cannot be read"), std::nullopt;
  double low = INFINITY, high = -INFINITY;
  std::vector<Vec3> vertex;
  std::size_t vertices = 0, faces = 0, number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    std::istringstream words(line);
    std::string word;
    words >> word;
    faces += word == "f";
    if (word != "v") continue;
    ++vertices;
    Vec3 p{};
    if (!(words >> p[0] >> p[1] >> p[2])) fault(number, "is no vertex; wanted: v and three numbers");
    else low = std::min(low, p[1]), high = std::max(high, p[1]), vertex.push_back(p);
    if (problems.size() > before + 10) return std::nullopt;
  }
  if (!vertices || !faces)
    fault(0, "holds " + std::to_string(vertices) + " vertices and " + std::to_string(faces) +
                 " faces; wanted: a mesh in OBJ");
  if (problems.size() > before) return {};
  for (double unit : kUnits)
    if (const double height = unit * (high - low); height >= kMin && height <= kMax) {
      for (Vec3& v : vertex)
        for (double& x : v) x *= unit;
      return BodyMesh{file.string(), unit, height, std::move(vertex)};
    }
  fault(0, "is " + scene::number_text(high - low) + " high along y; allowed: " + scene::number_text(kMin) +
               " to " + scene::number_text(kMax) + " m, in metres, centimetres or millimetres");
  return {};
}

}  // namespace drape::command
