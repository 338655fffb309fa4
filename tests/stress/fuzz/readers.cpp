// Each run reads a damaged file as the program does, and goes on with what it gave as far as the program
// would.
#include <cmath>
#include <fstream>
#include <memory>

#include "assembly/bodies.h"
#include "body/library.h"
#include "body/surface.h"
#include "cases.h"
#include "command/files/input_table.h"
#include "command/garmentcode/garment.h"
#include "command/garmentcode/pattern.h"
#include "drape/drape.h"
#include "scene/diagnostics.h"
#include "scene/reader/read.h"
#include "states.h"
#include "validation/load.h"
#include "variables.h"

namespace drape::fuzz {
namespace {

namespace fs = std::filesystem;

using ClothClose = void (*)(drape_cloth*);
using Cloth = std::unique_ptr<drape_cloth, ClothClose>;

void problems_take(const std::vector<Problem>& problems, Outcome& outcome) {
  for (const Problem& p : problems) outcome.sentences.push_back(scene::problem_text(p));
}

void log_take(void* user, drape_log_kind kind, const char* message) {
  if (kind == DRAPE_LOG_ERROR) static_cast<Outcome*>(user)->sentences.push_back(message);
}

Cloth cloth_open(const fs::path& file, Outcome& outcome) {
  return {drape_open(file.c_str(), log_take, &outcome), drape_close};
}

// The cells that the scene's pieces would have, by their bounding boxes.
double cells_of(const Scene& scene) {
  double cells = 0;
  for (const scene::PieceSpec& piece : scene.pieces) {
    Vec2 low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
    for (const Vec2& p : piece.outline)
      for (std::size_t k = 0; k < 2; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
    if (!piece.outline.empty()) cells += (high[0] - low[0]) * (high[1] - low[1]) / (piece.cell * piece.cell);
  }
  return cells;
}

// A valid scene is opened, and its text is opened again: it must be as valid.
void scene_open(const fs::path& file, Outcome& outcome) {
  const Cloth cloth = cloth_open(file, outcome);
  if (!cloth) {
    if (outcome.sentences.empty())
      outcome.faults.push_back("the cloth cannot be opened, and no sentence says why");
    return;
  }
  drape_get_outputs(cloth.get(), DRAPE_OUT_ALL);
  description::variables_of(cloth.get(), description::Nodes::kOutline);
  const fs::path again = file.parent_path() / "again.toml";
  std::ofstream(again, std::ios::binary) << drape_scene_text(cloth.get());
  for (int k = 0; k < drape_file_count(cloth.get()); ++k)
    fs::copy_file(drape_file_path(cloth.get(), k), again.parent_path() / drape_file_name(cloth.get(), k),
                  fs::copy_options::overwrite_existing);
  const Cloth same = cloth_open(again, outcome);
  if (!same) outcome.faults.push_back("its own text is no valid scene");
  else if (std::string(drape_scene_text(same.get())) != drape_scene_text(cloth.get()))
    outcome.faults.push_back("its own text, read again, gives another text");
}

// Grids of more cells would only take longer.
void scene_run(const fs::path& file, Outcome& outcome) {
  constexpr double kMaxGrid = 20000, kMaxOpened = 1500;  // cells
  std::vector<Problem> problems, inlined;
  scene::scene_files(file);
  scene::scene_inline_files(file, inlined);
  const scene::SceneText text = scene::scene_read(file);
  const double cells = cells_of(text.scene);
  if (cells < kMaxGrid) {
    validation::scene_load(file, problems);
  } else {
    scene::faults_report(text.faults, problems);
    if (text.loaded) validation::scene_check(text.scene, problems);
  }
  problems_take(problems, outcome);
  if (problems.empty() && cells < kMaxOpened) scene_open(file, outcome);
}

void fabric_run(const fs::path& file, Outcome& outcome) {
  for (const scene::Corrections corrections : {scene::Corrections::kKept, scene::Corrections::kDropped}) {
    std::vector<Problem> problems;
    validation::fabric_load(file, problems, corrections);
    problems_take(problems, outcome);
  }
}

void mesh_run(const fs::path& file, Outcome& outcome) {
  Scene scene;
  scene.bodies.emplace_back().name = "body";
  scene.bodies[0].mesh = file.string();
  std::vector<Problem> problems;
  const std::vector<model::Body> bodies = assembly::bodies_make(scene, problems);
  problems_take(problems, outcome);
  if (!problems.empty()) return;
  const model::BodyMesh& mesh = bodies[0].mesh;
  int triangle = -1, found[8];
  const double at[3] = {0.1, 0.2, 0.3};
  const double distance = mesh.library->distance(mesh.query.get(), at, &triangle);
  const std::size_t near = mesh.library->within(mesh.query.get(), at, 0.5, found, std::size(found));
  if (!(distance >= 0) || triangle < 0 || std::size_t(triangle) >= mesh.surface.corner.size())
    outcome.faults.push_back("the closest triangle is " + std::to_string(triangle) + " at " +
                             std::to_string(distance));
  if (near > mesh.surface.corner.size()) outcome.faults.push_back("more triangles are near than there are");
  outcome.sentences.push_back(mesh.surface.solid ? "a solid" : "a sheet");
}

void obj_run(const fs::path& file, Outcome& outcome) {
  mesh_run(file, outcome);
  std::vector<Problem> problems;
  command::body_measure(file, problems);
  problems_take(problems, outcome);
}

// An imported pattern is written as a scene, which must then be read without a fault of its text.
void pattern_run(const fs::path& file, Outcome& outcome) {
  std::vector<Problem> problems;
  const command::Pattern pattern = command::pattern_read(file, problems);
  const scene::FabricSpec fabric = validation::fabric_load(file.parent_path() / "wool.toml", problems);
  problems_take(problems, outcome);
  if (!problems.empty()) return;
  command::Garment garment;
  garment.name = "garment", garment.title = file.filename().string();
  garment.cell = 0.02, garment.fabric = "wool", garment.fabric_file = "wool.toml";
  const Scene scene = command::garment_scene(pattern, garment, fabric);
  validation::scene_check(scene, problems);
  problems_take(problems, outcome);
  const std::string text = command::garment_text(scene, pattern, garment);
  if (!problems.empty()) return;
  const fs::path made = file.parent_path() / "garment.toml";
  std::ofstream(made, std::ios::binary) << text;
  const scene::SceneText read = scene::scene_read(made);
  for (const scene::Faults::Found& fault : read.faults.found)
    outcome.faults.push_back("the scene that it is imported to has a fault: " +
                             scene::problem_text(fault.problem));
  outcome.sentences.push_back("imported");
}

// Inputs of a cloth with driven pins, bodies that move, and wind.
void inputs_run(const fs::path& file, Outcome& outcome) {
  static Outcome opened;
  static const Cloth cloth = cloth_open(file.parent_path() / "inputs.toml", opened);
  if (!cloth) return outcome.faults.push_back("inputs.toml cannot be opened");
  static const std::vector<description::Variable> table =
      description::variables_of(cloth.get(), description::Nodes::kNone);
  const command::InputTable inputs = command::input_table_read(file.string(), table, outcome.sentences);
  if (!outcome.sentences.empty()) return;
  if (inputs.time.empty()) return outcome.faults.push_back("a table without rows passed without a problem");
  std::vector<double> values(inputs.variable.size());
  for (const double time : {-1e9, inputs.time.front(), 0.0, 0.0105, inputs.time.back(), 1e9}) {
    command::input_table_at(inputs, time, values.data());
    for (const double value : values)
      if (!std::isfinite(value))
        return outcome.faults.push_back("an input is not finite between finite rows");
  }
  command::input_table_remarks(inputs, table, 0.001);
  outcome.sentences.push_back("a table");
}

}  // namespace

const std::vector<Reader>& readers() {
  static const std::vector<Reader> all = {
      {"scene",
       Form::kText,
       "scene.toml",
       {"examples", "modelDescription/samples", "tests/stress/fuzz/seeds/scene",
        "tests/stress/fuzz/seeds/fmi"},
       scene_run},
      {"fabric",
       Form::kText,
       "fabric.toml",
       {"examples/fabrics", "tests/stress/fuzz/seeds/fabric"},
       fabric_run},
      {"obj", Form::kText, "body.obj", {"tests/stress/fuzz/seeds/obj"}, obj_run},
      {"stl", Form::kText, "body.stl", {"tests/stress/fuzz/seeds/stl"}, mesh_run},
      {"stl_binary", Form::kBinary, "body.stl", {"tests/stress/fuzz/seeds/stl_binary"}, mesh_run},
      {"pattern",
       Form::kText,
       "pattern.json",
       {"examples/imported", "tests/stress/fuzz/seeds/pattern"},
       pattern_run},
      {"inputs", Form::kText, "inputs.csv", {"tests/stress/fuzz/seeds/inputs"}, inputs_run},
      {"state", Form::kBinary, "saved.state", {}, state_run, states_corpus, kSequenceSeconds},
  };
  return all;
}

void readers_prepare(const fs::path& work) {
  const fs::path root = DRAPE_SOURCE_DIR, seeds = root / "tests/stress/fuzz/seeds";
  constexpr auto kOver = fs::copy_options::overwrite_existing;
  fs::create_directories(work / "files");
  fs::create_directories(work / "fabrics");
  for (const fs::directory_entry& fabric : fs::directory_iterator(root / "examples/fabrics"))
    if (fabric.path().extension() == ".toml") {
      fs::copy_file(fabric, work / "fabrics" / fabric.path().filename(), kOver);
      fs::copy_file(fabric, work / "files" / fabric.path().filename(), kOver);
    }
  for (const char* file : {"box.obj", "ball.obj", "inputs.toml"})
    fs::copy_file(seeds / file, work / "files" / file, kOver);
}

}  // namespace drape::fuzz
