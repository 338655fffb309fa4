// `drape fabric test` and `drape fabric calibrate`: the virtual laboratory. `drape fabric smooth` is in
// command_smooth.cpp.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <optional>

#include "command/calibration.h"
#include "command/command.h"
#include "figures/fabric_plot.h"
#include "laboratory/bending.h"
#include "laboratory/strip_order.h"
#include "standards/strip.h"
#include "validation/load.h"

namespace drape::command {
namespace {

constexpr double kMicroNcm2 = 1e10;       // uN cm^2 per N m^2
constexpr double kBendingCell = 1.25e-3;  // m, of the PT-2 specimen
constexpr int kOverhangCells = 40;
constexpr int kMaxCells = 200;  // across a strip
constexpr model::YarnDirection kThreads[] = {model::YarnDirection::kWarp, model::YarnDirection::kWeft,
                                             model::YarnDirection::kBias};

struct Options {
  std::string fabric_file, output;
  std::optional<std::string> picture;
  std::vector<std::string> along{"warp", "weft", "bias"};
  double cell = 0;   // m; 0: the strip's width over kStripCells
  double pull = -1;  // percent of elongation; below 0: to the end of each diagram
  bool has_output = false;
};

bool is_along(const Options& options, model::YarnDirection along) {
  const auto& list = options.along;
  return std::find(list.begin(), list.end(), laboratory::yarn_direction_name(along)) != list.end();
}

double cell_of(const Options& options, const scene::FabricSpec& f) {
  return options.cell > 0 ? options.cell : f.strip_width / laboratory::kStripCells;
}

bool there(const scene::DiagramSpec& d) {
  return std::any_of(d.force.begin(), d.force.end(), [](double f) { return f > 0; });
}

// The standards whose strips have this size, as " (A, B)"; empty if there are none.
std::string standards_of(const scene::FabricSpec& f) {
  std::string list;
  for (const standards::StripStandard& s : standards::kStripStandards)
    if (std::abs(s.width / f.strip_width - 1) < 1e-9 && std::abs(s.gauge / f.strip_gauge - 1) < 1e-9)
      list += (list.empty() ? " (" : ", ") + std::string(s.name);
  return list.empty() ? "" : list + ")";
}

std::string text_of(double value, const char* format = "%.6g") {
  char text[48];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

// Prints on standard error all that is wrong with the requested tests.
bool wishes_check(const Options& options, const scene::FabricSpec& f) {
  std::vector<std::string> problems;
  const double cell = cell_of(options, f),
               smallest = std::min(f.strip_width, f.strip_gauge) / laboratory::kMinCells;
  if (cell > smallest * (1 + 1e-9) || cell < f.strip_width / kMaxCells)
    problems.push_back((options.cell > 0 ? "--cell" : "strip: the cell") + (" = " + text_of(cell)) +
                       " m; allowed: from " + text_of(f.strip_width / kMaxCells) + " to " +
                       text_of(smallest) + " m, four cells across and along a strip of " +
                       text_of(f.strip_width) + " x " + text_of(f.strip_gauge) + " m");
  if (problems.empty() && f.strip_gauge > laboratory::kMaxCells * cell)
    problems.push_back("strip: " + text_of(f.strip_gauge / cell) + " cells along its gauge of " +
                       text_of(f.strip_gauge) + " m; allowed: at most " + text_of(laboratory::kMaxCells));
  bool any = false;
  for (model::YarnDirection along : kThreads) {
    const scene::DiagramSpec& d = laboratory::strip_diagram(f, along);
    if (!there(d)) continue;
    any = true;
    if (is_along(options, along) && options.pull >= 0 && options.pull < 100 * d.elongation[1] * (1 - 1e-12))
      problems.push_back("--pull = " + text_of(options.pull) + " percent; allowed: at least " +
                         text_of(100 * d.elongation[1]) + " percent, the first point of the diagram of the " +
                         laboratory::yarn_direction_name(along));
    if (is_along(options, along) && options.pull > 100 * d.elongation.back() * (1 + 1e-12))
      problems.push_back("--pull = " + text_of(options.pull) + " percent; allowed: at most " +
                         text_of(100 * d.elongation.back()) + " percent, where the diagram of the " +
                         laboratory::yarn_direction_name(along) + " ends");
  }
  if (!any) problems.push_back(options.fabric_file + ": has no diagram; wanted: warp, weft or bias");
  for (const std::string& problem : problems) fail(kBadInput, problem);
  return problems.empty();
}

// Repeats a bias strip on other cells. Prints the largest difference and the order of convergence.
void cells_report(const scene::FabricSpec& f, double cell, const std::vector<double>& elongation) {
  std::vector<Problem> problems;
  const laboratory::StripOrder o = laboratory::strip_order(f, cell, elongation, problems);
  if (!o.has_order) return;
  if (!o.why.empty()) return void(std::printf("  on cells of twice and half the edge %s\n", o.why.c_str()));
  std::printf("  on cells of %.6g mm at most %.3f %% off, of %.6g mm %.3f %%; order %.2f\n", 1e3 * o.cell[0],
              100 * o.off[0], 1e3 * o.cell[2], 100 * o.off[2], o.order);
}

int strip_test(const Options& options, const scene::FabricSpec& f, model::YarnDirection along,
               std::vector<figures::PlotPanel>& panels) {
  const scene::DiagramSpec& d = laboratory::strip_diagram(f, along);
  const char* name =
      along == model::YarnDirection::kBias ? "45 degrees" : laboratory::yarn_direction_name(along);
  if (!there(d)) return std::printf("%s: no diagram\n\n", name), kDone;
  const double cell = cell_of(options, f), pull = options.pull < 0 ? d.elongation.back() : options.pull / 100;
  const std::vector<double> elongation = laboratory::strip_elongations(f, along, pull);
  std::vector<Problem> problems;
  const laboratory::StripPull strip = laboratory::strip_pull(f, along, cell, elongation, problems);
  if (!problems_report(problems)) return kBadInput;
  const bool free = along == model::YarnDirection::kBias && !f.bias.jaws;
  std::printf("%s, %s, cells of %.6g mm, %s, slope path %.3g\n", name,
              free ? "a trellis without jaws" : "between jaws", 1e3 * laboratory::strip_cell(f, along, cell),
              d.correction.empty() ? "not calibrated" : "calibrated",
              laboratory::strip_slope_path(f, along, {}));
  std::printf("  elongation, %%      input, N  simulated, N  difference, %%\n");
  figures::PlotPanel panel{name, {}, {}, strip.force};
  for (std::size_t k = 0; k < strip.force.size(); ++k) {
    const double input = d.force[k + 1], off = 100 * (strip.force[k] / input - 1);
    std::printf("  %13.5g %13.5g %13.5g %14s\n", 100 * elongation[k], input, strip.force[k],
                input > 0 ? text_of(off, "%+.4f").c_str() : "-");
    panel.elongation.push_back(elongation[k]);
    panel.input.push_back(input);
  }
  if (strip.force.size() == elongation.size() && along == model::YarnDirection::kBias && !free)
    cells_report(f, cell, elongation);
  std::printf("\n");
  panels.push_back(panel);
  if (strip.force.size() < elongation.size())
    return fail(kFailedRun, std::string("the strip of the ") + laboratory::yarn_direction_name(along) +
                                " finds no rest at " + text_of(100 * elongation[strip.force.size()]) +
                                " percent");
  return kDone;
}

int bending_test(const scene::FabricSpec& f, bool warp) {
  const double rigidity = warp ? f.bending_warp : f.bending_weft;
  const char* name = warp ? "warp" : "weft";
  if (!(rigidity > 0)) return std::printf("  %s: no rigidity\n", name), kDone;
  const double plate = 1 / (1 - f.poisson * f.poisson), si = f.bending_width * kMicroNcm2;
  std::vector<Problem> problems;
  const laboratory::BendingTest drop = laboratory::pt2_test(f, warp, kBendingCell, problems),
                                length = laboratory::overhang_test(f, warp, kOverhangCells, problems);
  if (!problems_report(problems)) return kBadInput;
  const auto row = [&](const char* test, const char* what, const laboratory::BendingTest& t) {
    if (!t.found) return fail(kFailedRun, std::string(test) + " of the " + name + " finds no rest");
    std::printf("  %-5s %-24s %9.6g %9.4f %9.4f %12.6g %+10.3f\n", name, what, rigidity * plate * si,
                1e3 * t.expected, 1e3 * t.reading, t.rigidity * si,
                100 * (t.rigidity / (rigidity * plate) - 1));
    return int(kDone);
  };
  const int code = row("PT-2", "PT-2, drop f", drop);
  return std::max(code, row("the bending length", "41.5 degrees, overhang", length));
}

// Why a file may not be written; empty if it may.
std::string target_problem(const std::string& option, const std::string& file, const std::string& fabric,
                           const char* advice) {
  if (file.empty()) return option + " is empty; allowed: the name of a file";
  std::error_code error;
  if (std::filesystem::equivalent(file, fabric, error))
    return option + " is " + file + ", which the fabric is read from; allowed: any other file" + advice;
  return "";
}

int test(const Options& options) {
  std::vector<Problem> problems;
  const scene::FabricSpec f = validation::fabric_load(options.fabric_file, problems);
  if (!problems_report(problems)) return kBadInput;
  if (!wishes_check(options, f)) return kBadInput;
  if (options.picture)
    if (const std::string problem = target_problem("--picture", *options.picture, options.fabric_file, "");
        !problem.empty())
      return fail(kBadInput, problem);
  std::printf("fabric %s, strips of %.6g x %.6g mm%s\n\n", f.name.c_str(), 1e3 * f.strip_width,
              1e3 * f.strip_gauge, standards_of(f).c_str());
  int code = kDone;
  std::vector<figures::PlotPanel> panels;
  for (model::YarnDirection along : kThreads) {
    if (!is_along(options, along)) continue;
    const int done = strip_test(options, f, along, panels);
    if (done == kBadInput) return done;
    code = std::max(code, done);
  }
  if (f.bending_warp > 0 || f.bending_weft > 0) {
    std::printf("bending (GOST 10550, cells of %.6g mm; ASTM D1388, %d cells), EI on %.6g mm\n",
                1e3 * kBendingCell, kOverhangCells, 1e3 * f.bending_width);
    std::printf("                                   EI input  elastica simulated simulated EI difference\n");
    std::printf("                                     uN cm2        mm        mm       uN cm2          %%\n");
    for (bool warp : {true, false})
      if (is_along(options, warp ? model::YarnDirection::kWarp : model::YarnDirection::kWeft))
        code = std::max(code, bending_test(f, warp));
  }
  if (options.picture)
    if (const int failed = file_put(*options.picture, figures::fabric_plot_svg(f.name, panels));
        failed != kDone)
      return failed;
  return code;
}

int calibrate_fabric(const Options& options) {
  if (options.has_output)
    if (const std::string problem =
            target_problem("--output", options.output, options.fabric_file, ", or no --output to rewrite it");
        !problem.empty())
      return fail(kBadInput, problem);
  std::vector<Problem> problems;
  const scene::FabricSpec f =
      validation::fabric_load(options.fabric_file, problems, scene::Corrections::kDropped);
  if (!problems_report(problems) || !wishes_check(options, f)) return kBadInput;
  std::ifstream in(options.fabric_file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  laboratory::Calibration c;
  if (const int code = fabric_calibrate(f, options.cell, text, c); code != kDone) return code;
  const std::string file = options.has_output ? options.output : options.fabric_file;
  if (const int code = file_put(file, text); code != kDone) return code;
  std::printf("%s: corrections for cells of %.6g mm, within %.4f %%\n", file.c_str(), 1e3 * c.cell,
              100 * c.residuals.back());
  return kDone;
}

void options_add(CLI::App& command, Options& options) {
  option_add(command, "FABRIC", options.fabric_file, "fabric file (TOML)", {.required = true});
  const auto problem = [](const std::string& text) {
    return is_positive_number(text) ? "" : "'" + text + "' m; allowed: above 0 m";
  };
  option_add(command, "--cell", options.cell, "edge of the cells; default: a sixteenth of the strip's width",
             {.type = "METRES", .problem = problem});
}

}  // namespace

void command_fabric(CLI::App& app, int& exit_code) {
  CLI::App* fabric = command_add(app, "fabric", "the virtual laboratory: strips pulled and bent");
  command_require_one(*fabric);

  auto tested = std::make_shared<Options>();
  CLI::App* command =
      command_add(*fabric, "test", "pull and bend strips of a fabric; print input and simulated");
  options_add(*command, *tested);
  CLI::Option* pull =
      option_add(*command, "--pull", tested->pull, "elongation to pull to; default: the end of each diagram",
                 {.type = "PERCENT"});
  option_require_range(*pull, 0, 1e3);
  option_add(*command, "--along", tested->along, "strips to test; default: all",
             {.type = "warp|weft|bias ...", .choices = {"warp", "weft", "bias"}});
  option_add(*command, "--picture", tested->picture, "draw the diagrams", {.type = "FILE.svg"});
  command_on_run(*command, [tested, &exit_code] { exit_code = test(*tested); });

  auto calibrated = std::make_shared<Options>();
  command = command_add(*fabric, "calibrate",
                        "find the corrections with which strips return the diagrams; store them in the file");
  options_add(*command, *calibrated);
  CLI::Option* output = option_add(*command, "-o,--output", calibrated->output,
                                   "file to write; default: the fabric file itself", {.type = "FILE.toml"});
  command_on_run(*command, [calibrated, output, &exit_code] {
    calibrated->has_output = option_given(*output);
    exit_code = calibrate_fabric(*calibrated);
  });

  command_smooth(*fabric, exit_code);
}

}  // namespace drape::command
