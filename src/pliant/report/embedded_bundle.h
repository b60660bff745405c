#pragma once

#include <string_view>

namespace pliant {

/// The drawing script of the report, one classic script; empty where the build has none.
std::string_view embedded_report_script();

/// The script of three-dimensional views, another one; empty where the build has none.
std::string_view embedded_sheet_script();

/// The style sheet of the report; empty where the build has none.
std::string_view embedded_report_style();

}  // namespace pliant
