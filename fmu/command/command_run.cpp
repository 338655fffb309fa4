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
#include "command/progress.h"
#include "command/status_line.h"
#include "decimal.h"
#include "instance/balance_watch.h"
#include "instance/unfinished.h"

namespace drape::command {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string scene_file, folder;
  double until = 0, every = 0;             // s; 0: the scene's duration, and a hundredth of it
  std::vector<std::string> settings;       // NAME=VALUE
  std::optional<std::string> inputs_file;  // CSV
  std::optional<std::string> report;       // text, or CSV by its ending
  std::optional<double> limit;             // %, of elongation in the report
  bool frames = false, verbose = false;
  bool progress = false, no_progress = false;  // whatever standard error is
  description::Nodes nodes = description::Nodes::kNone;
};

// The value that a word stands for: true and false, and the modes.
std::optional<double> word_value(const description::Variable& v, const std::string& text) {
  if (v.type == description::Type::kBoolean && (text == "true" || text == "false")) return text == "true";
  for (std::size_t k = 0; k < std::size(description::kModeNames); ++k)
    if (v.type == description::Type::kMode && text == description::kModeNames[k]) return double(k + 1);
  return std::nullopt;
}

// Applies NAME=VALUE. Returns what is wrong with it, or an empty text.
std::string apply_setting(const std::vector<description::Variable>& table, const std::string& setting) {
  const std::size_t equals = setting.find('=');
  if (equals == std::string::npos) return "--set is '" + setting + "'; allowed: NAME=VALUE";
  const std::string name = setting.substr(0, equals), text = setting.substr(equals + 1);
  double value = 0;
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';  // from_chars accepts no plus
  const auto [end, error] = std::from_chars(text.data() + plus, text.data() + text.size(), value);
  const description::Variable* v = description::variable_find(table, name);
  const std::optional<double> word = v ? word_value(*v, text) : std::nullopt;
  if (word) value = *word;
  else if (error != std::errc() || end != text.data() + text.size())
    return "--set " + name + " is '" + text + "'; allowed: a number" +
           (v && v->type == description::Type::kBoolean ? ", true or false" : "");
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

// Where the time of a run went.
struct Stages {
  using Clock = std::chrono::steady_clock;
  Clock::time_point last = Clock::now();
  double reading = 0, stepping = 0, outputs = 0, frames = 0, report = 0;  // s
};

// Adds the time since the last call to a stage.
void stage_end(Stages& stages, double Stages::* stage) {
  const Stages::Clock::time_point now = Stages::Clock::now();
  stages.*stage += std::chrono::duration<double>(now - stages.last).count();
  stages.last = now;
}

// Writes the present time and outputs as a row of the CSV file, and as a frame.
struct Recorder {
  drape_cloth* cloth;
  std::vector<const double*> columns;
  bool nodes;
  Csv csv;
  bool with_frames;
  Frames frames;
  Stages& stages;
  instance::BalanceWatch balance;
  bool frames_written = true;
};

// The cloth and the inputs that move it from row to row.
struct Driven {
  drape_cloth* cloth;
  const std::vector<description::Variable>& table;
  InputTable inputs;  // without rows: no inputs
};

bool record(Recorder& r, double time) {
  instance::balance_update(r.balance,
                           *drape_get_outputs(r.cloth, r.nodes ? DRAPE_OUT_ALL : DRAPE_OUT_SCALARS), time);
  std::vector<double> row{time};
  for (const double* value : r.columns) row.push_back(*value);
  csv_row(r.csv, row);
  stage_end(r.stages, &Stages::outputs);
  if (r.with_frames) r.frames_written = frame_write(r.frames, r.cloth, time);
  stage_end(r.stages, &Stages::frames);
  return r.csv.file.good() && r.frames_written;
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
    const drape_status status = advance(driven, before, length);
    stage_end(r.stages, &Stages::stepping);
    if (status != DRAPE_OK) return kFailedRun;  // the last row is the last good state
    const bool at_rest = drape_at_rest(driven.cloth);
    if (!record(r, time)) return kFailedRun;
    if (at_rest && driven.inputs.time.empty()) break;
    if (interrupted && k < rows)
      return fail(kFailedRun, "interrupted at " + description::decimal_text(time) +
                                  " s; what was asked for is complete up to there");
  }
  return kDone;
}

// Reports what the run should have reached by the scene's duration: an error, or a warning where the run was
// to end before.
int ends_check(drape_cloth* cloth, bool whole) {
  const std::vector<std::string> unfinished = instance::unfinished(cloth);
  for (const std::string& sentence : unfinished) message_print(whole ? "error" : "warning", sentence);
  return whole && !unfinished.empty() ? kFailedRun : kDone;
}

