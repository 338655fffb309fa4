#include "command/command.h"
#include "figures/picture.h"
#include "package/package.h"
#include "scene/reader/read.h"
#include "validation/load.h"

namespace drape::command {
namespace {

struct Options {
  std::string scene_file, file;
  int fmi = 2;
  description::Nodes nodes = description::Nodes::kNone;
};

int pack(const Options& options) {
  if (options.fmi != 2) return fail(kBadInput, "--fmi is " + std::to_string(options.fmi) + "; allowed: 2");
  if (const std::string problem =
          output_problem("--output", options.file, scene::scene_files(options.scene_file));
      !problem.empty())
    return fail(kBadInput, problem);
  const Cloth cloth = cloth_open(options.scene_file);
  if (!cloth) return kBadInput;
  std::vector<Problem> problems;  // stays empty: the cloth has just been opened from the same file
  const std::string picture = figures::picture_svg(validation::scene_load(options.scene_file, problems));
  std::string problem;
  return package::fmu_pack(cloth.get(), options.nodes, picture, options.file, problem)
             ? kDone
             : fail(kBadInput, problem);
}

}  // namespace

void command_pack(CLI::App& app, int& exit_code) {
  CLI::App* command = command_add(app, "pack", "make the FMU of a scene");
  auto options = std::make_shared<Options>();
  option_scene(*command, options->scene_file);
  option_add(*command, "-o,--output", options->file, "the FMU", {.type = "OUT.fmu", .required = true});
  option_add(*command, "--fmi", options->fmi, "version of the standard",
             {.type = "2", .default_shown = true});
  option_nodes(*command, options->nodes);
  command_on_run(*command, [options, &exit_code] { exit_code = pack(*options); });
}

}  // namespace drape::command
