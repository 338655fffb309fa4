#include "dynamics/kernel/workers.h"

#include <unistd.h>

#include <atomic>
#include <cfenv>
#include <system_error>
#include <thread>
#include <vector>

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

constexpr int kSpins = 2000, kYields = 100;

// Waits until done(): spins, then yields `yields` times, below 0 without end. False if done() is still false.
template <class Done>
bool await(Done done, int yields) {
  for (int k = 0; k < kSpins; ++k, spin())
    if (done()) return true;
  for (int k = 0; yields < 0 || k < yields; ++k, std::this_thread::yield())
    if (done()) return true;
  return false;
}

}  // namespace

struct Workers {
  std::vector<std::thread> threads;
  void (*task)(void*, int) = nullptr;  // null: workers end
  void* context = nullptr;
  unsigned rounding = 0;
  pid_t process = getpid();       // owner of the threads: a fork has none of them
  std::atomic<unsigned> call{0};  // counts the tasks
  std::atomic<int> busy{0};
};

namespace {

void worker_loop(Workers& w, int k) {
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
  try {
    for (int k = 1; k < threads; ++k) w->threads.emplace_back(worker_loop, std::ref(*w), k);
  } catch (const std::system_error&) {
    w.reset();
  }
  return w;
}

void WorkersEnd::operator()(Workers* w) const {
  if (getpid() != w->process) return;  // no thread to join in a fork, which keeps the memory
  w->task = nullptr;
  workers_call(*w);
  for (std::thread& t : w->threads) t.join();
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
