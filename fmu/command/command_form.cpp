// `drape form`: a dress form as a mesh.
#include <cstdio>

#include "command/command.h"
#include "command/dress_form/form.h"
#include "scene/diagnostics.h"

namespace drape::command {
namespace {

int form_write(const Measures& m, const std::string& file) {
  std::vector<Problem> problems;
  measures_check(m, problems);
  if (file.empty()) problems.push_back({"--output", "is empty; allowed: the name of a file"});
  for (const Problem& p : problems) fail(kBadInput, scene::problem_text(p));
  if (!problems.empty()) return kBadInput;
  const Mesh mesh = form_make(m);
  const std::string title = "Dress form made by drape form: bust " + scene::number_text(m.bust) + ", waist " +
                            scene::number_text(m.waist) + ", hips " + scene::number_text(m.hips) +
                            ", height " + scene::number_text(m.height) + " m; metres, y up, z to the front";
  if (const int code = file_put(file, mesh_obj(mesh, title)); code != kDone) return code;
  std::printf("%s: %zu triangles; bust at %.3f m, waist at %.3f m, hips at %.3f m above the floor\n",
              file.c_str(), mesh.triangles.size(), kBustHeight * m.height, kWaistHeight * m.height,
              kHipsHeight * m.height);
  return kDone;
}

}  // namespace

void command_form(CLI::App& app, int& exit_code) {
  CLI::App* command = command_add(app, "form", "make a dress form of body measures (OBJ)");
  struct Options {
    Measures measures;
    std::string file;
  };
  auto options = std::make_shared<Options>();
  option_add(*command, "-o,--output", options->file, "the mesh", {.type = "BODY.obj", .required = true});
  const auto measure = [&](const char* name, double& value, const char* text) {
    option_add(*command, name, value, text, {.type = "METRES", .default_shown = true});
  };
  measure("--bust", options->measures.bust, "girth at the fullest part of the bust");
  measure("--waist", options->measures.waist, "girth of the waist");
  measure("--hips", options->measures.hips, "girth at the fullest part of the hips");
  measure("--height", options->measures.height, "from the floor to the top of the head");
  command_on_run(*command,
                 [options, &exit_code] { exit_code = form_write(options->measures, options->file); });
}

}  // namespace drape::command
