#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "command.h"

namespace drape {
namespace {

void print_pieces(const drape_cloth* cloth) {
  for (int p = 0; p < drape_piece_count(cloth); ++p) {
    const drape_piece piece = drape_piece_at(cloth, p);
    std::printf("piece %s: %d particles, %d cells of %.6g mm\n", piece.name, piece.node_count,
                piece.cell_count, 1e3 * piece.cell);
  }
}

// Measured from the initial state, which it leaves as it was: for a quarter of a second or one simulated
// second.
bool print_cost(drape_cloth* cloth) {
  using Clock = std::chrono::steady_clock;
  drape_snapshot* start = drape_save(cloth, nullptr);
  const Clock::time_point began = Clock::now();
  // An interval may have a million steps: from one step on, twice as many until it is full.
  const double interval = drape_communication(cloth);
  double length = std::min(drape_outputs_at(cloth, 0)->step_size, interval), simulated = 0, spent = 0;
  drape_status status = DRAPE_OK;
  while (status == DRAPE_OK && spent < 0.25 && simulated < 1) {
    status = drape_advance(cloth, length);
    simulated += length;
    length = std::min(2 * length, interval);
    spent = std::chrono::duration<double>(Clock::now() - began).count();
  }
  const drape_outputs& o = *drape_outputs_at(cloth, 0);
  if (status == DRAPE_OK) {
    std::printf(
        "cost: %.3g s per simulated second, %.0f steps of %d particles (measured over the first %.3g s)\n",
        spent / simulated, o.step_count / simulated, o.node_count, simulated);
  }
  drape_restore(cloth, start);
  drape_snapshot_free(start);
  return status == DRAPE_OK;
}

int check(const std::string& scene_file) {
  const Cloth cloth = cloth_open(scene_file);
  if (!cloth) return kBadInput;
  std::printf("scene %s: %.6g s, communication interval %.6g s\n", drape_scene_name(cloth.get()),
              drape_duration(cloth.get()), drape_communication(cloth.get()));
  print_pieces(cloth.get());
  const char* set_by = nullptr;
  const double limit = drape_step_limit(cloth.get(), &set_by);
  std::printf("step limit: %.6g us, set by %s\n", 1e6 * limit, set_by ? set_by : "nothing");
  std::printf("step: %.6g us\n", 1e6 * drape_outputs_at(cloth.get(), 0)->step_size);
  return print_cost(cloth.get()) ? kDone : kFailedRun;
}

}  // namespace

void command_check(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("check", "read and validate a scene; print its size, step limit and cost");
  auto scene_file = std::make_shared<std::string>();
  option_scene(*command, *scene_file);
  command->callback([scene_file, &exit_code] { exit_code = check(*scene_file); });
}

}  // namespace drape
