#include "dynamics/kernel/workers.h"

#ifdef _WIN32
#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <windows.h>
#else
#include <sched.h>
#endif
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cfenv>
#include <vector>

#include "dynamics/kernel/thread.h"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace drape::dynamics {
namespace {

#if defined(__SSE2__)
void spin() { _mm_pause(); }
unsigned rounding_read() { return _mm_getcsr(); }
void rounding_write(unsigned mode) { _mm_setcsr(mode); }
#else
void spin() {}
unsigned rounding_read() { return unsigned(std::fegetround()); }
void rounding_write(unsigned mode) { std::fesetround(int(mode)); }
#endif

#ifdef _WIN32
void yield_to_others() { SwitchToThread(); }
#else
void yield_to_others() { sched_yield(); }
#endif

constexpr int kSpins = 2000, kYields = 100;

// Waits until done(): spins, then yields `yields` times, below 0 without end. False if done() is still false.
template <class Done>
bool await(Done done, int yields) {
  for (int k = 0; k < kSpins; ++k, spin())
    if (done()) return true;
  for (int k = 0; yields < 0 || k < yields; ++k, yield_to_others())
    if (done()) return true;
  return false;
}

}  // namespace

struct Workers {
  std::vector<Thread> threads;
  void (*task)(void*, int) = nullptr;  // null: workers end
  void* context = nullptr;
  unsigned rounding = 0;
  pid_t process = getpid();       // owner of the threads: a fork has none of them
  std::atomic<unsigned> call{0};  // counts the tasks
  std::atomic<int> busy{0};
};

namespace {

void worker_loop(void* workers, int k) {
  Workers& w = *static_cast<Workers*>(workers);
  for (unsigned seen = 0;; ++seen) {
    const auto called = [&] { return w.call.load(std::memory_order_acquire) != seen; };
    if (!await(called, kYields)) w.call.wait(seen, std::memory_order_acquire);
    if (!w.task) return;
    rounding_write(w.rounding);
    w.task(w.context, k);
    w.busy.fetch_sub(1, std::memory_order_release);
  }
}

void workers_call(Workers& w) {
  w.call.fetch_add(1, std::memory_order_release);
  w.call.notify_all();
}

}  // namespace

WorkersHandle workers_start(int threads) {
  WorkersHandle w(new Workers);
  w->threads.resize(std::size_t(std::max(threads - 1, 0)));
  for (std::size_t k = 0; k < w->threads.size(); ++k)
    if (!w->threads[k].start(worker_loop, w.get(), int(k) + 1)) return nullptr;
  return w;
}

void WorkersEnd::operator()(Workers* w) const {
  if (getpid() != w->process) return;  // no thread to join in a fork, which keeps the memory
  w->task = nullptr;
  workers_call(*w);
  w->threads.clear();
  delete w;
}

void workers_run(Workers& w, void (*task)(void*, int), void* context) {
  if (getpid() != w.process) {
    for (int k = 0; k <= int(w.threads.size()); ++k) task(context, k);
    return;
  }
  w.task = task;
  w.context = context;
  w.rounding = rounding_read();
  w.busy.store(int(w.threads.size()), std::memory_order_relaxed);
  workers_call(w);
  task(context, 0);
  await([&] { return w.busy.load(std::memory_order_acquire) == 0; }, -1);
}

}  // namespace drape::dynamics
