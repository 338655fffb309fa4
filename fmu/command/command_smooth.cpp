// `drape fabric smooth`: a diagram from the samples of a tensile tester.
#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <optional>

#include "command/calibration.h"
#include "command/command.h"
#include "command/files/whole_file.h"
#include "laboratory/smooth.h"
#include "laboratory/write_smoothed.h"
#include "scene/limits.h"
#include "validation/checks.h"
#include "validation/load.h"

namespace drape::command {
namespace {

using laboratory::SmoothedDiagram;

constexpr const char* kNames[] = {"warp", "weft", "bias"};

struct Options {
  std::string fabric_file, output;
  double resolution = 0;  // N; 0: estimated
};

std::string text_of(double value, const char* format = "%.4g") {
  char text[48];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

// A file and what becomes of it.
struct Smoothing {
  scene::FabricFile file;
  std::string text;
  scene::DiagramSpec samples[3];  // of warp, weft and bias; empty: none in the text of the file
  SmoothedDiagram smoothed[3];
};

scene::DiagramSpec& diagram_of(scene::FabricSpec& f, int k) {
  return k == 0 ? f.warp : k == 1 ? f.weft : f.bias;
}

bool has_diagram(const Smoothing& s, int k) { return !s.samples[k].elongation.empty(); }

// The samples of a direction: those kept as `raw`, else the diagram itself. What a data sheet gives is no
// record of a tester.
void samples_take(Smoothing& s) {
  const std::array<bool, 3> in_text = laboratory::diagrams_in_text(s.text);
  for (int k = 0; k < 3; ++k) {
    if (!in_text[std::size_t(k)]) continue;
    const scene::DiagramSpec& stated = diagram_of(s.file.fabric, k);
    const scene::DiagramSpec& raw = s.file.raw[k];
    s.samples[k] = stated;
    if (raw.elongation.empty()) continue;
    s.samples[k].elongation = raw.elongation;
    s.samples[k].force = raw.force;
  }
}

double greatest_force(const scene::DiagramSpec& d) {
  return d.force.empty() ? 0 : *std::max_element(d.force.begin(), d.force.end());
}

std::string resolution_problem(const Options& options, double greatest, const std::string& of) {
  if (options.resolution <= greatest) return "";
  return "--resolution = " + text_of(options.resolution, "%.6g") + " N; allowed: up to " +
         text_of(greatest, "%.6g") + " N, the greatest force of " + of;
}

// Smooths all diagrams. Appends what is wrong with them.
void smooth_all(const Options& options, Smoothing& s, std::vector<std::string>& problems) {
  double greatest = 0;
  std::size_t longest = 0;
  for (const scene::DiagramSpec& d : s.samples) {
    greatest = std::max(greatest, greatest_force(d));
    longest = std::max(longest, d.elongation.size());
  }
  const std::string path = options.fabric_file + ": ";
  if (longest == 0)
    return problems.push_back(path + "has no diagram of elongations and forces; wanted: warp, weft or bias");
  if (const std::string problem = resolution_problem(options, greatest, "the diagrams"); !problem.empty())
    return problems.push_back(problem);
  for (int k = 0; k < 3; ++k) {
    if (!has_diagram(s, k)) continue;
    SmoothedDiagram& d = s.smoothed[k];
    d = laboratory::diagram_smooth(s.samples[k], options.resolution);
    if (d.problem.empty() && longest < scene::kMinSamples)
      d.problem = "has " + std::to_string(s.samples[k].elongation.size()) + " points; wanted: at least " +
                  std::to_string(scene::kMinSamples);
    if (!d.problem.empty()) problems.push_back(path + kNames[k] + " " + d.problem);
    else if (d.rms > 0)
      if (const std::string problem = resolution_problem(options, greatest_force(s.samples[k]), kNames[k]);
          !problem.empty())
        problems.push_back(problem);
  }
}

void print_left_out(const SmoothedDiagram& d) {
  const laboratory::Record& r = d.record;
  const auto count = [](std::size_t n) { return std::to_string(n) + (n == 1 ? " sample" : " samples"); };
  if (r.below_zero > 0) std::printf("  %s below 0 %% left out\n", count(r.below_zero).c_str());
  if (r.after_break > 0)
    std::printf("  %s after the greatest force, at %.4g %%, left out: the break\n",
                count(r.after_break).c_str(), 100 * r.break_elongation);
  if (d.pretension > 0)
    std::printf("  a pretension of %.4g N at 0 %% subtracted from all forces\n", d.pretension);
  if (d.pretension < 0) std::printf("  a zero of %.4g N at 0 %% subtracted from all forces\n", d.pretension);
  if (d.slack > 0)
    std::printf(
        "  a slack of %.4g %% without force left out: elongation counts from where the strip is taut, as in "
        "ISO 13934-1\n",
        100 * d.slack);
}

void print_diagram(const Smoothing& s, int k, const std::string& resolution_from) {
  const SmoothedDiagram& d = s.smoothed[k];
  const std::size_t in = s.samples[k].elongation.size(), out = d.diagram.elongation.size();
  if (d.is_smooth)
    return void(std::printf("%s: %zu points with a slope path of %.3g: smooth as they are\n", kNames[k], in,
                            d.path_after));
  std::printf("%s: %zu samples, %zu points\n", kNames[k], in, out);
  print_left_out(d);
  if (d.rms > 0)
    std::printf("  resolution %.4g N (%s); residual %.4g N rms, %.4g N at most\n", d.resolution,
                resolution_from.c_str(), d.rms, d.largest);
  std::printf("  slope path %.3g before, %.3g after\n", d.path_before, d.path_after);
}

// Warns of what the samples or the resolution may hold that is not meant.
void print_doubts(const Smoothing& s, int k) {
  const SmoothedDiagram& d = s.smoothed[k];
  const std::string fabric = s.file.fabric.name, place = "fabric " + fabric + ": " + kNames[k];
  const std::string fraction =
      fraction_doubt(fabric, kNames[k], d.diagram.elongation.back(), d.diagram.force.back());
  if (!fraction.empty()) std::fprintf(stderr, "warning: %s\n", fraction.c_str());
  if (!d.is_near)
    std::fprintf(stderr,
                 "warning: %s stays %.4g N (rms) from its samples, above the resolution of %.4g N; no rising "
                 "curve of this kind is nearer\n",
                 place.c_str(), d.rms, d.resolution);
  else if (d.path_after > laboratory::kMaxSlopePath)
    std::fprintf(stderr,
                 "warning: %s still has a slope path of %.3g; a --resolution above %.4g N smooths it more\n",
                 place.c_str(), d.path_after, d.resolution);
}

// Whether a diagram of the file changes. One that was smoothed before has its samples beside it, and is
// compared with what it was.
bool changes(const Smoothing& s, int k) {
  if (!has_diagram(s, k)) return false;
  const SmoothedDiagram& d = s.smoothed[k];
  if (s.file.raw[k].elongation.empty()) return !d.is_smooth;
  scene::FabricSpec f = s.file.fabric;
  const scene::DiagramSpec& stated = diagram_of(f, k);
  return stated.elongation != d.diagram.elongation || stated.force != d.diagram.force;
}

int smooth(const Options& options) {
  std::vector<std::string> complaints;
  if (const std::string problem = output_problem("--output", options.output, {options.fabric_file});
      !problem.empty())
    return fail(kBadInput, problem);
  if (const std::string problem = place_problem(options.output); !problem.empty())
    return fail(kBadInput, problem);
  std::vector<Problem> problems;
  Smoothing s;
  s.file = validation::samples_load(options.fabric_file, problems);
  if (!problems_report(problems)) return kBadInput;
  std::ifstream in(options.fabric_file, std::ios::binary);
  s.text = {std::istreambuf_iterator<char>(in), {}};
  samples_take(s);
  smooth_all(options, s, complaints);
  for (const std::string& complaint : complaints) fail(kBadInput, complaint);
  if (!complaints.empty()) return kBadInput;

  scene::FabricSpec f = s.file.fabric;
  std::optional<scene::DiagramSpec> changed[3];
  for (int k = 0; k < 3; ++k) {
    if (!has_diagram(s, k)) {
      if (!diagram_of(f, k).elongation.empty())
        std::printf("%s: from a data sheet, stays as it is\n", kNames[k]);
      continue;
    }
    print_diagram(s, k, options.resolution > 0 ? "given" : "estimated from the scatter of the samples");
    print_doubts(s, k);
    if (changes(s, k)) changed[k] = diagram_of(f, k) = s.smoothed[k].diagram;
  }
  validation::fabric_check({}, f, problems);
  if (!problems_report(problems)) return kBadInput;

  std::string text = s.text;
  const bool any = std::any_of(std::begin(changed), std::end(changed), [](const auto& d) { return bool(d); });
  if (any) text = laboratory::write_smoothed(text, f.name, changed, problems);
  if (!problems_report(problems)) return kBadInput;
  laboratory::Calibration calibration;
  if (any && s.file.calibration_cell > 0)
    if (const int code = fabric_calibrate(f, s.file.calibration_cell, text, calibration); code != kDone)
      return code;
  if (const int code = file_put(options.output, text); code != kDone) return code;
  std::printf("%s: %s\n", options.output.c_str(),
              !any                          ? "as it was"
              : s.file.calibration_cell > 0 ? "smoothed and calibrated anew"
                                            : "smoothed; not calibrated, as it was not before");
  return kDone;
}

}  // namespace

void command_smooth(CLI::App& fabric, int& exit_code) {
  CLI::App* command =
      command_add(fabric, "smooth", "make smooth diagrams of a tester's samples; keep these beside them");
  auto options = std::make_shared<Options>();
  option_add(*command, "RAW", options->fabric_file,
             "fabric file (TOML) whose diagrams hold the samples of a tensile tester", {.required = true});
  option_add(*command, "-o,--output", options->output, "file to write", {.type = "FABRIC", .required = true});
  const auto problem = [](const std::string& text) {
    return is_positive_number(text) ? "" : "'" + text + "' N; allowed: above 0 N";
  };
  option_add(*command, "--resolution", options->resolution,
             "noise of the load cell, on the strip; default: the scatter of the samples",
             {.type = "NEWTONS", .problem = problem});
  command_on_run(*command, [options, &exit_code] { exit_code = smooth(*options); });
}

}  // namespace drape::command
