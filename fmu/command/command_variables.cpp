#include <cstdio>

#include "command/command.h"
#include "description.h"

namespace drape::command {
namespace {

struct Options {
  std::string scene_file;
  bool xml = false;
  description::Nodes nodes = description::Nodes::kNone;
};

int variables(const Options& options) {
  const Cloth cloth = cloth_open(options.scene_file);
  if (!cloth) return kBadInput;
  const description::Description description = description::description_of(cloth.get(), options.nodes);
  const std::string text = options.xml ? description::description_xml_fmi2(description)
                                       : description::description_markdown(description);
  std::fwrite(text.data(), 1, text.size(), stdout);
  return std::fflush(stdout) == 0 ? kDone : fail(kFailedRun, "cannot write to standard output");
}

}  // namespace

void command_variables(CLI::App& app, int& exit_code) {
  CLI::App* command =
      command_add(app, "variables", "print the variables of a scene's FMU as a Markdown table");
  auto options = std::make_shared<Options>();
  option_scene(*command, options->scene_file);
  option_nodes(*command, options->nodes);
  flag_add(*command, "--xml", options->xml, "print modelDescription.xml instead");
  command_on_run(*command, [options, &exit_code] { exit_code = variables(*options); });
}

}  // namespace drape::command
