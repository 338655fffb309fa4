// CPU threads that share the work of a step.
//
// A step of a small cloth lasts microseconds, so between two steps a worker spins. After some tens of
// microseconds it yields to others, and then sleeps until it is called. A fork of the process has no workers;
// there the caller does all the work.
#pragma once
#include <memory>

namespace drape::dynamics {

struct Workers;
struct WorkersEnd {
  void operator()(Workers* workers) const;
};
using WorkersHandle = std::unique_ptr<Workers, WorkersEnd>;

// Starts `threads` - 1 workers; the caller of workers_run is the last thread. Null if the operating system
// refuses.
WorkersHandle workers_start(int threads);

// Runs task(context, k) for every thread k, with k = 0 on the caller; returns when all are done. Every thread
// has the rounding mode of the caller.
void workers_run(Workers& workers, void (*task)(void* context, int thread), void* context);

}  // namespace drape::dynamics
