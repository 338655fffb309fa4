#include "command/arguments.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "command/command.h"
#include "scene/spelling.h"

namespace drape::command {
namespace {

CLI::Option* specified(CLI::Option* option, const OptionSpec& spec) {
  option->required(spec.required);
  if (spec.one_each) option->allow_extra_args(false);
  if (!spec.choices.empty()) option->check(CLI::IsMember(spec.choices));
  if (spec.problem) option->check(spec.problem);
  if (spec.type) option->type_name(spec.type);
  return option;
}

// Turns `--set A=1 B=2` into `--set A=1 --set B=2`: words after a setting that look like settings are
// settings. In reverse order, as CLI11 expects.
std::vector<std::string> arguments_of(int argc, char** argv) {
  std::vector<std::string> arguments;
  bool setting = false;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool option = word == "--set" || word.starts_with("--set=");
    const bool value = !option && !word.empty() && word[0] != '-' && word.find('=') != std::string::npos;
    if (setting && value && arguments.back() != "--set") arguments.push_back("--set");
    setting = option || (setting && value);
    arguments.push_back(word);
  }
  std::reverse(arguments.begin(), arguments.end());
  return arguments;
}

// What is wrong with the first word; empty if nothing is.
std::string command_problem(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return "";
  std::vector<std::string> commands;
  std::string all;
  for (const CLI::App* command : app.get_subcommands({})) {
    commands.push_back(command->get_name());
    all += (all.empty() ? "" : ", ") + command->get_name();
  }
  if (std::find(commands.begin(), commands.end(), argv[1]) != commands.end()) return "";
  const std::string nearest = scene::spelling_nearest(argv[1], commands);
  return "unknown command '" + std::string(argv[1]) + "'; " +
         (nearest.empty() ? "known: " + all : "the nearest is '" + nearest + "'") + "; see drape --help";
}

}  // namespace

CLI::App* command_add(CLI::App& app, const char* name, const char* description) {
  return app.add_subcommand(name, description);
}
void command_on_run(CLI::App& command, std::function<void()> run) { command.callback(std::move(run)); }
void command_require_one(CLI::App& command) { command.require_subcommand(1); }
void command_accept_all(CLI::App& command) {
  command.allow_extras();
  command.set_help_flag();
}
std::vector<std::string> command_words(const CLI::App& command) { return command.remaining(); }

template <class T>
CLI::Option* option_add(CLI::App& command, const char* names, T& to, const char* text,
                        const OptionSpec& spec) {
  CLI::Option* option = command.add_option(names, to, text);
  if (spec.default_shown) option->capture_default_str();
  return specified(option, spec);
}
template CLI::Option* option_add(CLI::App&, const char*, std::string&, const char*, const OptionSpec&);
template CLI::Option* option_add(CLI::App&, const char*, std::optional<std::string>&, const char*,
                                 const OptionSpec&);
template CLI::Option* option_add(CLI::App&, const char*, std::vector<std::string>&, const char*,
                                 const OptionSpec&);
template CLI::Option* option_add(CLI::App&, const char*, double&, const char*, const OptionSpec&);
template CLI::Option* option_add(CLI::App&, const char*, std::optional<double>&, const char*,
                                 const OptionSpec&);
template CLI::Option* option_add(CLI::App&, const char*, int&, const char*, const OptionSpec&);
CLI::Option* option_add(CLI::App& command, const char* names,
                        const std::function<void(const std::string&)>& take, const char* text,
                        const OptionSpec& spec) {
  return specified(command.add_option_function<std::string>(names, take, text), spec);
}
void flag_add(CLI::App& command, const char* names, bool& to, const char* text) {
  command.add_flag(names, to, text);
}

void option_require_range(CLI::Option& option, double low, double high) {
  option.check(CLI::Range(low, high));
}
bool option_given(const CLI::Option& option) { return option.count() > 0; }

bool is_positive_number(const std::string& text) {
  double value = 0;
  return CLI::detail::lexical_cast(text, value) && value > 0 && std::isfinite(value);
}

int line_run(int argc, char** argv, const std::vector<void (*)(CLI::App&, int&)>& commands) {
  CLI::App app{"Drape: woven cloth as a co-simulation unit", "drape"};
  app.set_version_flag("--version", std::string("drape ") + drape_version());
  app.require_subcommand(1);
  int exit_code = kDone;
  for (const auto add_to : commands) add_to(app, exit_code);
  if (const std::string problem = command_problem(app, argc, argv); !problem.empty())
    return fail(kBadInput, problem);
  try {
    app.parse(arguments_of(argc, argv));
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);  // --help, --version
    return fail(kBadInput, std::string(e.what()) + "; see drape --help");
  } catch (const std::exception& e) {
    return fail(kFailedRun, e.what());
  }
  return exit_code;
}

}  // namespace drape::command
