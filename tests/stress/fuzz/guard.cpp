#include "guard.h"

#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <cstring>

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/common_interface_defs.h>
#include <sanitizer/lsan_interface.h>

// 2 GB at once, or 3 GB in all, are a fault: no file of 128 KB needs as much. The leak checker of GCC 12
// reads before the thread-local memory of a library that was unloaded, unless it is told to keep off.
extern "C" __attribute__((visibility("default"))) const char* __asan_default_options() {
  return "max_allocation_size_mb=2000:hard_rss_limit_mb=3000:handle_abort=1:detect_leaks=1:intercept_tls_get_"
         "addr=0";
}
// Its findings end in an abort, so that the address sanitizer names the case.
extern "C" __attribute__((visibility("default"))) const char* __ubsan_default_options() {
  return "abort_on_error=1";
}
#endif

namespace drape::fuzz {
namespace {

char present[512];

void put(const char* text) {
  if (write(STDERR_FILENO, text, std::strlen(text)) < 0) return;
}

void name_present() {
  if (!present[0]) return;
  put("FAULT: the case that ended the program is ");
  put(present);
  put("\n");
}

void too_long(int) {
  put("FAULT: it took too long\n");
#ifndef __SANITIZE_ADDRESS__
  name_present();
#endif
  std::abort();  // the sanitizer prints where it was
}

#ifndef __SANITIZE_ADDRESS__
void ended(int signal) {
  name_present();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}
#endif

void timer_set(int seconds) {
  const itimerval spent{{0, 0}, {seconds, 0}};
  setitimer(ITIMER_PROF, &spent, nullptr);
  alarm(unsigned(seconds) * 30);  // one that sleeps spends no processor time
}

}  // namespace

void guard_begin() {
  std::signal(SIGPROF, too_long);
  std::signal(SIGALRM, too_long);
#ifdef __SANITIZE_ADDRESS__
  __sanitizer_set_death_callback(name_present);
#else
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL}) std::signal(signal, ended);
  const rlimit memory{rlim_t(3) << 30, rlim_t(3) << 30};
  setrlimit(RLIMIT_AS, &memory);
#endif
}

void guard_case(const std::string& name, int seconds) {
  const std::size_t size = std::min(name.size(), sizeof present - 1);
  std::memcpy(present, name.data(), size);
  present[size] = '\0';
  timer_set(seconds);
}

bool guard_leaks() {
#ifdef __SANITIZE_ADDRESS__
  return __lsan_do_recoverable_leak_check() != 0;
#else
  return false;
#endif
}

}  // namespace drape::fuzz
