// The `drape` command.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>
#include <system_error>

#include "command/command.h"
#include "scene/reader/read.h"
#include "scene/spelling.h"

namespace drape::command {
namespace {

void log_quiet(void*, drape_log_kind kind, const char* message) {
  if (kind == DRAPE_LOG_ERROR) std::fprintf(stderr, "error: %s\n", message);
  if (kind == DRAPE_LOG_WARNING) std::fprintf(stderr, "warning: %s\n", message);
}

void log_verbose(void*, drape_log_kind kind, const char* message) {
  constexpr const char* kKinds[] = {"error", "warning", "event", "stability"};
  std::fprintf(stderr, "%s: %s\n", kKinds[kind], message);
}

// Turns `--set A=1 B=2` into `--set A=1 --set B=2`: words after a setting that look like settings are
// settings. In reverse order, as CLI11 expects.
std::vector<std::string> arguments_of(int argc, char** argv) {
  std::vector<std::string> arguments;
  bool setting = false;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool option = word == "--set" || word.rfind("--set=", 0) == 0;
    const bool value = !option && !word.empty() && word[0] != '-' && word.find('=') != std::string::npos;
    if (setting && value && arguments.back() != "--set") arguments.push_back("--set");
    setting = option || (setting && value);
    arguments.push_back(word);
  }
  std::reverse(arguments.begin(), arguments.end());
  return arguments;
}

// What is wrong with the first word; empty if nothing is.
std::string command_problem(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return "";
  std::vector<std::string> commands;
  std::string all;
  for (const CLI::App* command : app.get_subcommands({})) {
    commands.push_back(command->get_name());
    all += (all.empty() ? "" : ", ") + command->get_name();
  }
  if (std::find(commands.begin(), commands.end(), argv[1]) != commands.end()) return "";
  const std::string nearest = scene::spelling_nearest(argv[1], commands);
  return "unknown command '" + std::string(argv[1]) + "'; " +
         (nearest.empty() ? "known: " + all : "the nearest is '" + nearest + "'") + "; see drape --help";
}

}  // namespace

CLI::Option* option_scene(CLI::App& command, std::string& scene_file) {
  return command.add_option("SCENE", scene_file, "scene file (TOML)")->required();
}

CLI::Option* option_nodes(CLI::App& command, description::Nodes& nodes) {
  static const std::map<std::string, description::Nodes> kChoices = {
      {"none", description::Nodes::kNone},
      {"outline", description::Nodes::kOutline},
      {"all", description::Nodes::kAll}};
  const auto choose = [&nodes](const std::string& text) {
    const auto choice = kChoices.find(text);
    if (choice == kChoices.end())
      throw CLI::ValidationError("--nodes", "'" + text + "'; allowed: none, outline, all");
    nodes = choice->second;
  };
  return command.add_option_function<std::string>("--nodes", choose, "particles with variables of their own")
      ->type_name("none|outline|all");
}

// An option for a time above 0 s. Without the option, `seconds` keeps its value.
CLI::Option* option_seconds(CLI::App& command, const char* name, double& seconds, const char* description) {
  const auto problem = [](const std::string& text) {
    double value = 0;
    const bool number = CLI::detail::lexical_cast(text, value);
    return number && value > 0 && std::isfinite(value) ? "" : "'" + text + "' s; allowed: above 0 s, finite";
  };
  return command.add_option(name, seconds, description)->check(problem)->type_name("SECONDS");
}

Cloth cloth_open(const std::string& scene_file, bool verbose) {
  return Cloth(drape_open(scene_file.c_str(), verbose ? log_verbose : log_quiet, nullptr));
}

std::string output_problem(const std::string& option, const std::string& file,
                           const std::string& scene_file) {
  if (file.empty()) return option + " is empty; allowed: the name of a file";
  for (const std::filesystem::path& read : scene::scene_files(scene_file)) {
    std::error_code error;
    if (std::filesystem::equivalent(file, read, error))
      return option + " is " + file + ", which the scene is read from; allowed: any other file";
  }
  return "";
}

int fail(ExitCode code, const std::string& sentence) {
  std::fprintf(stderr, "error: %s\n", sentence.c_str());
  return code;
}

}  // namespace drape::command

int main(int argc, char** argv) {
  using namespace drape;
  CLI::App app{"Drape: woven cloth as a co-simulation unit", "drape"};
  app.set_version_flag("--version", std::string("drape ") + drape_version());
  app.require_subcommand(1);
  int exit_code = command::kDone;
  command::command_check(app, exit_code);
  command::command_pack(app, exit_code);
  command::command_run(app, exit_code);
  command::command_reference(app, exit_code);
  command::command_variables(app, exit_code);
  command::command_bench(app, exit_code);
  command::command_fabric(app, exit_code);
  command::command_import(app, exit_code);
  command::command_form(app, exit_code);
  if (const std::string problem = command::command_problem(app, argc, argv); !problem.empty())
    return command::fail(command::kBadInput, problem);
  try {
    app.parse(command::arguments_of(argc, argv));
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);  // --help, --version
    return command::fail(command::kBadInput, std::string(e.what()) + "; see drape --help");
  } catch (const std::exception& e) {
    return command::fail(command::kFailedRun, e.what());
  }
  return exit_code;
}
