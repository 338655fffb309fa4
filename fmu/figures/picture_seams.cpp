// Seams on the outline: a line beside it, on the cloth's side, with the particles; a ring where the side
// starts; the name with the letter of the side.
#include "figures/picture_draw.h"
#include "seam/layout.h"

namespace drape::figures {
namespace {

void side_draw(pugi::xml_node parent, const View& view, const scene::SeamSpec& seam,
               const seam::SeamLayout& layout, std::size_t k) {
  const pugi::xml_node group = svg_append(parent, "g", {{"class", "seam"}});
  char facts[120];
  std::snprintf(facts, sizeof facts, ", side %c: %.6g m, %zu particles", "ab"[k], layout.length[k],
                layout.point[k].size());
  svg_title(group, "seam " + seam.name + facts);
  std::vector<Vec2> line, points;
  for (const Vec2& p : seam::seam_line(view.scene.pieces[std::size_t(view.piece)], seam.side[k]))
    line.push_back(view(p));
  for (const Vec2& p : layout.point[k]) points.push_back(view(p));
  seam_mark(group, line, points);
  const std::size_t middle = points.size() / 2;
  const Vec2 in = layout.inward[k][middle];
  label_draw(group, points[middle], {in[0], -in[1]}, 16, seam.name + " " + "ab"[k], kSeamInk);
}

}  // namespace

void seams_draw(pugi::xml_node parent, const View& view) {
  for (const scene::SeamSpec& seam : view.scene.seams) {
    if (seam.side[0].piece != view.piece && seam.side[1].piece != view.piece) continue;
    const seam::SeamLayout layout = seam::seam_layout(view.scene, seam);
    for (std::size_t k = 0; k < 2; ++k)
      if (seam.side[k].piece == view.piece) side_draw(parent, view, seam, layout, k);
  }
}

}  // namespace drape::figures
