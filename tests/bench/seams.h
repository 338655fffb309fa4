// The effect on a strip of a cut that is sewn again: `drape bench seams`, and the tests of the model's case
// "cut and sewn".
//
//      |////////|     A strip of W x 3 W, warp along y, jaws at both ends, pulled in its plane by
//      |________|     1e-4 of its length; linear laws. It is cut along the weft, along the warp or at
//      |        |     30 degrees to the weft and sewn again, the lower (left) piece on cells of W/n,
//      |////////|     the other on cells `ratio` times as large. Both are compared with the strip in
//                     one piece on cells of W/n.
//
// The rest is the solution of K u = 0 on what pins and seams leave free, K the stiffness of the strip at
// rest, by the method of multipliers:
//
//   (K + s B^T B) du = -K u - B^T [q + s (B u - t)],    q <- q + s (B u - t)
//
// B holds the rows of pins and welds, and with the paper's outline the directions of the rigid links. That
// of a sum of equal rows is as well determined as that of one.
#pragma once
#include <string>
#include <vector>

namespace drape::bench {

enum class SeamCut { kWeft, kWarp, kOblique };

struct SeamCase {
  SeamCut cut = SeamCut::kWeft;
  double ratio = 1;
  int across = 20;     // n
  bool paper = false;  // outline and ties
};

struct SeamFigure {
  double stiffness = 0;  // force on the jaw over that of the uncut strip, less 1
  double strain = 0;  // rms of the warp's strain less that of the uncut strip, beyond two coarse cells from
                      // the cut; over its mean
  double left = 0;    // the forces left, over that of the jaw
};
SeamFigure seam_figure(const SeamCase& of);

// Prints the table: all cuts, ratios and ties at W/20 and W/40, with the order in the cell. If a file is
// named, it is written as CSV. Returns false where that fails.
bool seams_print(const std::string& csv_file, bool quick);

}  // namespace drape::bench
