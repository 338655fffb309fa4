// The progress of a run as a line on standard error.
#pragma once
#include <chrono>
#include <string>

#include "drape/drape.h"

namespace drape::command {

struct Progress {
  using Clock = std::chrono::steady_clock;
  drape_cloth* cloth = nullptr;
  double until = 0;  // s
  bool fit = false;
  Clock::time_point began, due;  // of the run; of the next line
};

// Shows a line from now on, whenever the cloth advances: four times a second, or less often where a line
// takes more than a thousandth of that time. `progress` must stay where it is until progress_end.
void progress_begin(Progress& progress, drape_cloth* cloth, double until);

// Erases the line. Nothing is shown from now on.
void progress_end(Progress& progress);

// " 12.4 %, 0.0744 of 0.6 s, 0:42 left; step 20.8 us, set by warp link of piece 'square', ...". In a fit:
// " 12.4 %, 0.5 of 4 s; residual 0.0123 of the load; 2 seams open". `spent`: s, since the run began.
std::string progress_text(const drape_progress& now, double until, bool fit, double spent);

// "0:07", "12:34", "3:05:00".
std::string clock_text(double seconds);

}  // namespace drape::command
