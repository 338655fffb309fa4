#include "figures/svg.h"

#include <cstdio>

namespace drape::figures {

std::string svg_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

pugi::xml_node svg_append(pugi::xml_node parent, const char* tag, SvgAttributes attributes) {
  pugi::xml_node node = parent.append_child(tag);
  for (const auto& [name, value] : attributes) node.append_attribute(name).set_value(value.c_str());
  return node;
}

pugi::xml_node svg_text(pugi::xml_node parent, Vec2 at, const std::string& text, SvgAttributes attributes) {
  pugi::xml_node node = svg_append(parent, "text", attributes);
  node.append_attribute("x").set_value(svg_number(at[0]).c_str());
  node.append_attribute("y").set_value(svg_number(at[1]).c_str());
  node.text().set(text.c_str());
  return node;
}

void svg_title(pugi::xml_node node, const std::string& title) {
  node.append_child("title").text().set(title.c_str());
}

std::string svg_path(const std::vector<Vec2>& points, bool closed) {
  std::string path;
  for (std::size_t k = 0; k < points.size(); ++k)
    path += (k ? "L" : "M") + svg_number(points[k][0]) + " " + svg_number(points[k][1]);
  return closed ? path + "Z" : path;
}

}  // namespace drape::figures
