#include "command/garmentcode/garment.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

#include "command/garmentcode/place_near.h"
#include "scene/spelling.h"

namespace drape::command {
namespace {

constexpr double kDuration = 10;  // s, the latest end of a fit

std::string with_number(const std::string& name, std::set<std::string>& used) {
  std::string made = name;
  for (int k = 2; !used.insert(made).second; ++k) made = name + "_" + std::to_string(k);
  return made;
}

// The name of the seam of a stitch. A panel sewn to itself along consecutive edges has a dart.
std::string seam_name(const Pattern& pattern, const Scene& scene, const Stitch& s,
                      std::set<std::string>& used) {
  const auto piece = [&](std::size_t k) { return scene.pieces[std::size_t(s.panel[k])].name; };
  const int count = int(pattern.panels[std::size_t(s.panel[0])].outline.size());
  const int apart = std::abs(s.edge[0] - s.edge[1]);
  const bool dart = s.panel[0] == s.panel[1] && (apart == 1 || apart == count - 1);
  std::string name = piece(0) + "_" + (dart ? "dart" : piece(1));
  if (name.size() > 60) name = "seam";
  return with_number(name, used);
}

std::string metres(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.9f", value);
  std::string t = text;
  t.erase(t.find_last_not_of('0') + 1);
  if (t.back() == '.') t.pop_back();
  return t == "-0" ? "0" : t;
}

template <class List>
std::string list_text(const List& values) {
  std::string text;
  for (double v : values) text += (text.empty() ? "" : ", ") + metres(v);
  return "[" + text + "]";
}

std::string quoted(const std::string& text) {  // a basic string of TOML
  std::string made = "\"";
  for (char c : text) {
    char code[8];
    if (c == '"' || c == '\\') made += '\\', made += c;
    else if (static_cast<unsigned char>(c) < ' ' || c == 0x7f)
      std::snprintf(code, sizeof code, "\\u%04X", unsigned(static_cast<unsigned char>(c))), made += code;
    else made += c;
  }
  return made + "\"";
}

std::string comment(const std::string& text) {  // one line, whatever characters a label has
  std::string made = text;
  for (char& c : made)
    if (static_cast<unsigned char>(c) < ' ' || c == 0x7f) c = ' ';
  return made;
}

// The notes beside each edge: its label, and the edge to which it is sewn.
std::vector<std::vector<std::string>> edge_notes(const Scene& scene, const Pattern& pattern) {
  std::vector<std::vector<std::string>> notes;
  for (const Panel& panel : pattern.panels) {
    notes.emplace_back();
    for (std::size_t k = 0; k < panel.outline.size(); ++k)
      notes.back().push_back("edge " + std::to_string(k) +
                             (panel.edge_label[k].empty() ? "" : " (" + panel.edge_label[k] + ")"));
  }
  for (const scene::SeamSpec& seam : scene.seams)
    for (std::size_t k = 0; k < 2; ++k) {
      const scene::SeamSide &here = seam.side[k], &there = seam.side[1 - k];
      notes[std::size_t(here.piece)][std::size_t(here.edges[0])] +=
          ", sewn to edge " + std::to_string(there.edges[0]) +
          (here.piece == there.piece ? "" : " of " + scene.pieces[std::size_t(there.piece)].name);
    }
  return notes;
}

std::string curve_text(const scene::CurveSpec& c) {
  std::string text = "{ edge = " + std::to_string(c.edge);
  if (c.bezier.empty())
    return text + ", arc = " + metres(c.radius) + ", large = " + (c.large ? "true" : "false") +
           ", right = " + (c.right ? "true" : "false") + " }";
  std::string points;
  for (const Vec2& p : c.bezier) points += (points.empty() ? "" : ", ") + list_text(p);
  return text + ", bezier = [" + points + "] }";
}

std::string piece_text(const scene::PieceSpec& piece, const Panel& panel,
                       const std::vector<std::string>& notes, const Garment& garment) {
  std::string text = "\n[[piece]]";
  if (panel.name != piece.name || !panel.label.empty())
    text += comment("  # panel " + panel.name + (panel.label.empty() ? "" : ", " + panel.label));
  text += "\nname = " + quoted(piece.name) + "\nfabric = " + quoted(garment.fabric) +
          "\ncell = " + metres(piece.cell) + "  # m\noutline = [\n";
  for (std::size_t k = 0; k < piece.outline.size(); ++k)
    text += comment("  " + list_text(piece.outline[k]) + ",  # " + notes[k]) + "\n";
  text += "]\n";
  if (!piece.curves.empty()) {
    text += "curves = [\n";
    for (const scene::CurveSpec& c : piece.curves) text += "  " + curve_text(c) + ",\n";
    text += "]\n";
  }
  return text + "place = { origin = " + list_text(piece.place.origin) +
         ", axis_x = " + list_text(piece.place.axis_x) + ", axis_y = " + list_text(piece.place.axis_y) +
         " }\n";
}

std::string side_text(const Scene& scene, const scene::SeamSide& side) {
  return "{ piece = " + quoted(scene.pieces[std::size_t(side.piece)].name) + ", edges = [" +
         std::to_string(side.edges[0]) + "]" + (side.reverse ? ", reverse = true" : "") + " }\n";
}

}  // namespace

std::string name_made(const std::string& text, const std::string& otherwise) {
  std::string name;
  for (char c : text)
    name += (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ? c : '_';
  if (!name.empty() && !std::isalpha(static_cast<unsigned char>(name[0]))) name = otherwise + "_" + name;
  name.resize(std::min<std::size_t>(name.size(), 60));
  return scene::name_fits(name) ? name : otherwise;
}

Scene garment_scene(const Pattern& pattern, const Garment& garment, const scene::FabricSpec& fabric) {
  Scene scene;
  scene.name = garment.name;
  scene.mode = scene::Mode::kFit;
  scene.duration = kDuration;
  scene.gravity = {0, garment.body ? -9.81 : 0, 0};
  scene.fabrics = {fabric};
  scene.fabrics[0].name = garment.fabric;
  std::set<std::string> pieces, seams;
  for (const Panel& panel : pattern.panels) {
    scene::PieceSpec piece;
    piece.name = with_number(name_made(panel.name, "panel"), pieces);
    piece.fabric = 0;
    piece.cell = garment.cell;
    piece.outline = panel.outline;
    piece.curves = panel.curves;
    piece.place.origin = panel.origin;
    piece.place.axis_x = panel.axis_x;
    piece.place.axis_y = panel.axis_y;
    scene.pieces.push_back(piece);
  }
  for (const Stitch& s : pattern.stitches) {
    scene::SeamSpec seam;
    seam.name = seam_name(pattern, scene, s, seams);
    for (std::size_t k = 0; k < 2; ++k) seam.side[k] = {s.panel[k], {s.edge[k]}, k == 1 && !s.right_wrong};
    scene.seams.push_back(seam);
  }
  if (garment.body) garment_place_near(scene, garment.body->vertex);
  return scene;
}

std::string garment_text(const Scene& scene, const Pattern& pattern, const Garment& garment) {
  std::string text = comment("# Imported from " + garment.title + ": " + std::to_string(scene.pieces.size()) +
                             " panels, " + std::to_string(scene.seams.size()) + " seams.") +
                     "\n\n[scene]\nname = " + quoted(scene.name) + "\nduration = " + metres(scene.duration) +
                     "  # s, by which the fit ends at the latest\ngravity = " + list_text(scene.gravity) +
                     "  # m/s2" + (garment.body ? "" : ": weightless, without a body") + "\nmode = \"fit\"\n";
  text += "\n[fabric." + garment.fabric + "]\nfile = " + quoted(garment.fabric_file) + "\n";
  if (garment.body) {
    text += "\n[[body]]\nname = \"body\"\nmesh = " + quoted(garment.body->file) + "\n";
    if (garment.body->scale != 1) text += "scale = " + metres(garment.body->scale) + "\n";
  }
  const std::vector<std::vector<std::string>> notes = edge_notes(scene, pattern);
  for (std::size_t p = 0; p < scene.pieces.size(); ++p)
    text += piece_text(scene.pieces[p], pattern.panels[p], notes[p], garment);
  for (const scene::SeamSpec& seam : scene.seams)
    text +=
        "\n[[seam]]\nname = " + quoted(seam.name) + "\na = " + side_text(scene, seam.side[0]) +
        "b = " + side_text(scene, seam.side[1]) +
        (seam.closed_at > 0 ? "closed_at = " + metres(seam.closed_at) + "  # s: once the others are closed\n"
                            : "");
  return text;
}

}  // namespace drape::command
