// `drape bench`: starts the benchmark, which is a program of its own beside this one.
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "command/command.h"

namespace drape::command {
namespace {

// Replaces this process, so that the exit code is the benchmark's. Returns only if the benchmark cannot be
// started.
int run_bench(std::vector<std::string> arguments) {
  std::error_code error;
  const std::filesystem::path here = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  const std::string program = here / "drape_bench";
  if (!std::filesystem::exists(program, error))
    return fail(kBadInput,
                "this build has no benchmark; it comes with `bash tests/run.sh`, or with "
                "-DDRAPE_REFERENCE=ON -DDRAPE_BENCH=ON for CMake");
  arguments.insert(arguments.begin(), program);
  std::vector<char*> words;
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  std::fflush(nullptr);
  execv(program.c_str(), words.data());
  return fail(kFailedRun, program + " cannot be started: " + std::strerror(errno));
}

}  // namespace

void command_bench(CLI::App& app, int& exit_code) {
  CLI::App* command = command_add(app, "bench", "measure particle-steps per second; pin it to one core");
  command_accept_all(*command);  // the benchmark reads the words
  command_on_run(*command, [command, &exit_code] { exit_code = run_bench(command_words(*command)); });
}

}  // namespace drape::command
