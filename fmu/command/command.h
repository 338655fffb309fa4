// The commands of `drape`. Each function adds a command to the command line. When the command has run, its
// exit code is in `exit_code`.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "command/arguments.h"
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
void command_smooth(CLI::App& fabric, int& exit_code);  // adds `smooth` to `drape fabric`
void command_import(CLI::App& app, int& exit_code);
void command_form(CLI::App& app, int& exit_code);

// Options that several commands share.
CLI::Option* option_scene(CLI::App& command, std::string& scene_file);
CLI::Option* option_nodes(CLI::App& command, description::Nodes& nodes);
CLI::Option* option_seconds(CLI::App& command, const char* name, double& seconds, const char* description);

// Opens the scene. Its problems and later messages go to standard error; events only when `verbose`. Returns
// null on bad input.
struct ClothCloser {
  void operator()(drape_cloth* cloth) const { drape_close(cloth); }
};
using Cloth = std::unique_ptr<drape_cloth, ClothCloser>;
Cloth cloth_open(const std::string& scene_file, bool verbose = false);

// Why the file that an option names may not be written: it has no name, or it is one of those that are read.
// Empty if it may.
std::string output_problem(const std::string& option, const std::string& file,
                           const std::vector<std::filesystem::path>& read);

// What is wrong with the files of a run: --output without a name, --inputs without one, or an outputs.csv
// that is one of the files that are read. `read`: gets these files.
std::vector<std::string> run_files_problems(const std::string& scene_file, const std::string& folder,
                                            const std::optional<std::string>& inputs_file,
                                            std::vector<std::filesystem::path>& read);

// A sentence on elongations so small that they may be fractions; empty where they are not. `end`: the last
// elongation (fraction), `force`: there (N).
std::string fraction_doubt(const std::string& fabric, const std::string& along, double end, double force);

// Prints "error: ..." on standard error and returns the code.
int fail(ExitCode code, const std::string& sentence);

// Writes a file, or prints why it cannot: kBadInput where the place cannot be written to, kFailedRun where it
// is full.
int file_put(const std::string& file, const std::string& text);

}  // namespace drape::command
