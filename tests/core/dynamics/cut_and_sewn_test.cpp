// Case "cut and sewn": a strip that is cut and sewn again on other cells behaves like the uncut strip.
// tests/bench/seams.h describes the set-up; `drape bench seams` prints the whole table.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bench/seams.h"

namespace drape::dynamics {
namespace {

using bench::seam_figure;
using bench::SeamCut;
using bench::SeamFigure;

constexpr SeamCut kCuts[] = {SeamCut::kWeft, SeamCut::kWarp, SeamCut::kOblique};

// Cells that coincide: the welds make one row of whole cells, as in the uncut strip, of two rows of half
// cells.
TEST(CutAndSewn, HasNoEffectOnGridsThatCoincide) {
  for (SeamCut cut : {SeamCut::kWeft, SeamCut::kWarp}) {
    const SeamFigure f = seam_figure({cut, 1, 20, false});
    EXPECT_LE(f.left, 1e-9);
    EXPECT_LE(std::abs(f.stiffness), 1e-9);
    EXPECT_LE(f.strain, 1e-9);
  }
}

// Stiffness within 0.3 % at W/20 and 0.1 % at W/40; the strain beyond two coarse cells within 1 %. Where the
// coarser cells are W/13.3, three times as large as W/40, a cut at 30 degrees is off by 0.154 %: it must
// meet the first of these figures.
TEST(CutAndSewn, HardlyChangesTheStrip) {
  for (SeamCut cut : kCuts)
    for (double ratio : {1.0, std::numbers::sqrt2, 2.0, 3.0})
      for (int across : {20, 40}) {
        const SeamFigure f = seam_figure({cut, ratio, across, false});
        const bool coarse = across == 20 || (cut == SeamCut::kOblique && ratio == 3);
        EXPECT_LE(std::abs(f.stiffness), coarse ? 3e-3 : 1e-3) << int(cut) << " " << ratio << " " << across;
        if (!std::isnan(f.strain)) {  // two coarse cells on either side cover the whole strip
          EXPECT_LE(f.strain, 1e-2) << int(cut) << " " << ratio << " " << across;
        }
        EXPECT_LE(f.left, 1e-9);
      }
}

// The paper's rigid links stiffen a cut at 30 degrees, and about half as much on cells half as large. A
// strip cut along the pull cannot be stretched at all.
TEST(CutAndSewn, IsStiffWithRigidLinks) {
  for (double ratio : {1.0, std::numbers::sqrt2, 2.0}) {
    const double coarse = seam_figure({SeamCut::kOblique, ratio, 20, true}).stiffness,
                 fine = seam_figure({SeamCut::kOblique, ratio, 40, true}).stiffness;
    EXPECT_GT(coarse, 0.02);
    EXPECT_NEAR(std::log2(coarse / fine), 1, 0.25);
  }
  EXPECT_GT(seam_figure({SeamCut::kWarp, 1, 20, true}).stiffness, 10);
}

}  // namespace
}  // namespace drape::dynamics
