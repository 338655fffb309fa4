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

// All pieces: the particles, then the points that move with four of them.
struct Shape {
  std::vector<double> position, velocity;  // [points x 3]
  std::vector<std::int32_t> corner, end;   // of the polygons; a polygon's end, counted through
};

Shape shape_of(drape_cloth* cloth) {
  const drape_outputs& o = *drape_outputs_at(cloth, 1);
  const std::size_t length = std::size_t(o.node_count) * 3;
  Shape shape;
  shape.position.assign(o.node_position, o.node_position + length);
  shape.velocity.assign(o.node_velocity, o.node_velocity + length);
  for (int p = 0; p < drape_piece_count(cloth); ++p) {
    const drape_piece piece = drape_piece_at(cloth, p);
    for (int k = 0; k < piece.point_count; ++k)
      for (auto [values, of_nodes] :
           {std::pair{&shape.position, o.node_position}, {&shape.velocity, o.node_velocity}})
        for (int axis = 0; axis < 3; ++axis) {
          double sum = 0;
          for (int n = 4 * k; n < 4 * k + 4; ++n)
            sum += piece.point_weight[n] * of_nodes[3 * piece.point_node[n] + axis];
          values->push_back(sum);
        }
    const auto before = std::int32_t(shape.corner.size());
    for (int k = 0; k < piece.polygon_count; ++k) shape.end.push_back(before + piece.polygon_end[k]);
    const int corners = piece.polygon_count ? piece.polygon_end[piece.polygon_count - 1] : 0;
    shape.corner.insert(shape.corner.end(), piece.polygon_corner, piece.polygon_corner + corners);
  }
  return shape;
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

bool write_polydata(const std::filesystem::path& path, const Shape& shape) {
  Appended data;
  std::string head =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<PolyData>\n"
      "<Piece NumberOfPoints=\"" +
      std::to_string(shape.position.size() / 3) + "\" NumberOfPolys=\"" + std::to_string(shape.end.size()) +
      "\">\n<Points>\n";
  head += array_tag("Float64", "position", 3, data.append(shape.position.data(), shape.position.size()));
  head += "</Points>\n<PointData Vectors=\"velocity\">\n";
  head += array_tag("Float64", "velocity", 3, data.append(shape.velocity.data(), shape.velocity.size()));
  head += "</PointData>\n<Polys>\n";
  head += array_tag("Int32", "connectivity", 1, data.append(shape.corner.data(), shape.corner.size()));
  head += array_tag("Int32", "offsets", 1, data.append(shape.end.data(), shape.end.size()));
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
  if (!write_polydata(path, shape_of(cloth))) {
    frames.trouble = cannot_write(path);
    return false;
  }
  frames.times.push_back(time);
  if (write_collection(frames)) return true;
  frames.trouble = cannot_write(frames.folder / "frames.pvd");
  return false;
}

}  // namespace drape
