#include "apps/pliant/usage_problem.h"

#include <algorithm>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/nearest_name.h"

namespace pliant {
namespace {

bool is_option(const std::string& argument) {
  return argument.size() > 1 && argument.front() == '-' && argument != "--";
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

/// Also `--name` of `--name=value`.
std::string option_name(const std::string& argument) {
  return argument.substr(0, argument.find('='));
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

/// The first option that the command has not; empty where it has all.
std::string unknown_option(const std::vector<std::string>& arguments,
                           const std::vector<std::string>& known) {
  const auto found = std::ranges::find_if(arguments, [&](const std::string& argument) {
    const bool is_known = std::ranges::any_of(known, [&](const std::string& name) {
      return name == option_name(argument) ||
             (name.size() == 2 && argument.starts_with(name));  // -oDIR
    });
    return is_option(argument) && !is_known;
  });
  return found == arguments.end() ? std::string() : option_name(*found);
}

}  // namespace

std::string usage_problem(const CLI::App& app, const std::vector<std::string>& arguments,
                          const CLI::ParseError& error) {
  const std::vector<std::string> commands = command_names(app);
  const auto word = std::ranges::find_if_not(arguments, is_option);
  const bool is_command =
      word != arguments.end() && std::ranges::find(commands, *word) != commands.end();
  if (word != arguments.end() && !is_command) {
    return fmt::format("there is no command {}{}; see `pliant --help`", quoted_value(*word),
                       did_you_mean(*word, commands));
  }
  const CLI::App& command = is_command ? *app.get_subcommand(*word) : app;
  const std::string help = is_command ? fmt::format("pliant {} --help", *word) : "pliant --help";
  const std::vector<std::string> options = option_names(command);
  const bool is_unexpected = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr ||
                             dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  const std::string option = is_unexpected ? unknown_option(arguments, options) : std::string();
  if (option.empty()) return fmt::format("{}; see `{}`", error.what(), help);
  return fmt::format("there is no option {}{}; see `{}`", quoted_value(option),
                     did_you_mean(option, options), help);
}

}  // namespace pliant
