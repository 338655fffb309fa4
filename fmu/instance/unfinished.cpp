#include "instance/unfinished.h"

#include <cmath>
#include <cstdio>

namespace drape::instance {
namespace {

std::string rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

}  // namespace

std::string energy_missing(const drape_unaccounted& u) {
  const double size = std::abs(u.energy);
  if (size <= u.allowed * u.largest) return "";
  char text[240];
  std::snprintf(
      text, sizeof text,
      "at %.6g s the cloth has %s %.3g J that no force accounts for, %.3g %% of its largest energy; "
      "allowed: at most %g %%; smaller steps (step.max) keep its energy better",
      u.time, u.energy > 0 ? "gained" : "lost", size, 100 * size / u.largest, 100 * u.allowed);
  return text;
}

std::vector<std::string> unfinished(drape_cloth* cloth) {
  const drape_outputs& o = *drape_get_outputs(cloth, DRAPE_OUT_POSITION | DRAPE_OUT_STRAIN);
  const std::string by = "by " + rounded(drape_time(cloth)) + " s the ";
  std::vector<std::string> sentences;
  if (o.has_fit && !drape_at_rest(cloth))
    sentences.push_back(by + "fit has not come to rest: forces of " + rounded(o.fit_residual) +
                        " of the load are unbalanced; allowed: " + rounded(kResidualAtRest));
  for (int k = 0; k < o.seam_count; ++k)
    if (o.seam[k].due && o.seam[k].closed == 0)
      sentences.push_back(by + "seam '" + o.seam[k].name + "' has not closed: its largest gap is " +
                          rounded(o.seam[k].gap_max) + " m");
  return sentences;
}

}  // namespace drape::instance
