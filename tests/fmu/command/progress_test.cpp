// The words of a line of progress, and how it is cut.
#include "command/progress.h"

#include <gtest/gtest.h>

#include "command/status_line.h"

namespace drape::command {
namespace {

TEST(Progress, TellsTimeStepAndWhatSetsIt) {
  const drape_progress now{0.15, 2.08333e-5, "warp link of piece 'square', column 1, row 1, strain 0", 0, 0};
  EXPECT_EQ(
      progress_text(now, 0.6, false, 14),
      " 25.0 %, 0.15 of 0.6 s, 0:42 left; step 20.8 us, set by warp link of piece 'square', column 1, row 1, "
      "strain 0");
  drape_progress start = now;
  start.time = 0;
  EXPECT_EQ(progress_text(start, 0.6, false, 0).substr(0, 24), "  0.0 %, 0 of 0.6 s; ste");
}

TEST(Progress, OfAFitTellsResidualAndSeams) {
  drape_progress now{1, 1e-4, "", 0, 2};
  EXPECT_EQ(progress_text(now, 4, true, 1), " 25.0 %, 1 of 4 s; 2 seams open");
  now.residual = 0.01234;
  now.seams_open = 1;
  EXPECT_EQ(progress_text(now, 4, true, 1), " 25.0 %, 1 of 4 s; residual 0.0123 of the load; 1 seam open");
  now.seams_open = 0;
  EXPECT_EQ(progress_text(now, 4, true, 1), " 25.0 %, 1 of 4 s; residual 0.0123 of the load");
}

TEST(Progress, WritesTimesAsClocksDo) {
  EXPECT_EQ(clock_text(0.2), "0:00");
  EXPECT_EQ(clock_text(59.7), "1:00");
  EXPECT_EQ(clock_text(754), "12:34");
  EXPECT_EQ(clock_text(3600 * 27 + 65), "27:01:05");
}

TEST(StatusLine, IsCutBetweenCharacters) {
  EXPECT_EQ(text_cut("abc", 3), "abc");
  EXPECT_EQ(text_cut("abcd", 3), "abc");
  EXPECT_EQ(text_cut("a\u00e4b", 2), "a");  // an a umlaut has two bytes
  EXPECT_EQ(text_cut("a\u00e4b", 3), "a\u00e4");
  EXPECT_EQ(text_cut("\u00e4", 0), "");
}

}  // namespace
}  // namespace drape::command
