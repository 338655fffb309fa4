#include "command/progress.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "command/status_line.h"

namespace drape::command {
namespace {

constexpr double kBetween = 0.25;  // s, between two lines
constexpr double kShare = 1e-3;    // of the time, for all lines together

template <class... Value>
std::string format(const char* pattern, Value... value) {
  char text[160];
  std::snprintf(text, sizeof text, pattern, value...);
  return text;
}

double seconds_between(Progress::Clock::time_point a, Progress::Clock::time_point b) {
  return std::chrono::duration<double>(b - a).count();
}

void interval_begins(void* user) {
  Progress& p = *static_cast<Progress*>(user);
  const Progress::Clock::time_point now = Progress::Clock::now();
  if (now < p.due) return;
  status_line_show(progress_text(drape_progress_of(p.cloth), p.until, p.fit, seconds_between(p.began, now)));
  const Progress::Clock::time_point shown = Progress::Clock::now();
  const std::chrono::duration<double> wait(std::max(kBetween, seconds_between(now, shown) / kShare));
  p.due = shown + std::chrono::duration_cast<Progress::Clock::duration>(wait);
}

}  // namespace

std::string clock_text(double seconds) {
  const double whole = std::round(seconds), minutes = std::floor(whole / 60),
               hours = std::floor(minutes / 60);
  if (hours > 0) return format("%.0f:%02.0f:%02.0f", hours, minutes - 60 * hours, whole - 60 * minutes);
  return format("%.0f:%02.0f", minutes, whole - 60 * minutes);
}

std::string progress_text(const drape_progress& now, double until, bool fit, double spent) {
  std::string text = format("%5.1f %%, %.4g of %.6g s", 100 * now.time / until, now.time, until);
  if (fit) {
    if (now.residual > 0) text += format("; residual %.3g of the load", now.residual);
    if (now.seams_open > 0)
      text += format("; %d %s open", now.seams_open, now.seams_open == 1 ? "seam" : "seams");
    return text;
  }
  if (now.time > 0) text += ", " + clock_text(spent * (until - now.time) / now.time) + " left";
  return text + format("; step %.3g us, set by ", 1e6 * now.step_size) + now.set_by;
}

void progress_begin(Progress& p, drape_cloth* cloth, double until) {
  p.cloth = cloth;
  p.until = until;
  p.fit = drape_get_outputs(cloth, 0)->has_fit;
  p.began = p.due = Progress::Clock::now();
  drape_on_interval(cloth, interval_begins, &p);
}

void progress_end(Progress& p) {
  if (!p.cloth) return;
  drape_on_interval(p.cloth, nullptr, nullptr);
  status_line_erase();
}

}  // namespace drape::command
