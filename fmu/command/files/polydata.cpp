#include "command/files/polydata.h"

namespace drape::command {
namespace {

// VTK's appended data: each array is its length in bytes, then its bytes. An offset finds it.
struct Appended {
  std::string head, bytes;
};

template <class T>
constexpr const char* type_name() {
  if constexpr (std::is_same_v<T, double>) return "Float64";
  else if constexpr (std::is_same_v<T, float>) return "Float32";
  else return "Int32";
}

template <class T>
void append(Appended& data, const std::string& name, int components, const std::vector<T>& values) {
  data.head += std::string("<DataArray type=\"") + type_name<T>() + "\" Name=\"" + name +
               "\" NumberOfComponents=\"" + std::to_string(components) + "\" format=\"appended\" offset=\"" +
               std::to_string(data.bytes.size()) + "\"/>\n";
  const std::uint64_t length = values.size() * sizeof(T);
  data.bytes.append(reinterpret_cast<const char*>(&length), sizeof length);
  data.bytes.append(reinterpret_cast<const char*>(values.data()), length);
}

void append_cells(Appended& data, const std::string& kind, const PolyCells& cells) {
  data.head += "<" + kind + ">\n";
  append(data, "connectivity", 1, cells.corner);
  append(data, "offsets", 1, cells.end);
  data.head += "</" + kind + ">\n";
}

}  // namespace

std::string polydata_text(const PolyData& poly) {
  Appended data;
  data.head =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<PolyData>\n"
      "<Piece NumberOfPoints=\"" +
      std::to_string(poly.position.size() / 3) + "\" NumberOfLines=\"" +
      std::to_string(poly.lines.end.size()) + "\" NumberOfPolys=\"" +
      std::to_string(poly.polygons.end.size()) + "\">\n<Points>\n";
  append(data, "position", 3, poly.position);
  data.head += "</Points>\n<PointData>\n";
  if (!poly.velocity.empty()) append(data, "velocity", 3, poly.velocity);
  for (const PolyField& field : poly.of_points) append(data, field.name, field.components, field.values);
  data.head += "</PointData>\n<CellData>\n";
  for (const PolyField& field : poly.of_cells) append(data, field.name, field.components, field.values);
  data.head += "</CellData>\n";
  if (!poly.lines.end.empty()) append_cells(data, "Lines", poly.lines);
  if (!poly.polygons.end.empty()) append_cells(data, "Polys", poly.polygons);
  data.head += "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
  return data.head + data.bytes + "\n</AppendedData>\n</VTKFile>\n";
}

}  // namespace drape::command
