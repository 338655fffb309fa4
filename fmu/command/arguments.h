// The command line: commands and their options. Only arguments.cpp includes CLI11, which takes seconds to
// compile.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace drape::command {

// Adds a command to the line, or to another command. `run` is called when the line has been read.
CLI::App* command_add(CLI::App& app, const char* name, const char* description);
void command_on_run(CLI::App& command, std::function<void()> run);
void command_require_one(
    CLI::App& command);  // one of its own commands must follow, as in `drape fabric test`

// A command that accepts any words, even --help; command_words returns them in order.
void command_accept_all(CLI::App& command);
std::vector<std::string> command_words(const CLI::App& command);

struct OptionSpec {
  const char* type = nullptr;  // the name of the value in the help
  bool required = false;
  bool default_shown = false;                                   // the help shows the value before
  bool one_each = false;                                        // a list: one value each time it is given
  std::vector<std::string> choices = {};                        // allowed words; empty: all
  std::function<std::string(const std::string&)> problem = {};  // what is wrong with a word; empty if nothing
};

// Adds an option, or with a name such as "SCENE" an argument. If it is not given, `to` keeps its value. T: a
// number or text, one that may be absent, or a list of texts; arguments.cpp names them.
template <class T>
CLI::Option* option_add(CLI::App& command, const char* names, T& to, const char* text,
                        const OptionSpec& spec);
// The same, with a function that takes the value.
CLI::Option* option_add(CLI::App& command, const char* names,
                        const std::function<void(const std::string&)>& take, const char* text,
                        const OptionSpec& spec);
void flag_add(CLI::App& command, const char* names, bool& to, const char* text);

void option_require_range(CLI::Option& option, double low, double high);
bool option_given(const CLI::Option& option);

// Whether the text is a finite number above 0.
bool is_positive_number(const std::string& text);

// Reads the line of `drape` and runs its command. `commands` add themselves to the line.
int line_run(int argc, char** argv, const std::vector<void (*)(CLI::App& app, int& exit_code)>& commands);

}  // namespace drape::command
