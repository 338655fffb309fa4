#include <cstdio>
#include <map>

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
  package::Build build = package::Build::kNewest;
  std::vector<std::string> platforms;
};

const std::map<std::string, package::Build> kBuilds = {{"release", package::Build::kRelease},
                                                       {"development", package::Build::kDevelopment}};

std::vector<std::string> words_of(const std::string& list) {
  std::vector<std::string> words(1);
  for (const char c : list)
    if (c == ',') words.emplace_back();
    else words.back() += c;
  return words;
}

std::string packed_text(const package::PackedPlatform& packed, bool released) {
  char size[32];
  std::snprintf(size, sizeof size, "%.1f MB", double(packed.size) * 1e-6);
  std::string text = packed.name + ": " + size;
  if (!packed.glibc.empty()) text += ", needs glibc " + packed.glibc;
  if (!released)
    text += " (development build; `bash fmu/release.sh` makes one for older hosts and for win64)";
  return text;
}

int pack(const Options& options) {
  if (options.fmi != 2) return fail(kBadInput, "--fmi is " + std::to_string(options.fmi) + "; allowed: 2");
  if (const std::string problem =
          output_problem("--output", options.file, scene::scene_files(options.scene_file));
      !problem.empty())
    return fail(kBadInput, problem);
  std::string problem;
  const std::vector<package::Platform> platforms =
      package::platforms_built(package::program_folder(), options.build, options.platforms, problem);
  if (platforms.empty()) return fail(kBadInput, problem);
  const Cloth cloth = cloth_open(options.scene_file);
  if (!cloth) return kBadInput;
  std::vector<Problem> problems;  // stays empty: the cloth has just been opened from the same file
  const std::string picture = figures::picture_svg(validation::scene_load(options.scene_file, problems));
  const std::vector<package::PackedPlatform> packed =
      package::fmu_pack(cloth.get(), options.nodes, platforms, picture, options.file, problem);
  if (packed.empty()) return fail(kBadInput, problem);
  for (std::size_t k = 0; k < packed.size(); ++k)
    std::printf("%s\n", packed_text(packed[k], platforms[k].released).c_str());
  return kDone;
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
  option_add(*command, "--platforms",
             [options](const std::string& text) { options->platforms = words_of(text); },
             "what the FMU is for; default: all that are built", {.type = "linux64,win64"});
  option_add(*command, "--build", [options](const std::string& text) { options->build = kBuilds.at(text); },
             "which binaries; default: those of the release build, unless the development build is younger",
             {.type = "release|development", .choices = {"release", "development"}});
  command_on_run(*command, [options, &exit_code] { exit_code = pack(*options); });
}

}  // namespace drape::command
