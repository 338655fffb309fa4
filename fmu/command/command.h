// The commands of `drape`. Each adds itself to the command line; its exit code goes to `exit_code` when it
// has run.
#pragma once
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <memory>
#include <string>
#include <vector>

#include "drape/drape.h"
#include "variables.h"

namespace drape::command {

enum ExitCode { kDone = 0, kBadInput = 1, kFailedRun = 2 };

void command_check(CLI::App& app, int& exit_code);
void command_pack(CLI::App& app, int& exit_code);
void command_run(CLI::App& app, int& exit_code);
void command_reference(CLI::App& app, int& exit_code);
void command_variables(CLI::App& app, int& exit_code);
void command_bench(CLI::App& app, int& exit_code);
void command_fabric(CLI::App& app, int& exit_code);
void command_import(CLI::App& app, int& exit_code);
void command_form(CLI::App& app, int& exit_code);

// Options that several commands share.
CLI::Option* option_scene(CLI::App& command, std::string& scene_file);
CLI::Option* option_nodes(CLI::App& command, description::Nodes& nodes);
CLI::Option* option_seconds(CLI::App& command, const char* name, double& seconds, const char* description);

// Opens the scene; its problems and later messages go to standard error, events only when `verbose`. Null:
// bad input.
struct ClothCloser {
  void operator()(drape_cloth* cloth) const { drape_close(cloth); }
};
using Cloth = std::unique_ptr<drape_cloth, ClothCloser>;
Cloth cloth_open(const std::string& scene_file, bool verbose = false);

// Empty, or why the file that an option names may not be written: it has no name, or the scene is read from
// it.
std::string output_problem(const std::string& option, const std::string& file, const std::string& scene_file);

// "error: ..." on standard error; returns the code.
int fail(ExitCode code, const std::string& sentence);

}  // namespace drape::command
