// Threads that share the work of a step.
//
// A step of a small cloth lasts microseconds, so between two of them a worker spins; after some tens of
// microseconds it gives way to others, and sleeps until it is called. In a fork of the process, where there
// are no workers, the caller does all.
#pragma once
#include <memory>

namespace drape::dynamics {

struct Workers;
struct WorkersEnd {
  void operator()(Workers* workers) const;
};
using WorkersHandle = std::unique_ptr<Workers, WorkersEnd>;

// A crew of `threads`, one of which is the caller of workers_run; null where the system starts no more.
WorkersHandle workers_start(int threads);

// task(context, k) for every thread k, the caller's as 0; returns when all are done. Every thread rounds as
// the caller does.
void workers_run(Workers& workers, void (*task)(void* context, int thread), void* context);

}  // namespace drape::dynamics
