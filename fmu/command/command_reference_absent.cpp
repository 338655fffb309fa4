// `drape reference` in a build without the reference solver.
#include "command/command.h"

namespace drape::command {

void command_reference(CLI::App& app, int& exit_code) {
  CLI::App* command = command_add(app, "reference", "not in this build: configure with -DDRAPE_REFERENCE=ON");
  command_accept_all(*command);
  command_on_run(*command, [&exit_code] {
    exit_code = fail(kBadInput, "this build has no reference; configure with -DDRAPE_REFERENCE=ON");
  });
}

}  // namespace drape::command
