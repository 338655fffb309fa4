// The elements of a picture of pieces. A piece is drawn in this order: cells, twins, seams, pins, probes.
#pragma once
#include "figures/svg.h"
#include "piece/grid/grid.h"
#include "piece/outline/outline.h"

namespace drape::figures {

// Colours.
inline constexpr char kInk[] = "#203040", kGhostInk[] = "#cfd8e0", kLineInk[] = "#a9b8c6";
inline constexpr char kClothInk[] = "#eef3f8", kStripInk[] = "#d3d9df";
inline constexpr char kPinInk[] = "#c0281c", kProbeInk[] = "#1c5fc0", kTwinInk[] = "#7a2fa0",
                      kSeamInk[] = "#2e7d4f";

// A piece that is being drawn, with its plane upright. The y axis of the drawing points down.
struct View {
  const Scene& scene;
  int piece;
  const piece::Grid& grid;
  std::vector<piece::OutlineLoop> loops;
  Vec2 low, high;  // of outline and cells in the plane, m
  double scale;    // drawing units per metre
  Vec2 corner;     // of the drawing: the position of (low x, high y)

  Vec2 operator()(Vec2 p) const {
    return {corner[0] + (p[0] - low[0]) * scale, corner[1] + (high[1] - p[1]) * scale};
  }
  std::string path(const std::vector<Vec2>& points, bool closed) const {
    std::vector<Vec2> drawn;
    for (const Vec2& p : points) drawn.push_back((*this)(p));
    return svg_path(drawn, closed);
  }
  double cell() const { return grid.cell * scale; }
};

View view_make(const Scene& scene, int piece, const piece::Grid& grid);

// Draws the grid, the cut cells by their share, and the outline.
void cells_draw(pugi::xml_node parent, const View& view);
void twins_draw(pugi::xml_node parent, const View& view);

// The colour of a cell that the outline cuts or that has merged parts, by its share phi.
std::string share_colour(double share);

void pins_draw(pugi::xml_node parent, const View& view);
void probes_draw(pugi::xml_node parent, const View& view);
void seams_draw(pugi::xml_node parent, const View& view);

// Text beside a mark, in a direction of the drawing.
void label_draw(pugi::xml_node parent, Vec2 at, Vec2 towards, double distance, const std::string& text,
                const char* colour);

// The same marks without a piece, at a point of the drawing.
void point_mark(pugi::xml_node parent, Vec2 at, double size, bool clamp);
void edge_mark(pugi::xml_node parent, const std::vector<Vec2>& line, bool clamp);  // the cloth to its left
pugi::xml_node region_mark(pugi::xml_node parent, const std::string& path, bool clamp);
void held_mark(pugi::xml_node parent, const std::vector<Vec2>& points, double size);
void drive_mark(pugi::xml_node parent, Vec2 at, double size);
void probe_mark(pugi::xml_node parent, Vec2 at);
void seam_mark(pugi::xml_node parent, const std::vector<Vec2>& line, const std::vector<Vec2>& particles);
void twin_mark(pugi::xml_node parent, Vec2 at, Vec2 cloth, double radius, bool twin);

// Draws the scale and the meaning of the marks of these pieces, from `corner` down, at most to `right`.
// Returns the height.
double legend_draw(pugi::xml_node parent, const Scene& scene, const std::vector<piece::Grid>& grids,
                   double scale, Vec2 corner, double right);
double text_width(const std::string& text);  // approximately, in the font of the picture

}  // namespace drape::figures
