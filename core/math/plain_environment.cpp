#include "math/plain_environment.h"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace drape::math {
namespace {

#ifndef _WIN32
// Made once and kept; without memory for it the thread keeps the host's.
locale_t c_locale() {
  static const locale_t locale = newlocale(LC_ALL_MASK, "C", locale_t{});
  return locale;
}
#endif

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

#ifdef _WIN32
PlainEnvironment::PlainEnvironment()
    : host_mode_(_configthreadlocale(_ENABLE_PER_THREAD_LOCALE)),
      host_locale_(std::setlocale(LC_ALL, nullptr)) {
  std::setlocale(LC_ALL, "C");
  std::fegetenv(&host_);
  std::fesetenv(FE_DFL_ENV);
}

PlainEnvironment::~PlainEnvironment() {
  std::fesetenv(&host_);
  std::setlocale(LC_ALL, host_locale_.c_str());
  _configthreadlocale(host_mode_);
}
#else
PlainEnvironment::PlainEnvironment() : host_locale_(uselocale(c_locale())) {
  std::fegetenv(&host_);
  std::fesetenv(FE_DFL_ENV);
}

PlainEnvironment::~PlainEnvironment() {
  std::fesetenv(&host_);
  uselocale(host_locale_);
}
#endif

FlushToZero::FlushToZero() : before_(control_read()) { control_write(before_ | kFlush); }
FlushToZero::~FlushToZero() { control_write(before_); }

}  // namespace drape::math
