#include "dynamics/kernel/thread.h"

#ifdef _WIN32
#define WIN32_LEAN_AND_MEAN
#include <process.h>
#include <windows.h>
#else
#include <pthread.h>
#endif

#include <memory>

namespace drape::dynamics {

#ifdef _WIN32

struct ThreadRun {
  void (*task)(void*, int);
  void* context;
  int number;
  HANDLE thread = nullptr;

  static unsigned __stdcall enter(void* run) noexcept {
    const ThreadRun& r = *static_cast<ThreadRun*>(run);
    r.task(r.context, r.number);
    return 0;
  }
  bool begin() {
    thread = reinterpret_cast<HANDLE>(_beginthreadex(nullptr, 0, enter, this, 0, nullptr));
    return thread != nullptr;
  }
  void join() const {
    WaitForSingleObject(thread, INFINITE);
    CloseHandle(thread);
  }
};

#else

struct ThreadRun {
  void (*task)(void*, int);
  void* context;
  int number;
  pthread_t thread{};

  static void* enter(void* run) noexcept {
    const ThreadRun& r = *static_cast<ThreadRun*>(run);
    r.task(r.context, r.number);
    return nullptr;
  }
  bool begin() { return pthread_create(&thread, nullptr, enter, this) == 0; }
  void join() const { pthread_join(thread, nullptr); }
};

#endif

bool Thread::start(void (*task)(void*, int), void* context, int number) {
  auto run = std::make_unique<ThreadRun>(ThreadRun{task, context, number});
  if (!run->begin()) return false;
  run_ = run.release();
  return true;
}

Thread::~Thread() {
  if (!run_) return;
  run_->join();
  delete run_;
}

}  // namespace drape::dynamics
