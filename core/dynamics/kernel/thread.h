// A thread of the operating system. std::thread would take a key of thread-specific data from the process in
// every copy of this library, and not give it back when the library is unloaded. A process has 1024 of them.
#pragma once
#include <utility>

namespace drape::dynamics {

struct ThreadRun;

class Thread {
 public:
  Thread() = default;
  Thread(Thread&& other) noexcept : run_(std::exchange(other.run_, nullptr)) {}
  Thread& operator=(Thread&& other) noexcept {
    std::swap(run_, other.run_);
    return *this;
  }
  ~Thread();  // waits until the thread has ended

  // Starts task(context, number), which must not throw. False if the operating system refuses.
  bool start(void (*task)(void* context, int number), void* context, int number);

 private:
  ThreadRun* run_ = nullptr;
};

}  // namespace drape::dynamics
