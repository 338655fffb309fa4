#include "math/plain_environment.h"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace drape::math {
namespace {

// Made once and kept; without memory for it the thread keeps the host's.
locale_t c_locale() {
  static const locale_t locale = newlocale(LC_ALL_MASK, "C", locale_t{});
  return locale;
}

#if defined(__SSE2__)
constexpr unsigned kFlush = 0x8040;  // results (bit 15) and operands (bit 6)
unsigned control_read() { return _mm_getcsr(); }
void control_write(unsigned control) { _mm_setcsr(control); }
#else
constexpr unsigned kFlush = 0;
unsigned control_read() { return 0; }
void control_write(unsigned) {}
#endif

}  // namespace

PlainEnvironment::PlainEnvironment() : host_locale_(uselocale(c_locale())) {
  std::fegetenv(&host_);
  std::fesetenv(FE_DFL_ENV);
}

PlainEnvironment::~PlainEnvironment() {
  std::fesetenv(&host_);
  uselocale(host_locale_);
}

FlushToZero::FlushToZero() : before_(control_read()) { control_write(before_ | kFlush); }
FlushToZero::~FlushToZero() { control_write(before_); }

}  // namespace drape::math
