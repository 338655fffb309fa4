#include "instance/unfinished.h"

#include <cstdio>

namespace drape::instance {
namespace {

std::string rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

}  // namespace

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
