#include "apps/pliant/command.h"

#include <algorithm>
#include <iostream>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace pliant {

std::string CommandContext::command_line() const {
  std::string line;
  for (const std::string& argument : arguments) {
    const bool plain =
        !argument.empty() && argument.find_first_of(" \t'\"*$&;") == std::string::npos;
    line += (line.empty() ? "" : " ") + (plain ? argument : fmt::format("'{}'", argument));
  }
  return line;
}

void CommandContext::say(const std::string& line) const { run.progress.message(Level::info, line); }

void CommandContext::print_json(const std::string& text) const {
  if (common.json) std::cout << text << std::flush;
}

void CommandContext::print_written_json(const std::string& command,
                                        const std::filesystem::path& file) const {
  const nlohmann::ordered_json json{{"command", command}, {"written", file.string()}};
  print_json(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

CLI::App& CommandRegistry::add(const std::string& name, const std::string& description) {
  CLI::App* command = app.add_subcommand(name, description);
  command
      ->add_option("--threads", common.threads,
                   "Threads to use (default: all of the machine); results do not depend on it")
      ->check(CLI::Range(1, 1024))
      ->group("Common options");
  command->add_option("--seed", common.seed, "Seed of everything random")->group("Common options");
  command->add_flag("--quiet", common.quiet, "Say nothing but warnings and errors")
      ->group("Common options");
  command->add_option("--log-level", common.log_level, "Least level of messages shown")
      ->check(CLI::IsMember({"debug", "info", "warning", "error"}))
      ->group("Common options");
  command->add_flag("--json", common.json, "Print the result summary as JSON on standard output")
      ->group("Common options");
  return *command;
}

void CommandRegistry::on(CLI::App& command, CommandAction action) {
  actions.emplace_back(&command, std::move(action));
}

}  // namespace pliant
