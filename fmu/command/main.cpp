// The `drape` command.
#include "command/command.h"

int main(int argc, char** argv) {
  using namespace drape::command;
  return line_run(argc, argv,
                  {command_check, command_pack, command_run, command_reference, command_variables,
                   command_bench, command_fabric, command_import, command_form});
}
