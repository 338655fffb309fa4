// Elements of an SVG drawing.
#pragma once
#include <initializer_list>
#include <pugixml.hpp>
#include <string>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace drape::figures {

using SvgAttributes = std::initializer_list<std::pair<const char*, std::string>>;
pugi::xml_node svg_append(pugi::xml_node parent, const char* tag, SvgAttributes attributes);
pugi::xml_node svg_text(pugi::xml_node parent, Vec2 at, const std::string& text, SvgAttributes attributes);

// The text that appears when a reader points at an element.
void svg_title(pugi::xml_node node, const std::string& title);

std::string svg_number(double value);

// "M1 2L3 4" through points of the drawing; closed with "Z".
std::string svg_path(const std::vector<Vec2>& points, bool closed);

}  // namespace drape::figures
