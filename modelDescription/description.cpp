#include "description.h"

#include <algorithm>

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

// "pieces front, back", at most six names.
template <class NameAt>
void names_append(std::string& text, const char* one, const char* many, int count, NameAt name_at) {
  constexpr int kNamed = 6;
  if (count == 0) return;
  text += std::string("; ") + (count == 1 ? one : many) + " ";
  for (int k = 0; k < std::min(count, kNamed); ++k) text += (k > 0 ? ", " : "") + std::string(name_at(k));
  if (count > kNamed) text += " and " + std::to_string(count - kNamed) + " more";
}

// What the scene consists of, in its own names.
std::string description_made(drape_cloth* cloth) {
  const drape_outputs& o = *drape_get_outputs(cloth, 0);
  const drape_parameters& p = *drape_parameters_of(cloth);
  std::string text = "Woven cloth of " + std::to_string(o.node_count) + " particles" +
                     (o.has_fit ? ", brought to rest" : "");
  names_append(text, "piece", "pieces", drape_piece_count(cloth),
               [&](int k) { return drape_piece_at(cloth, k).name; });
  names_append(text, "fabric", "fabrics", p.fabric_count, [&](int k) { return p.fabric[k].name; });
  names_append(text, "seam", "seams", o.seam_count, [&](int k) { return o.seam[k].name; });
  names_append(text, "pin", "pins", o.pin_count, [&](int k) { return o.pin[k].name; });
  names_append(text, "body", "bodies", o.body_count, [&](int k) { return o.body[k].name; });
  names_append(text, "probe", "probes", o.probe_count, [&](int k) { return o.probe[k].name; });
  return text;
}

std::string text_or(const char* given, const std::string& otherwise) {
  return *given ? std::string(given) : otherwise;
}

}  // namespace

Description description_of(drape_cloth* cloth, Nodes nodes) {
  const std::string name = drape_scene_name(cloth), version = drape_version();
  const drape_about about = drape_scene_about(cloth);
  return {.name = name,
          .identifier = c_identifier(name),
          .guid = guid_of(guid_content(cloth), nodes),
          .version = version,
          .about = text_or(about.description, description_made(cloth)),
          .author = text_or(about.author, "made with Drape"),
          .model_version = text_or(about.version, version),
          .copyright = text_or(about.copyright, kCopyright),
          .license = text_or(about.license, kLicense),
          .stop_time = drape_duration(cloth),
          .step_size = drape_communication(cloth),
          .table = variables_of(cloth, nodes),
          .date = ""};
}

}  // namespace drape::description
