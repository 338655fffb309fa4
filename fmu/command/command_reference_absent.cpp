// `drape reference` in a build without the reference solver.
#include "command/command.h"

namespace drape::command {

void command_reference(CLI::App& app, int& exit_code) {
  CLI::App* command = command_add(app, "reference", "not in this build: comes with tests/run.sh");
  command_accept_all(*command);
  command_on_run(*command, [&exit_code] {
    exit_code = fail(kBadInput,
                     "this build has no reference; it comes with `bash tests/run.sh`, or with "
                     "-DDRAPE_REFERENCE=ON for CMake");
  });
}

}  // namespace drape::command
