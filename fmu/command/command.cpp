#include "command/command.h"

#include <filesystem>
#include <map>
#include <system_error>

#include "command/files/whole_file.h"
#include "command/status_line.h"
#include "scene/reader/read.h"

namespace drape::command {
namespace {

void log_quiet(void*, drape_log_kind kind, const char* message) {
  if (kind == DRAPE_LOG_ERROR) message_print("error", message);
  if (kind == DRAPE_LOG_WARNING) message_print("warning", message);
}

void log_verbose(void*, drape_log_kind kind, const char* message) {
  constexpr const char* kKinds[] = {"error", "warning", "event", "stability"};
  message_print(kKinds[kind], message);
}

}  // namespace

CLI::Option* option_scene(CLI::App& command, std::string& scene_file) {
  return option_add(command, "SCENE", scene_file, "scene file (TOML)", {.required = true});
}

CLI::Option* option_nodes(CLI::App& command, description::Nodes& nodes) {
  static const std::map<std::string, description::Nodes> kChoices = {
      {"none", description::Nodes::kNone},
      {"outline", description::Nodes::kOutline},
      {"all", description::Nodes::kAll}};
  const auto problem = [](const std::string& text) {
    return kChoices.contains(text) ? "" : "'" + text + "'; allowed: none, outline, all";
  };
  return option_add(command, "--nodes", [&nodes](const std::string& text) { nodes = kChoices.at(text); },
                    "particles with variables of their own",
                    {.type = "none|outline|all", .problem = problem});
}

// An option for a time above 0 s. Without the option, `seconds` keeps its value.
CLI::Option* option_seconds(CLI::App& command, const char* name, double& seconds, const char* description) {
  const auto problem = [](const std::string& text) {
    return is_positive_number(text) ? "" : "'" + text + "' s; allowed: above 0 s, finite";
  };
  return option_add(command, name, seconds, description, {.type = "SECONDS", .problem = problem});
}

Cloth cloth_open(const std::string& scene_file, bool verbose) {
  return Cloth(drape_open(scene_file.c_str(), verbose ? log_verbose : log_quiet, nullptr));
}

std::string output_problem(const std::string& option, const std::string& file,
                           const std::vector<std::filesystem::path>& read) {
  if (file.empty()) return option + " is empty; allowed: the name of a file";
  for (const std::filesystem::path& one : read) {
    std::error_code error;
    if (std::filesystem::equivalent(file, one, error))
      return option + " is " + file + ", which is read from; allowed: any other file";
  }
  return "";
}

std::vector<std::string> run_files_problems(const std::string& scene_file, const std::string& folder,
                                            const std::optional<std::string>& inputs_file,
                                            std::vector<std::filesystem::path>& read) {
  std::vector<std::string> problems;
  read = scene::scene_files(scene_file);
  if (inputs_file) read.emplace_back(*inputs_file);
  if (inputs_file && inputs_file->empty())
    problems.emplace_back("--inputs is empty; allowed: the name of a CSV file");
  if (folder.empty()) {
    problems.emplace_back("--output is empty; allowed: the name of a folder");
  } else if (const std::string problem = output_problem(
                 "the table of --output", (std::filesystem::path(folder) / "outputs.csv").string(), read);
             !problem.empty()) {
    problems.push_back(problem);
  }
  return problems;
}

std::string fraction_doubt(const std::string& fabric, const std::string& along, double end, double force) {
  constexpr double kSmall = 0.005;
  if (end > kSmall) return "";
  char text[32], newtons[32];
  std::snprintf(text, sizeof text, "%.4g", 100 * end);
  std::snprintf(newtons, sizeof newtons, "%.6g", force);
  return "fabric " + fabric + ": " + along + " ends at " + text + " % with " + newtons +
         " N; if its elongations are fractions, elongation_percent is 100 times as large";
}

int fail(ExitCode code, const std::string& sentence) {
  message_print("error", sentence);
  return code;
}

int file_put(const std::string& file, const std::string& text) {
  const Written written = file_write(file, text);
  return written.problem.empty() ? kDone : fail(written.full ? kFailedRun : kBadInput, written.problem);
}

}  // namespace drape::command
