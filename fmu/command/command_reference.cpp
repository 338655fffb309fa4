#include <cstdio>

#include "command/command.h"
#include "command/files/csv.h"
#include "command/files/input_table.h"
#include "reference/run.h"
#include "validation/load.h"

namespace drape::command {
namespace {

struct Options {
  std::string scene_file, folder;
  std::optional<std::string> inputs_file;
  reference::Options run;
};

// Reads the table of inputs, by the names that the reference solver knows. Checks the names against the
// variables of the cloth. Prints all problems.
bool inputs_read(const std::string& scene_file, const std::string& file, reference::InputTable& inputs) {
  const Cloth cloth = cloth_open(scene_file);
  if (!cloth) return false;
  const std::vector<description::Variable> variables =
      description::variables_of(cloth.get(), description::Nodes::kNone);
  std::vector<std::string> problems;
  const InputTable table = input_table_read(file, variables, problems);
  for (const std::string& problem : problems) fail(kBadInput, problem);
  for (const std::size_t k : table.variable) inputs.names.push_back(variables[k].name());
  inputs.time = table.time;
  for (std::size_t row = 0; row < table.time.size(); ++row) {
    const auto first = table.value.begin() + std::ptrdiff_t(row * table.variable.size());
    inputs.value.emplace_back(first, first + std::ptrdiff_t(table.variable.size()));
  }
  return problems.empty();
}

int run_reference(const Options& options) {
  std::vector<std::filesystem::path> read;
  const std::vector<std::string> of_files =
      run_files_problems(options.scene_file, options.folder, options.inputs_file, read);
  for (const std::string& sentence : of_files) fail(kBadInput, sentence);
  if (!of_files.empty()) return kBadInput;
  std::vector<Problem> problems;
  const Scene scene = validation::scene_load(options.scene_file, problems);
  for (const Problem& problem : problems) fail(kBadInput, problem.place + " " + problem.message);
  if (!problems.empty()) return kBadInput;
  reference::Options run = options.run;
  if (options.inputs_file && !inputs_read(options.scene_file, *options.inputs_file, run.inputs))
    return kBadInput;
  Csv csv;
  std::string problem;
  if (!csv_open(csv, options.folder, problem)) return fail(kBadInput, problem);
  reference::Sink sink;
  sink.columns = [&](const std::vector<std::string>& names) { csv_header(csv, names); };
  sink.row = [&](const std::vector<double>& values) { csv_row(csv, values); };
  sink.error = [](const std::string& sentence) { fail(kFailedRun, sentence); };
  const int code = reference::reference_run(scene, run, sink);
  return csv_close(csv, problem) ? code : fail(kFailedRun, problem);
}

}  // namespace

void command_reference(CLI::App& app, int& exit_code) {
  CLI::App* command = command_add(
      app, "reference",
      "integrate the same equations by ARKODE, to a tolerance; columns as of `run`, without step.stability");
  auto options = std::make_shared<Options>();
  option_scene(*command, options->scene_file);
  option_add(*command, "-o,--output", options->folder, "folder for outputs.csv",
             {.type = "DIR", .required = true});
  option_add(*command, "--rtol", options->run.rtol, "relative tolerance",
             {.type = "R", .default_shown = true});
  option_add(*command, "--order", options->run.order, "order of the method",
             {.type = "P", .default_shown = true});
  option_add(*command, "--inputs", options->inputs_file, "inputs over time: a column 'time' and any inputs",
             {.type = "FILE.csv"});
  option_seconds(*command, "--until", options->run.until, "end time; default: the scene's duration");
  option_seconds(*command, "--every", options->run.every,
                 "time between rows; default: a hundredth of the duration");
  option_add(*command, "--nodes",
             [options](const std::string& which) { options->run.nodes = which == "all"; },
             "particles with variables of their own", {.type = "none|all", .choices = {"none", "all"}});
  command_on_run(*command, [options, &exit_code] { exit_code = run_reference(*options); });
}

}  // namespace drape::command
