// What a host has set in its thread changes no bit, and is as it was after every call.
#include <cfenv>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "api/tuning_fixture.h"

namespace drape::api {

using namespace tests;
namespace {

std::vector<double> swung() {
  Logged logged;
  const Cloth c = open_sheet(logged, true);
  EXPECT_TRUE(c);
  run(c, 20, 4);
  std::vector<double> values = nodes(c);
  values.push_back(energy(c).kinetic);
  values.push_back(drape_step_limit(c.get(), nullptr));
  values.push_back(drape_time(c.get()));
  return values;
}

TEST(Host, RoundingModesChangeNoBit) {
  const std::vector<double> expected = swung();
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    ASSERT_EQ(std::fesetround(mode), 0);
    const std::vector<double> found = swung();
    const int after = std::fegetround();
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(after, mode);
    EXPECT_EQ(found, expected) << mode;
  }
}

TEST(Host, TrapsStopNoRun) {
  const std::vector<double> expected = swung();
  std::feclearexcept(FE_ALL_EXCEPT);
  const int before = feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
  const std::vector<double> found = swung();
  const int after = fegetexcept(), raised = std::fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
  fedisableexcept(FE_ALL_EXCEPT);
  feenableexcept(before);
  EXPECT_EQ(after, FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
  EXPECT_EQ(raised, 0);
  EXPECT_EQ(found, expected);
}

#if defined(__SSE2__)
TEST(Host, FlushingToZeroChangesNoBit) {
  const std::vector<double> expected = swung();
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | 0x8040);
  const std::vector<double> found = swung();
  const unsigned after = _mm_getcsr();
  _mm_setcsr(before);
  EXPECT_EQ(after & 0x8040, 0x8040u);
  EXPECT_EQ(found, expected);
}
#endif

}  // namespace
}  // namespace drape::api
