#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "pliant/capture/pattern.h"

namespace pliant {

/// Options of `pattern`, as typed; empty where they were not.
struct PatternArguments {
  std::string kind, output;
  std::string size, camera, tag, gap, square, edge, codes;
  std::optional<int> columns, rows, first_code;
  double dpi = 600;
};

void add_pattern_options(CLI::App& command, PatternArguments& arguments);

/// The pattern that they ask for, on its sheet, which holds it.
/// @param command  that has read them: it knows which were given
/// @throws InputError for options that cannot be used, or that mean nothing for the kind
Pattern pattern_of(const PatternArguments& arguments, const CLI::App& command, std::uint64_t seed);

}  // namespace pliant
