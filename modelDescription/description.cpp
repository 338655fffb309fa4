#include "description.h"

#include <algorithm>
#include <cmath>

#include "guid.h"

namespace drape::description {
namespace {

// An identifier of letters, digits and underscores that does not start with a digit.
std::string c_identifier(std::string text) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  for (char& c : text)
    if (!letter(c) && !digit(c)) c = '_';
  return text.empty() || digit(text[0]) ? "_" + text : text;
}

// About a hundred steps, each a whole number of communication intervals: then the motion does not depend on
// how a master groups the intervals.
double default_step(double duration, double communication) {
  return communication * std::max(1.0, std::round(duration / 100 / communication));
}

}  // namespace

Description description_of(drape_cloth* cloth, Nodes nodes) {
  const std::string name = drape_scene_name(cloth);
  return {.name = name,
          .identifier = c_identifier(name),
          .guid = guid_of(guid_content(cloth), nodes),
          .version = drape_version(),
          .stop_time = drape_duration(cloth),
          .step_size = default_step(drape_duration(cloth), drape_communication(cloth)),
          .table = variables_of(cloth, nodes)};
}

}  // namespace drape::description
