// Checks seams against the outlines of their pieces and each other.
#include <map>
#include <set>

#include "scene/diagnostics.h"
#include "seam/layout.h"
#include "validation/checks.h"

namespace drape::validation {

namespace {

// True where the side can be laid out.
bool side_check(const scene::PieceSpec& piece, const scene::SeamSide& side, const std::string& path,
                Problems& problems) {
  const int count = int(piece.outline.size());
  const std::size_t before = problems.size();
  std::set<int> seen;
  for (std::size_t i = 0; i < side.edges.size(); ++i) {
    const std::string at = scene::entry(path + ".edges", i);
    if (side.edges[i] < 0 || side.edges[i] >= count)
      problems.push_back({at, "= " + std::to_string(side.edges[i]) + "; allowed: 0 to " +
                                  std::to_string(count - 1) +
                                  " (edge i runs from point i of the outline to the next)"});
    else if (!seen.insert(side.edges[i]).second)
      problems.push_back({at, "= " + std::to_string(side.edges[i]) + " stands there twice"});
  }
  if (problems.size() == before && seam::seam_chain(piece, side).empty())
    problems.push_back({path + ".edges", "do not follow each other along the outline of the piece " +
                                             scene::in_quotes(piece.name) + "; wanted: one run of edges"});
  return problems.size() == before;
}

}  // namespace

void seams_check(const Scene& scene, const std::vector<bool>& valid, Problems& problems) {
  std::map<std::pair<int, int>, std::string> sewn;  // piece and edge -> the side that uses it
  for (const scene::SeamSpec& seam : scene.seams) {
    for (std::size_t k = 0; k < 2; ++k) {
      const scene::SeamSide& side = seam.side[k];
      const std::string path = "seam." + seam.name + "." + "ab"[k];
      if (side.piece < 0 || side.edges.empty() || !valid[std::size_t(side.piece)]) continue;
      if (!side_check(scene.pieces[std::size_t(side.piece)], side, path, problems)) continue;
      for (std::size_t i = 0; i < side.edges.size(); ++i) {
        const auto [known, fresh] = sewn.emplace(std::pair{side.piece, side.edges[i]}, path);
        if (!fresh)
          problems.push_back({scene::entry(path + ".edges", i), "= " + std::to_string(side.edges[i]) +
                                                                    " is sewn by " + known->second +
                                                                    " already; an edge belongs to one seam"});
      }
    }
  }
}

}  // namespace drape::validation
