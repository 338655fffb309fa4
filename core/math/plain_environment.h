// What a host may have set in its thread, and what the core computes and prints in.
#pragma once
#include <cfenv>
#include <clocale>
#include <string>

namespace drape::math {

// While it lives, its thread has the environment of a C program that has just begun: rounding to nearest, no
// floating-point traps, numbers below 2^-1022 kept, a decimal point, messages in English. Then the thread has
// again what the host had set, and no floating-point flag that the host did not have.
class PlainEnvironment {
 public:
  PlainEnvironment();
  ~PlainEnvironment();
  PlainEnvironment(const PlainEnvironment&) = delete;
  PlainEnvironment& operator=(const PlainEnvironment&) = delete;

 private:
  std::fenv_t host_{};
#ifdef _WIN32
  int host_mode_;  // whether the thread has a locale of its own
  std::string host_locale_;
#else
  locale_t host_locale_;
#endif
};

// While it lives, its thread takes numbers below 2^-1022 for 0, where the processor can. It computes with
// them at a fraction of its speed, and what dies away exponentially reaches them.
class FlushToZero {
 public:
  FlushToZero();
  ~FlushToZero();
  FlushToZero(const FlushToZero&) = delete;
  FlushToZero& operator=(const FlushToZero&) = delete;

 private:
  unsigned before_;
};

}  // namespace drape::math
