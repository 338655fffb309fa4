// The program of the benchmark, which `drape bench` starts.
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "bench/bench.h"
#include "bench/precision/precision.h"
#include "bench/seams.h"
#include "command/command.h"

namespace drape::bench {
namespace {

using command::fail, command::kDone, command::kBadInput, command::kFailedRun;

constexpr const char *kPrecision = "precision", *kSeams = "seams";  // groups with tables of their own

struct Options {
  std::vector<std::string> groups, scenes;
  std::string csv_file;
  bool quick = false;
};

void row_print(const Row& row) {
  std::printf("%-34s %9zu  %-9s %9.1f  %7.3f x %s\n", row.name.c_str(), row.particles, row.contender.c_str(),
              row.rate, row.ratio, row.against.c_str());
  std::fflush(stdout);
}

bool rows_write(const std::string& file, const std::vector<Row>& rows) {
  std::FILE* out = std::fopen(file.c_str(), "w");
  if (!out) return false;
  std::fprintf(out, "group,name,particles,kernel,million_particle_steps_per_s,ratio,against\n");
  for (const Row& r : rows)
    std::fprintf(out, "%s,\"%s\",%zu,%s,%.6g,%.6g,\"%s\"\n", r.group.c_str(), r.name.c_str(), r.particles,
                 r.contender.c_str(), r.rate, r.ratio, r.against.c_str());
  return std::fclose(out) == 0;
}

// Runs a group with rows of its own and a table per scene.
int run_precision(const Options& options) {
  const std::vector<PrecisionRow> rows = precision(options.quick);
  if (options.csv_file.empty()) return kDone;
  std::FILE* out = std::fopen(options.csv_file.c_str(), "w");
  if (!out) return fail(kBadInput, options.csv_file + " cannot be written");
  precision_write(out, rows);
  return std::fclose(out) == 0 ? kDone : fail(kBadInput, options.csv_file + " cannot be written");
}

int run_bench(const Options& options) {
  if (options.groups == std::vector<std::string>{kPrecision}) return run_precision(options);
  if (options.groups == std::vector<std::string>{kSeams})
    return seams_print(options.csv_file, options.quick)
               ? kDone
               : fail(kBadInput, options.csv_file + " cannot be written");
  for (const std::string& name : options.groups)
    if (name == kPrecision || name == kSeams)
      return fail(kBadInput, "the group " + name + " has columns of its own; name it alone");
  Patience patience;
  if (options.quick) patience = {1, 0.002, {}};
  patience.scenes = options.scenes;
  bool valid = true;
  for (const std::string& file : options.scenes) valid = command::cloth_open(file) && valid;
  if (!valid) return kBadInput;
  std::vector<Row> rows;
  for (const Group& group : groups()) {
    bool chosen = options.groups.empty() && group.by_default;
    for (const std::string& name : options.groups) chosen = chosen || name == group.name;
    if (!chosen) continue;
    std::printf("%s: %s\n%-34s %9s  %-9s %9s  %s\n", group.name, group.description, "", "particles", "kernel",
                "million/s", "ratio");
    for (const Row& row : group.rows(patience)) {
      row_print(row);
      rows.push_back(row);
    }
  }
  if (!options.csv_file.empty() && !rows_write(options.csv_file, rows))
    return fail(kBadInput, options.csv_file + " cannot be written");
  return kDone;
}

void options_add(CLI::App& app, Options& options) {
  std::vector<std::string> names;
  for (const Group& group : groups()) names.push_back(group.name);
  names.push_back(kPrecision);
  names.push_back(kSeams);
  app.add_option("GROUP", options.groups,
                 "groups to run; default: all but threads, scenes, precision and seams")
      ->check(CLI::IsMember(names));
  app.add_option("--csv", options.csv_file, "also writes the rows to a file")->type_name("FILE.csv");
  app.add_option("--scene", options.scenes, "of the group `scenes`; may be given again")->type_name("SCENE");
  app.add_flag("--quick", options.quick, "seconds in all, no figures to rely on");
}

int command_run(int argc, char** argv) {
  CLI::App app{"measure particle-steps per second; pin it to one core", "drape bench"};
  Options options;
  options_add(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);  // --help
    return fail(kBadInput, std::string(e.what()) + "; see drape --help");
  }
  return run_bench(options);
}

}  // namespace
}  // namespace drape::bench

int main(int argc, char** argv) {
  using namespace drape::bench;
  try {
    return command_run(argc, argv);
  } catch (const std::exception& e) {
    return fail(kFailedRun, e.what());
  }
}
