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
  std::string version;  // of Drape
  std::string about, author, model_version, copyright, license;
  double stop_time, step_size;  // s, of the default experiment
  std::vector<Variable> table;
  std::string date;  // of the FMU, as 2026-01-31T12:00:00Z; may be empty
};

// What the FMU states where the scene says nothing of itself.
inline constexpr char kCopyright[] = "Copyright (c) 2026 The Drape authors",
                      kLicense[] = "MIT; of all that is packed: documentation/licenses";

Description description_of(drape_cloth* cloth, Nodes nodes);

// modelDescription.xml of FMI 2.0 for co-simulation.
std::string description_xml_fmi2(const Description& description);

// The table in Markdown, one row per family.
std::string description_markdown(const Description& description);

// documentation/index.html with the table and a picture, which is an SVG element.
std::string description_html(const Description& description, const std::string& picture);

}  // namespace drape::description
