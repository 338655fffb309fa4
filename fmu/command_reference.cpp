#include <cstdio>

#include "command.h"
#include "csv.h"
#include "reference/run.h"
#include "scene/read.h"

namespace drape {
namespace {

struct Options {
  std::string scene_file, folder;
  reference::Options run;
};

int run_reference(const Options& options) {
  if (options.folder.empty()) return fail(kBadInput, "--output is empty; allowed: the name of a folder");
  std::vector<Problem> problems;
  const Scene scene = scene_read(options.scene_file, problems);
  for (const Problem& problem : problems) fail(kBadInput, problem.place + " " + problem.message);
  if (!problems.empty()) return kBadInput;
  Csv csv;
  std::string trouble;
  if (!csv_open(csv, options.folder, trouble)) return fail(kBadInput, trouble);
  reference::Sink sink;
  sink.columns = [&](const std::vector<std::string>& names) { csv_header(csv, names); };
  sink.row = [&](const std::vector<double>& values) { csv_row(csv, values); };
  sink.error = [](const std::string& sentence) { fail(kFailedRun, sentence); };
  const int code = reference::reference_run(scene, options.run, sink);
  return csv_close(csv, trouble) ? code : fail(kFailedRun, trouble);
}

}  // namespace

void command_reference(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(
      "reference",
      "integrate the same equations by ARKODE, to a tolerance; columns as of `run`, without step.stability");
  auto options = std::make_shared<Options>();
  option_scene(*command, options->scene_file);
  command->add_option("-o,--output", options->folder, "folder for outputs.csv")->required()->type_name("DIR");
  command->add_option("--rtol", options->run.rtol, "relative tolerance")
      ->capture_default_str()
      ->type_name("R");
  command->add_option("--order", options->run.order, "order of the method")
      ->capture_default_str()
      ->type_name("P");
  option_seconds(*command, "--until", options->run.until, "end time; default: the scene's duration");
  option_seconds(*command, "--every", options->run.every,
                 "time between rows; default: a hundredth of the duration");
  command
      ->add_option_function<std::string>(
          "--nodes", [options](const std::string& which) { options->run.nodes = which == "all"; },
          "particles with variables of their own")
      ->check(CLI::IsMember({"none", "all"}))
      ->type_name("none|all");
  command->callback([options, &exit_code] { exit_code = run_reference(*options); });
}

}  // namespace drape
