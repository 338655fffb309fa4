// `drape import`: a sewing pattern as a scene.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

#include "command/command.h"
#include "command/garmentcode/garment.h"
#include "command/garmentcode/wool.h"
#include "scene/diagnostics.h"
#include "validation/load.h"

namespace drape::command {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string pattern, body, fabric, output;
  double cell = 0.01;  // m
  bool has_body = false, has_fabric = false;
};

std::string content(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

// The path of a file as a scene in `folder` names it.
std::string seen_from(const fs::path& file, const fs::path& folder) {
  std::error_code error;
  const fs::path from = fs::absolute(folder.empty() ? fs::path(".") : folder), to = fs::absolute(file);
  const fs::path way = fs::relative(to, from, error);
  return error || way.empty() ? to.string() : way.string();
}

void options_check(const Options& o, std::vector<Problem>& problems) {
  if (!(o.cell > 0 && o.cell <= 10))
    problems.push_back({"--cell", "= " + scene::number_text(o.cell) + " m; allowed: above 0, at most 10 m"});
  if (o.output.empty()) problems.push_back({"--output", "is empty; allowed: the name of a file"});
  for (const std::string& read : {o.pattern, o.body, o.fabric}) {
    std::error_code error;
    if (!read.empty() && fs::equivalent(o.output, read, error))
      problems.push_back({"--output", "is " + o.output + ", which is read from; allowed: any other file"});
  }
}

// The garment's fabric: the given file, or else the wool beside the scene.
scene::FabricSpec fabric_choose(const Options& o, const fs::path& folder, Garment& garment,
                                std::vector<Problem>& problems) {
  const fs::path file = o.has_fabric ? fs::path(o.fabric) : folder / "wool.toml";
  garment.fabric = name_made(file.stem().string(), "fabric");
  garment.fabric_file = o.has_fabric ? seen_from(file, folder) : file.filename().string();
  return o.has_fabric || fs::exists(file) ? validation::fabric_load(file, problems) : scene::FabricSpec{};
}

int reported(const std::vector<Problem>& problems) {
  for (const Problem& p : problems) fail(kBadInput, scene::problem_text(p));
  return kBadInput;
}

int import_pattern(const Options& o) {
  std::vector<Problem> problems;
  options_check(o, problems);
  const fs::path folder = fs::path(o.output).parent_path();
  Garment garment;
  garment.name = name_made(fs::path(o.output).stem().string(), "garment");
  garment.title = fs::path(o.pattern).filename().string();
  garment.cell = o.cell;
  const Pattern pattern = pattern_read(o.pattern, problems);
  if (o.has_body) garment.body = body_measure(o.body, problems);
  const scene::FabricSpec fabric = fabric_choose(o, folder, garment, problems);
  if (!problems.empty()) return reported(problems);
  if (garment.body) garment.body->file = seen_from(o.body, folder);
  const Scene scene = garment_scene(pattern, garment, fabric);
  validation::scene_check(scene, problems);
  for (Problem& p : problems) p.place = o.pattern + ": " + p.place;
  if (!problems.empty()) return reported(problems);

  std::error_code error;
  if (!folder.empty()) fs::create_directories(folder, error);
  const fs::path wool = folder / "wool.toml";
  const bool there = fs::exists(wool);
  int code = kDone;
  if (!o.has_fabric && !there) code = file_put(wool.string(), kWool);
  if (code == kDone) code = file_put(o.output, garment_text(scene, pattern, garment));
  if (code != kDone) return code;
  std::printf("%s: %zu pieces, %zu seams, cells of %g mm\n", o.output.c_str(), scene.pieces.size(),
              scene.seams.size(), 1e3 * o.cell);
  if (garment.body)
    std::printf("body %s, %.3f m high, scale %g\n", garment.body->file.c_str(), garment.body->height,
                garment.body->scale);
  if (!o.has_fabric)
    std::printf("fabric %s%s\n", wool.c_str(), there && content(wool) != kWool ? ", as it was there" : "");
  return kDone;
}

}  // namespace

void command_import(CLI::App& app, int& exit_code) {
  CLI::App* command = command_add(app, "import", "make a scene of a sewing pattern (GarmentCode JSON)");
  auto options = std::make_shared<Options>();
  option_add(*command, "PATTERN", options->pattern, "pattern (JSON)", {.required = true});
  CLI::Option* body = option_add(*command, "--body", options->body,
                                 "who wears it; without, it is sewn weightless", {.type = "BODY.obj"});
  option_add(*command, "-o,--output", options->output, "the scene", {.type = "SCENE", .required = true});
  option_add(*command, "--cell", options->cell, "cells of the pieces, m",
             {.type = "METRES", .default_shown = true});
  CLI::Option* fabric =
      option_add(*command, "--fabric", options->fabric,
                 "fabric file; without, a measured wool is put beside the scene", {.type = "FILE"});
  command_on_run(*command, [=, &exit_code] {
    options->has_body = option_given(*body);
    options->has_fabric = option_given(*fabric);
    exit_code = import_pattern(*options);
  });
}

}  // namespace drape::command
