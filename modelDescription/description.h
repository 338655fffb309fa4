// A model description before it is printed: what the XML of any FMI version and the documentation state.
#pragma once
#include <string>
#include <vector>

#include "variables.h"

namespace drape::description {

struct Description {
  std::string name;        // of the scene
  std::string identifier;  // the name as a C identifier: the name of the binary
  std::string guid;
  std::string version;          // of Drape
  double stop_time, step_size;  // s, of the default experiment
  std::vector<Variable> table;
};

Description description_of(drape_cloth* cloth, Nodes nodes);

// modelDescription.xml of FMI 2.0 for co-simulation.
std::string description_xml_fmi2(const Description& description);

// The table in Markdown, one row per family.
std::string description_markdown(const Description& description);

// documentation/index.html with the table and a picture, which is an SVG element.
std::string description_html(const Description& description, const std::string& picture);

}  // namespace drape::description
