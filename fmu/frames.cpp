#include "frames.h"

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <system_error>

#include "csv.h"
#include "decimal.h"

namespace drape {
namespace {

// Corners of all cells, counter-clockwise. [4 x cells]
std::vector<std::int32_t> cells_of(const drape_cloth* cloth) {
  std::vector<std::int32_t> corners;
  for (int p = 0; p < drape_piece_count(cloth); ++p) {
    const drape_piece piece = drape_piece_at(cloth, p);
    corners.insert(corners.end(), piece.corner, piece.corner + 4 * std::size_t(piece.cell_count));
  }
  return corners;
}

// VTK's appended data: each array is its length in bytes and its bytes, found by its offset.
struct Appended {
  std::string bytes;

  template <class T>
  std::size_t append(const T* values, std::size_t count) {
    const std::size_t offset = bytes.size();
    const std::uint64_t length = count * sizeof(T);
    bytes.append(reinterpret_cast<const char*>(&length), sizeof length);
    bytes.append(reinterpret_cast<const char*>(values), length);
    return offset;
  }
};

std::string array_tag(const char* type, const char* name, int components, std::size_t offset) {
  return std::string("<DataArray type=\"") + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
         std::to_string(components) + "\" format=\"appended\" offset=\"" + std::to_string(offset) + "\"/>\n";
}

bool write_polydata(const std::filesystem::path& path, const drape_outputs& o,
                    const std::vector<std::int32_t>& corners) {
  std::vector<std::int32_t> ends;  // a polygon's last corner, counted through
  for (std::size_t i = 4; i <= corners.size(); i += 4) ends.push_back(std::int32_t(i));
  Appended data;
  const std::size_t points = std::size_t(o.node_count) * 3;
  std::string head =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<PolyData>\n"
      "<Piece NumberOfPoints=\"" +
      std::to_string(o.node_count) + "\" NumberOfPolys=\"" + std::to_string(ends.size()) + "\">\n<Points>\n";
  head += array_tag("Float64", "position", 3, data.append(o.node_position, points));
  head += "</Points>\n<PointData Vectors=\"velocity\">\n";
  head += array_tag("Float64", "velocity", 3, data.append(o.node_velocity, points));
  head += "</PointData>\n<Polys>\n";
  head += array_tag("Int32", "connectivity", 1, data.append(corners.data(), corners.size()));
  head += array_tag("Int32", "offsets", 1, data.append(ends.data(), ends.size()));
  head += "</Polys>\n</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
  std::ofstream file(path, std::ios::binary);
  file << head << data.bytes << "\n</AppendedData>\n</VTKFile>\n";
  file.close();
  return !file.fail();
}

std::string frame_name(std::size_t frame) {
  char name[32];
  std::snprintf(name, sizeof name, "frames/%04zu.vtp", frame);
  return name;
}

bool write_collection(const Frames& frames) {
  std::ofstream file(frames.folder / "frames.pvd");
  file << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\">\n<Collection>\n";
  for (std::size_t i = 0; i < frames.times.size(); ++i)
    file << "<DataSet timestep=\"" << decimal_text(frames.times[i]) << "\" file=\"" << frame_name(i)
         << "\"/>\n";
  file << "</Collection>\n</VTKFile>\n";
  file.close();
  return !file.fail();
}

}  // namespace

bool frame_write(Frames& frames, drape_cloth* cloth, double time) {
  std::error_code error;
  std::filesystem::create_directories(frames.folder / "frames", error);
  const std::filesystem::path path = frames.folder / frame_name(frames.times.size());
  errno = 0;
  if (!write_polydata(path, *drape_outputs_at(cloth, 1), cells_of(cloth))) {
    frames.trouble = cannot_write(path);
    return false;
  }
  frames.times.push_back(time);
  if (write_collection(frames)) return true;
  frames.trouble = cannot_write(frames.folder / "frames.pvd");
  return false;
}

}  // namespace drape
