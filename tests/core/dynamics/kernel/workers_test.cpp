// The worker threads that share a step.
#include "dynamics/kernel/workers.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>

namespace drape::dynamics {
namespace {

using Counts = std::array<int, 4>;

void count(void* counts, int thread) { ++(*static_cast<Counts*>(counts))[std::size_t(thread)]; }

TEST(Workers, DoEachTheirTaskOnceACall) {
  const WorkersHandle crew = workers_start(4);
  Counts counts{};
  for (int k = 0; k < 10000; ++k) workers_run(*crew, count, &counts);
  EXPECT_EQ(counts, (Counts{10000, 10000, 10000, 10000}));
}

TEST(Workers, WakeFromSleep) {
  const WorkersHandle crew = workers_start(4);
  Counts counts{};
  for (int k = 0; k < 3; ++k) {
    usleep(100000);
    workers_run(*crew, count, &counts);
  }
  EXPECT_EQ(counts, (Counts{3, 3, 3, 3}));
}

// A fork has only the thread that forked.
TEST(Workers, AreNotMissedInAFork) {
  WorkersHandle crew = workers_start(4);
  const pid_t child = fork();
  if (child == 0) {
    Counts counts{};
    workers_run(*crew, count, &counts);
    crew.reset();
    _exit(counts == Counts{1, 1, 1, 1} ? 0 : 1);
  }
  int status = -1;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

}  // namespace
}  // namespace drape::dynamics
