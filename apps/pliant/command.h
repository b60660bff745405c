#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "pliant/base/run_context.h"

namespace pliant {

/// Options that every command takes.
struct CommonOptions {
  int threads = 1;
  std::uint64_t seed = 0;
  bool quiet = false;
  bool json = false;
  std::string log_level = "info";
};

/// What a command works with once the command line has been read.
struct CommandContext {
  CommonOptions common;
  std::vector<std::string> arguments;  ///< the whole command line, for provenance
  RunContext run;

  /// The command line as typed.
  std::string command_line() const;
  /// Prints a line for the user on standard error unless `--quiet`.
  void say(const std::string& line) const;
  /// Prints a result summary on standard output when `--json` was given.
  void print_json(const std::string& text) const;
  /// The same for a command whose result is a file: {"command": ..., "written": FILE}.
  void print_written_json(const std::string& command, const std::filesystem::path& file) const;
};

/// A command of the program: its options, and what it does with them.
using CommandAction = std::function<void(CommandContext&)>;

/// Adds a command to the program; `action` is kept and called when the user chose it.
struct CommandRegistry {
  CLI::App& app;
  CommonOptions& common;
  std::vector<std::pair<CLI::App*, CommandAction>> actions;

  /// A subcommand with the common options.
  CLI::App& add(const std::string& name, const std::string& description);
  void on(CLI::App& command, CommandAction action);
};

void add_init(CommandRegistry& registry);
void add_import(CommandRegistry& registry);
void add_fit(CommandRegistry& registry);
void add_evaluate(CommandRegistry& registry);
void add_lab(CommandRegistry& registry);
void add_simulate(CommandRegistry& registry);
void add_report(CommandRegistry& registry);
void add_render(CommandRegistry& registry);
void add_compare(CommandRegistry& registry);
void add_convert(CommandRegistry& registry);
void add_pattern(CommandRegistry& registry);
void add_calibrate(CommandRegistry& registry);
void add_info(CommandRegistry& registry);

}  // namespace pliant
