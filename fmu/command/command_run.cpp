#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <optional>

#include "command/command.h"
#include "command/files/csv.h"
#include "command/files/frames.h"
#include "command/files/input_table.h"
#include "command/files/report.h"
#include "command/files/whole_file.h"
#include "decimal.h"
#include "scene/diagnostics.h"

namespace drape::command {
namespace {

namespace fs = std::filesystem;

constexpr double kRest = 1e-5;  // of the load: the residual of a fit at rest

struct Options {
  std::string scene_file, folder;
  double until = 0, every = 0;             // s; 0: the scene's duration, and a hundredth of it
  std::vector<std::string> settings;       // NAME=VALUE
  std::optional<std::string> inputs_file;  // CSV
  std::optional<std::string> report;       // text, or CSV by its ending
  std::optional<double> limit;             // %, of elongation in the report
  bool frames = false, verbose = false;
  description::Nodes nodes = description::Nodes::kNone;
};

// Applies NAME=VALUE. Returns what is wrong with it, or an empty text.
std::string apply_setting(const std::vector<description::Variable>& table, const std::string& setting) {
  const std::size_t equals = setting.find('=');
  if (equals == std::string::npos) return "--set is '" + setting + "'; allowed: NAME=VALUE";
  const std::string name = setting.substr(0, equals), text = setting.substr(equals + 1);
  double value = 0;
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';  // from_chars accepts no plus
  const auto [end, error] = std::from_chars(text.data() + plus, text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    return "--set " + name + " is '" + text + "'; allowed: a number";
  const description::Variable* v = description::variable_find(table, name);
  if (!v) {
    const std::string nearest = description::variable_nearest(table, name);
    return "--set names the unknown variable '" + name + "'; " +
           (nearest.empty() ? "`drape variables SCENE` lists them" : "the nearest is '" + nearest + "'");
  }
  if (v->causality == description::Causality::kOutput)
    return "--set names the output '" + name + "'; allowed: parameters and inputs";
  const std::string problem = description::range_problem(*v, value);
  if (problem.empty()) *v->setting = value;
  return problem.empty() ? "" : "--set " + problem;
}

// Applies the settings before the start and reads the inputs. Prints all problems.
int apply_settings(const Options& options, drape_cloth* cloth,
                   const std::vector<description::Variable>& table, InputTable& inputs) {
  std::vector<std::string> problems;
  for (const std::string& setting : options.settings)
    if (const std::string problem = apply_setting(table, setting); !problem.empty())
      problems.push_back(problem);
  if (options.inputs_file) inputs = input_table_read(*options.inputs_file, table, problems);
  for (const std::string& problem : problems) fail(kBadInput, problem);
  return problems.empty() && drape_commit(cloth) == DRAPE_OK ? kDone : kBadInput;
}

// Writes the present time and outputs as a row of the CSV file, and as a frame.
struct Recorder {
  drape_cloth* cloth;
  std::vector<const double*> columns;
  bool nodes;
  Csv csv;
  bool with_frames;
  Frames frames;
  bool frames_written = true;
};

// The cloth and the inputs that move it from row to row.
struct Driven {
  drape_cloth* cloth;
  const std::vector<description::Variable>& table;
  InputTable inputs;  // without rows: no inputs
};

bool record(Recorder& r, double time) {
  drape_get_outputs(r.cloth, r.nodes ? DRAPE_OUT_ALL : DRAPE_OUT_SCALARS);
  std::vector<double> row{time};
  for (const double* value : r.columns) row.push_back(*value);
  csv_row(r.csv, row);
  if (r.with_frames) r.frames_written = frame_write(r.frames, r.cloth, time);
  return r.csv.file.good() && r.frames_written;
}

void show_progress(double time, double until) {
  static const bool terminal = isatty(STDERR_FILENO);
  if (terminal)
    std::fprintf(stderr, "\r%5.1f %%  t = %.6g s%s", 100 * time / until, time, time < until ? "" : "\n");
}

// Advances from `time` by `length`. With inputs, it takes steps of the communication interval (the last may
// be shorter) and sets each step's inputs to the values at its end.
drape_status advance(const Driven& driven, double time, double length) {
  if (driven.inputs.time.empty()) return drape_advance(driven.cloth, length);
  const double q = drape_communication(driven.cloth);
  const double rounding = 1e-9 + 4 * std::numeric_limits<double>::epsilon() * (time + length) / q;
  const double steps = std::max(1.0, std::ceil(length / q - rounding));
  drape_status status = DRAPE_OK;
  for (double k = 1; k <= steps && status == DRAPE_OK; ++k) {
    input_table_apply(driven.inputs, time + (k < steps ? k * q : length), driven.table);
    status = drape_advance(driven.cloth, k < steps ? q : length - (steps - 1) * q);
  }
  return status;
}

// Set by an interrupt (Ctrl-C): the run ends after its row. A second one ends the program at once.
volatile std::sig_atomic_t interrupted = 0;
void interrupt(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);
}

// Writes rows at 0, DT, 2 DT, ... and at the end. Each row is reached from the one before. The times are
// written as these products; the cloth's clock, a sum, may differ from them by rounding.
int run_rows(Recorder& r, const Driven& driven, double until, double every) {
  const double rows = std::ceil(until / every - 1e-9);  // a last interval below a billionth of DT is rounding
  if (!driven.inputs.time.empty()) input_table_apply(driven.inputs, 0, driven.table);
  drape_inputs_start(driven.cloth);
  if (!record(r, 0)) return kFailedRun;
  for (double k = 1; k <= rows; ++k) {
    const double before = (k - 1) * every, time = k < rows ? k * every : until;
    const double length = k < rows ? every : until - before;
    if (advance(driven, before, length) != DRAPE_OK)
      return kFailedRun;  // the last row is the last good state
    const bool at_rest = drape_at_rest(driven.cloth);
    if (!record(r, time)) return kFailedRun;
    show_progress(at_rest ? until : time, until);
    if (at_rest && driven.inputs.time.empty()) break;
    if (interrupted && k < rows)
      return fail(kFailedRun, "interrupted at " + description::decimal_text(time) +
                                  " s; what was asked for is complete up to there");
  }
  return kDone;
}

// What a run should have reached by the scene's duration: the rest of a fit, and seams that were to close.
// Tells what is missing; that is a warning where the run was to end before.
int ends_check(drape_cloth* cloth, bool whole) {
  const drape_outputs& o = *drape_get_outputs(cloth, DRAPE_OUT_SCALARS);
  const std::string at = "by " + scene::rounded(drape_time(cloth)) + " s ";
  int code = kDone;
  const auto tell = [&](const std::string& what) {
    if (whole) code = fail(kFailedRun, at + what);
    else std::fprintf(stderr, "warning: %s%s\n", at.c_str(), what.c_str());
  };
  if (o.has_fit && !drape_at_rest(cloth))
    tell("the fit has not come to rest: forces of " + scene::rounded(o.fit_residual) +
         " of the load are unbalanced; allowed: " + scene::rounded(kRest));
  for (int k = 0; k < o.seam_count; ++k)
    if (o.seam[k].due && o.seam[k].closed == 0)
      tell(std::string("the seam '") + o.seam[k].name + "' has not closed: its largest gap is " +
           scene::rounded(o.seam[k].gap_max) + " m");
  return code;
}

// The closing line of a run.
void print_summary(drape_cloth* cloth, double seconds) {
  const double time = drape_time(cloth);
  std::printf("%s: %.6g s of cloth in %.3g s, %.3g times its time; %.0f steps\n", drape_scene_name(cloth),
              time, seconds, time > 0 ? seconds / time : 0,
              drape_get_outputs(cloth, DRAPE_OUT_SCALARS)->step_count);
}

// Everything that is wrong with the options alone.
std::vector<std::string> options_problems(const Options& options) {
  std::vector<fs::path> read;
  std::vector<std::string> problems =
      run_files_problems(options.scene_file, options.folder, options.inputs_file, read);
  if (options.limit && !(*options.limit > 0 && *options.limit <= 1000))
    problems.push_back("--limit is " + description::decimal_text(*options.limit) +
                       " %; allowed: above 0 %, at most 1000 %");
  if (options.limit && !options.report)
    problems.push_back("--limit is of the report; allowed: together with --report FILE");
  if (!options.report) return problems;
  if (const std::string problem = output_problem("--report", *options.report, read); !problem.empty())
    problems.push_back(problem);
  std::error_code error;
  for (const char* own : {"outputs.csv", "frames.pvd", "seams.pvd", "bodies.pvd"})
    if (fs::weakly_canonical(*options.report, error) ==
        fs::weakly_canonical(fs::path(options.folder) / own, error))
      problems.push_back("--report is " + *options.report +
                         ", which the run itself writes; allowed: any other file");
  return problems;
}

int run(const Options& options) {
  const std::vector<std::string> problems = options_problems(options);
  for (const std::string& sentence : problems) fail(kBadInput, sentence);
  if (!problems.empty()) return kBadInput;
  const Cloth cloth = cloth_open(options.scene_file, options.verbose);
  if (!cloth) return kBadInput;
  const std::vector<description::Variable> table = description::variables_of(cloth.get(), options.nodes);
  Driven driven{cloth.get(), table, {}};
  if (const int code = apply_settings(options, cloth.get(), table, driven.inputs); code != kDone) return code;
  const double duration = drape_duration(cloth.get());
  Recorder r{cloth.get(), {}, options.nodes != description::Nodes::kNone, {}, options.frames, {}};
  r.frames.folder = options.folder;
  std::vector<std::string> header{"time"};
  for (const description::Variable& v : table) {
    if (v.causality != description::Causality::kOutput) continue;
    header.push_back(v.name());
    r.columns.push_back(v.value);
  }
  const double until = options.until > 0 ? options.until : duration,
               every = options.every > 0 ? options.every : duration / 100;
  constexpr double kLongest = 1e7, kMaxRows = 1e7;  // s; rows
  if (until > kLongest)
    return fail(kBadInput, "--until is " + description::decimal_text(until) + " s; allowed: at most 1e7 s");
  if (until / every > kMaxRows)
    return fail(kBadInput, "--every is " + description::decimal_text(every) + " s; allowed: at least " +
                               description::decimal_text(until / kMaxRows) +
                               " s, a ten-millionth of the time to the end");
  for (const std::string& remark :
       input_table_remarks(driven.inputs, table, drape_communication(cloth.get())))
    std::fprintf(stderr, "warning: %s\n", remark.c_str());
  std::string problem;
  if (!csv_open(r.csv, options.folder, problem)) return fail(kBadInput, problem);
  if (options.report)  // before the run, not only after it
    if (problem = place_problem(*options.report); !problem.empty())
      return fail(kBadInput, "--report: " + problem);
  csv_header(r.csv, header);
  if (std::signal(SIGINT, interrupt) == SIG_IGN) std::signal(SIGINT, SIG_IGN);  // as in a shell's background
  const auto start = std::chrono::steady_clock::now();
  int code = run_rows(r, driven, until, every);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  if (!csv_close(r.csv, problem)) return fail(kFailedRun, problem);
  if (code == kDone) code = ends_check(cloth.get(), until >= duration * (1 - 1e-9));
  if (options.report) {
    const double limit = options.limit ? *options.limit / 100 : -1;
    if (problem = report_write(*options.report, report_of(cloth.get(), limit)); !problem.empty())
      return fail(kFailedRun, problem);
  }
  if (!r.frames_written) return fail(kFailedRun, r.frames.failure);
  print_summary(cloth.get(), spent.count());
  return code;
}

}  // namespace

void command_run(CLI::App& app, int& exit_code) {
  CLI::App* command = command_add(app, "run", "run a scene and write outputs.csv");
  auto options = std::make_shared<Options>();
  option_scene(*command, options->scene_file);
  option_add(*command, "-o,--output", options->folder, "folder for the results",
             {.type = "DIR", .required = true});
  option_seconds(*command, "--until", options->until, "end time; default: the scene's duration");
  option_seconds(*command, "--every", options->every,
                 "time between rows; default: a hundredth of the duration");
  option_add(*command, "--set", options->settings, "the start value of a parameter or an input",
             {.type = "NAME=VALUE ...", .one_each = true});
  option_add(*command, "--inputs", options->inputs_file, "inputs over time: a column 'time' and any inputs",
             {.type = "FILE.csv"});
  flag_add(*command, "--frames", options->frames,
           "write a .vtp for every row: frames.pvd, and seams.pvd, bodies.pvd where there are any");
  option_add(*command, "--report", options->report,
             "write elongations, seams and contact at the end; with the ending .csv one value a line",
             {.type = "FILE"});
  option_add(*command, "--limit", options->limit,
             "elongation beyond which the report counts area; default: the tested range",
             {.type = "PERCENT"});
  option_nodes(*command, options->nodes);
  flag_add(*command, "-v,--verbose", options->verbose, "print events and changes of the step");
  command_on_run(*command, [options, &exit_code] { exit_code = run(*options); });
}

}  // namespace drape::command
