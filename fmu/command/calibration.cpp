#include "command/calibration.h"

#include <algorithm>
#include <cstdio>
#include <ctime>

#include "command/command.h"
#include "laboratory/write_calibration.h"

namespace drape::command {
namespace {

std::string today() {
  const std::time_t now = std::time(nullptr);
  char text[16];
  std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
  return text;
}

}  // namespace

bool problems_report(const std::vector<Problem>& problems) {
  for (const Problem& p : problems) fail(kBadInput, scene::problem_text(p));
  return problems.empty();
}

int fabric_calibrate(const scene::FabricSpec& f, double cell, std::string& text,
                     laboratory::Calibration& calibration) {
  std::vector<Problem> problems;
  calibration = laboratory::calibrate(f, {.cell = cell}, problems);
  const laboratory::Calibration& c = calibration;
  if (!problems_report(problems)) return kBadInput;
  for (std::size_t k = 0; k < c.residuals.size(); ++k)
    std::printf("sweep %zu: strips at most %.4f %% off their diagrams\n", k + 1, 100 * c.residuals[k]);
  if (!c.converged) {
    std::string reached;
    if (!c.residuals.empty()) {
      char least[32];
      std::snprintf(least, sizeof least, "%.3g",
                    100 * *std::min_element(c.residuals.begin(), c.residuals.end()));
      reached = std::string("; least difference reached: ") + least + " %";
    }
    return fail(kFailedRun, "the calibration of " + f.name + " does not converge: " + c.why + reached +
                                "; the corrections of the file stay as they were");
  }
  const std::string stored = laboratory::write_calibration(text, c, today(), problems);
  if (!problems_report(problems)) return kBadInput;
  text = stored;
  return kDone;
}

}  // namespace drape::command