// The closing line of a run.
void print_summary(drape_cloth* cloth, const Stages& s) {
  const double time = drape_time(cloth), total = s.reading + s.stepping + s.outputs + s.frames + s.report;
  std::printf(
      "%s: %.6g s of cloth in %.3g s, %.3g times its time; %.0f steps; reading %.2g s, stepping %.3g s, ",
      drape_scene_name(cloth), time, total, time > 0 ? total / time : 0,
      drape_get_outputs(cloth, DRAPE_OUT_SCALARS)->step_count, s.reading, s.stepping);
  std::printf("outputs %.2g s", s.outputs);
  if (s.frames > 0) std::printf(", frames %.2g s", s.frames);
  if (s.report > 0) std::printf(", report %.2g s", s.report);
  std::printf("\n");
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
  if (options.progress && options.no_progress)
    problems.emplace_back("--progress and --no-progress are both given; allowed: one of them");
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

// The end time and the time between rows, s.
struct Times {
  double duration, until, every;
};

// What is wrong with the times; empty if nothing.
std::string times_problem(const Times& t) {
  constexpr double kLongest = 1e7, kMaxRows = 1e7;  // s; rows
  if (t.until > kLongest)
    return "--until is " + description::decimal_text(t.until) + " s; allowed: at most 1e7 s";
  if (t.until / t.every > kMaxRows)
    return "--every is " + description::decimal_text(t.every) + " s; allowed: at least " +
           description::decimal_text(t.until / kMaxRows) + " s, a ten-millionth of the time to the end";
  return "";
}

// Opens the files of a run and writes the header of the table.
int files_open(const Options& options, Recorder& r, const std::vector<description::Variable>& table) {
  std::string problem;
  if (!csv_open(r.csv, options.folder, problem)) return fail(kBadInput, problem);
  if (options.report)  // before the run, not only after it
    if (problem = place_problem(*options.report); !problem.empty())
      return fail(kBadInput, "--report: " + problem);
  std::vector<std::string> header{"time"};
  for (const description::Variable& v : table) {
    if (v.causality != description::Causality::kOutput) continue;
    header.push_back(v.name());
    r.columns.push_back(v.value);
  }
  csv_header(r.csv, header);
  return kDone;
}

// Runs, ends the files and checks what has been reached.
int run_and_end(const Options& options, Recorder& r, const Driven& driven, const Times& times) {
  Progress progress;
  if (options.progress || (!options.no_progress && isatty(STDERR_FILENO)))
    progress_begin(progress, r.cloth, times.until);
  int code = run_rows(r, driven, times.until, times.every);
  progress_end(progress);
  std::string problem;
  if (!csv_close(r.csv, problem)) return fail(kFailedRun, problem);
  if (code == kDone) code = ends_check(r.cloth, times.until >= times.duration * (1 - 1e-9));
  problem = instance::energy_problem(r.balance, r.cloth);
  if (!problem.empty()) code = fail(kFailedRun, problem);
  if (options.report) {
    const double limit = options.limit ? *options.limit / 100 : -1;
    problem = report_write(*options.report, report_of(r.cloth, limit));
    stage_end(r.stages, &Stages::report);
    if (!problem.empty()) code = fail(kFailedRun, problem);
  }
  return r.frames_written ? code : fail(kFailedRun, r.frames.failure);
}

int run(const Options& options) {
  const std::vector<std::string> problems = options_problems(options);
  for (const std::string& sentence : problems) fail(kBadInput, sentence);
  if (!problems.empty()) return kBadInput;
  Stages stages;
  const Cloth cloth = cloth_open(options.scene_file, options.verbose);
  if (!cloth) return kBadInput;
  const std::vector<description::Variable> table = description::variables_of(cloth.get(), options.nodes);
  Driven driven{cloth.get(), table, {}};
  if (const int code = apply_settings(options, cloth.get(), table, driven.inputs); code != kDone) return code;
  const double duration = drape_duration(cloth.get());
  const Times times{duration, options.until > 0 ? options.until : duration,
                    options.every > 0 ? options.every : duration / 100};
  if (const std::string problem = times_problem(times); !problem.empty()) return fail(kBadInput, problem);
  for (const std::string& remark :
       input_table_remarks(driven.inputs, table, drape_communication(cloth.get())))
    message_print("warning", remark);
  const bool nodes = options.nodes != description::Nodes::kNone;
  Recorder r{cloth.get(), {}, nodes, {}, options.frames, {}, stages, {}};
  r.frames.folder = options.folder;
  if (const int code = files_open(options, r, table); code != kDone) return code;
  if (std::signal(SIGINT, interrupt) == SIG_IGN) std::signal(SIGINT, SIG_IGN);  // as in a shell's background
  stage_end(stages, &Stages::reading);
  const int code = run_and_end(options, r, driven, times);
  print_summary(cloth.get(), stages);
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
  flag_add(*command, "--progress", options->progress,
           "show a line of progress on standard error, even where it is no terminal");
  flag_add(*command, "--no-progress", options->no_progress, "show none");
  flag_add(*command, "-v,--verbose", options->verbose, "print events and changes of the step");
  command_on_run(*command, [options, &exit_code] { exit_code = run(*options); });
}

}  // namespace drape::command
