#include <pugixml.hpp>
#include <sstream>

#include "decimal.h"
#include "table_rows.h"

namespace drape::description {
namespace {

pugi::xml_node append(pugi::xml_node parent, const char* tag, const std::string& text) {
  pugi::xml_node node = parent.append_child(tag);
  node.text().set(text.c_str());
  return node;
}

constexpr const char* kStyle =
    "body{font-family:sans-serif;max-width:60em;margin:2em auto;padding:0 1em}"
    "table{border-collapse:collapse}td,th{border:1px solid #ccc;padding:.2em .5em;text-align:left}"
    "td:first-child{font-family:monospace}svg{max-width:100%;height:auto}";

}  // namespace

std::string description_html(const Description& d, const std::string& picture) {
  pugi::xml_document document;
  document.append_child(pugi::node_doctype).set_value("html");
  pugi::xml_node html = document.append_child("html");
  pugi::xml_node head = html.append_child("head");
  head.append_child("meta").append_attribute("charset").set_value("utf-8");
  append(head, "title", d.name);
  append(head, "style", kStyle);
  pugi::xml_node body = html.append_child("body");
  append(body, "h1", d.name);
  append(body, "p",
         d.about + ". Made by Drape " + d.version + ". Default experiment: 0 to " +
             decimal_text(d.stop_time) + " s in steps of " + decimal_text(d.step_size) + " s.");
  body.append_buffer(picture.data(), picture.size());
  append(body, "p", "The pieces on their grids.");
  append(body, "h2", "Variables");
  pugi::xml_node table = body.append_child("table");
  pugi::xml_node header = table.append_child("tr");
  for (const char* column : kColumns) append(header, "th", column);
  for (const TableRow& cells : table_rows_of(d)) {
    pugi::xml_node row = table.append_child("tr");
    for (const std::string& cell : cells) append(row, "td", cell.empty() ? "\u2013" : cell);
  }
  std::ostringstream text;
  document.save(text, " ", pugi::format_default | pugi::format_no_declaration);
  return text.str();
}

}  // namespace drape::description
