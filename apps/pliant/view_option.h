#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "pliant/render/camera.h"

namespace pliant {

inline constexpr const char* kDefaultView = "three-quarter";

/// Adds `--view`. Its text is read with `parse_view`.
void add_view_option(CLI::App& command, std::string& view, const std::string& description);

/// "front", "back", "three-quarter", ...
/// @throws InputError
ViewDirection parse_view(const std::string& text);

}  // namespace pliant
