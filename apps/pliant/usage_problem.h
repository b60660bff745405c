#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace pliant {

/// What is wrong with a command line in one line: a command or option that there is not, with the
/// nearest that there is, else what the parser found; and the help to look at.
std::string usage_problem(const CLI::App& app, const std::vector<std::string>& arguments,
                          const CLI::ParseError& error);

}  // namespace pliant
