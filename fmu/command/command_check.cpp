#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <optional>

#include "command/command.h"
#include "figures/picture.h"
#include "laboratory/calibrate.h"
#include "scene/reader/read.h"
#include "validation/load.h"

namespace drape::command {
namespace {

constexpr model::YarnDirection kDirections[] = {model::YarnDirection::kWarp, model::YarnDirection::kWeft,
                                                model::YarnDirection::kBias};

struct Options {
  std::string scene_file;
  std::optional<std::string> picture;
};

// The counts above 0 as " (A, B)"; empty if there are none.
std::string counted(std::initializer_list<std::pair<int, const char*>> list) {
  std::string text;
  for (const auto& [count, what] : list)
    if (count > 0) text += (text.empty() ? " (" : ", ") + std::to_string(count) + " " + what;
  return text.empty() ? "" : text + ")";
}

void print_pieces(drape_cloth* cloth) {
  const int count = drape_piece_count(cloth);
  double area = 0, mass = 0;
  int particles = 0;
  for (int p = 0; p < count; ++p) {
    const drape_piece piece = drape_piece_at(cloth, p);
    const double density = drape_parameters_of(cloth)->fabric[piece.fabric].areal_density;
    std::printf(
        "piece %s: %d particles%s, %d cells of %.6g mm%s, %.6g m2, %.6g kg\n", piece.name, piece.node_count,
        counted({{piece.twin_count, piece.twin_count == 1 ? "twin" : "twins"}}).c_str(), piece.cell_count,
        1e3 * piece.cell, counted({{piece.cut_count, "cut"}, {piece.merged_count, "merged"}}).c_str(),
        piece.area, density * piece.area);
    particles += piece.node_count;
    area += piece.area;
    mass += density * piece.area;
  }
  if (count > 1) std::printf("%d pieces: %d particles, %.6g m2, %.6g kg\n", count, particles, area, mass);
}

void print_seams(const drape_outputs& o) {
  for (int k = 0; k < o.seam_count; ++k) {
    const drape_seam& s = o.seam[k];
    const double shorter = std::min(s.side[0], s.side[1]), longer = std::max(s.side[0], s.side[1]);
    std::printf("seam %s: %d pairs of particles, %.6g m to %.6g m", s.name, s.pair_count, s.side[0],
                s.side[1]);
    if (longer > shorter * (1 + 1e-6)) std::printf(", ease %.4g", longer / shorter);
    std::printf("\n");
  }
}

// The excess to expect of diagrams that no calibration has corrected. If the diagonals are scaled by area,
// the excess depends on the cell, and nothing is printed.
void print_excess(const Scene& scene) {
  if (scene.scaling != scene::Scaling::kWidth) return;
  const fabric::LawOptions options{scene.scaling, scene.bias_model, scene.clamp_correction};
  for (const scene::FabricSpec& f : scene.fabrics)
    for (model::YarnDirection along : kDirections) {
      if (!laboratory::strip_diagram(f, along).correction.empty()) continue;
      const laboratory::StripExcess e = laboratory::strip_excess(f, along, options);
      if (!e.why.empty())
        std::printf("fabric %s: %s is not calibrated; %s\n", f.name.c_str(),
                    laboratory::yarn_direction_name(along), e.why.c_str());
      if (std::abs(e.excess) < 1e-3) continue;
      std::printf(
          "fabric %s: %s is not calibrated; a simulated strip pulls up to %.3g %% too %s (at %.4g %%)\n",
          f.name.c_str(), laboratory::yarn_direction_name(along), 100 * std::abs(e.excess),
          e.excess > 0 ? "hard" : "little", 100 * e.elongation);
    }
}

// Warns where a formula takes the jaws out of a diagram but does not hold for its strip.
void print_jaws(const Scene& scene) {
  const fabric::LawOptions options{scene.scaling, scene.bias_model, scene.clamp_correction};
  for (const scene::FabricSpec& f : scene.fabrics)
    if (const double r = f.strip_gauge / f.strip_width; !f.bias.elongation.empty() &&
                                                        fabric::law_corrects_for_jaws(f, options) &&
                                                        r < fabric::kMinJawRatio * (1 - 1e-9))
      std::printf(
          "fabric %s: strip has gauge/width = %.4g; the clamp correction of bias holds from %.4g on: "
          "calibrate it\n",
          f.name.c_str(), r, fabric::kMinJawRatio);
}

// Warns of elongations so small that they may be fractions.
void print_fractions(const Scene& scene) {
  for (const scene::FabricSpec& f : scene.fabrics)
    for (model::YarnDirection along : kDirections) {
      const scene::DiagramSpec& d = laboratory::strip_diagram(f, along);
      if (d.elongation.empty() || d.force.empty()) continue;
      const std::string doubt =
          fraction_doubt(f.name, laboratory::yarn_direction_name(along), d.elongation.back(), d.force.back());
      if (!doubt.empty()) std::fprintf(stderr, "warning: %s\n", doubt.c_str());
    }
}

// How far the slope of each law travels, over its range. Warns where it is so far that noise must be the
// reason.
void print_slope_paths(const Scene& scene) {
  const fabric::LawOptions options{scene.scaling, scene.bias_model, scene.clamp_correction};
  for (const scene::FabricSpec& f : scene.fabrics) {
    std::string list, warnings;
    for (model::YarnDirection along : kDirections) {
      const double path = laboratory::strip_slope_path(f, along, options);
      if (path == 0) continue;
      const std::string name = laboratory::yarn_direction_name(along);
      char text[32];
      std::snprintf(text, sizeof text, "%.3g", path);
      list += (list.empty() ? "" : ", ") + name + " " + text;
      if (path > laboratory::kMaxSlopePath)
        warnings +=
            "warning: fabric " + f.name + ": the slope of " + name + " travels " + text +
            " times its range, where a smooth diagram has 1 to 1.5; `drape fabric smooth` takes out the "
            "noise of a load cell\n";
    }
    if (!list.empty()) std::printf("fabric %s: slope path of %s\n", f.name.c_str(), list.c_str());
    std::fputs(warnings.c_str(), stderr);
  }
}

int write_picture(const Options& options, const std::string& picture) {
  std::vector<Problem> problems;  // stays empty: the cloth has just been opened from the same file
  return file_put(picture, figures::picture_svg(validation::scene_load(options.scene_file, problems)));
}

// Takes the first steps and restores the initial state: those of a quarter of a second, or of one simulated
// second. Prints what they cost, in the seconds of all processors together, which other programs do not
// lengthen. A fit ends where it is at rest: nothing foretells its cost.
bool print_cost(drape_cloth* cloth) {
  drape_snapshot* start = drape_save(cloth, nullptr);
  const std::clock_t began = std::clock();
  // An interval may have a million steps: start with one step and double until the interval is full.
  const double interval = drape_communication(cloth);
  double length = std::min(drape_get_outputs(cloth, DRAPE_OUT_SCALARS)->step_size, interval), simulated = 0,
         spent = 0;
  drape_status status = DRAPE_OK;
  while (status == DRAPE_OK && spent < 0.25 && simulated < 1) {
    status = drape_advance(cloth, length);
    simulated += length;
    length = std::min(2 * length, interval);
    spent = double(std::clock() - began) / CLOCKS_PER_SEC;
  }
  const drape_outputs& o = *drape_get_outputs(cloth, DRAPE_OUT_SCALARS);
  if (status == DRAPE_OK && !o.has_fit) {
    std::printf(
        "cost: %.3g CPU s per simulated second, %.0f steps of %d particles (measured over the first %.3g "
        "s)\n",
        spent / simulated, o.step_count / simulated, o.node_count, simulated);
  }
  drape_restore(cloth, start);
  drape_snapshot_free(start);
  return status == DRAPE_OK;
}

int check(const Options& options) {
  if (options.picture)
    if (const std::string problem =
            output_problem("--picture", *options.picture, scene::scene_files(options.scene_file));
        !problem.empty())
      return fail(kBadInput, problem);
  const Cloth cloth = cloth_open(options.scene_file);
  if (!cloth) return kBadInput;
  if (options.picture)
    if (const int code = write_picture(options, *options.picture); code != kDone) return code;
  std::printf("scene %s: %.6g s, communication interval %.6g s\n", drape_scene_name(cloth.get()),
              drape_duration(cloth.get()), drape_communication(cloth.get()));
  print_pieces(cloth.get());
  print_seams(*drape_get_outputs(cloth.get(), DRAPE_OUT_SCALARS));
  const char* set_by = nullptr;
  const double limit = drape_step_limit(cloth.get(), &set_by);
  std::printf("step limit: %.6g us, set by %s\n", 1e6 * limit, set_by ? set_by : "nothing");
  std::printf("step: %.6g us\n", 1e6 * drape_get_outputs(cloth.get(), DRAPE_OUT_SCALARS)->step_size);
  std::vector<Problem> problems;  // stays empty: the cloth has just been opened from the same file
  const Scene scene = validation::scene_load(options.scene_file, problems);
  print_jaws(scene);
  print_fractions(scene);
  print_slope_paths(scene);
  print_excess(scene);
  return print_cost(cloth.get()) ? kDone : kFailedRun;
}

}  // namespace

void command_check(CLI::App& app, int& exit_code) {
  CLI::App* command =
      command_add(app, "check", "read and validate a scene; print its size, step limit and cost");
  auto options = std::make_shared<Options>();
  option_scene(*command, options->scene_file);
  option_add(*command, "--picture", options->picture, "draw the pieces on their grids", {.type = "FILE.svg"});
  command_on_run(*command, [options, &exit_code] { exit_code = check(*options); });
}

}  // namespace drape::command
