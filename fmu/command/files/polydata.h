// VTK's PolyData: points, lines and polygons with fields on them, as an XML file with raw binary arrays.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace drape::command {

struct PolyField {
  std::string name;
  int components;
  std::vector<float> values;  // [points x components], or [cells x components]: lines, then polygons
};

struct PolyCells {
  std::vector<std::int32_t> corner, end;  // points; the end of each cell in `corner`, cumulative
};

struct PolyData {
  std::vector<double> position;  // [points x 3] m
  PolyCells lines, polygons;
  std::vector<double> velocity;  // [points x 3] m/s; or empty
  std::vector<PolyField> of_points, of_cells;
};

// As a VTK file.
std::string polydata_text(const PolyData& poly);

}  // namespace drape::command
