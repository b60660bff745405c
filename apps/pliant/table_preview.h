#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "pliant/io/csv.h"

namespace pliant {

/// A page that draws the readings of a table before any fit (report/preview.h).
/// @return none where the table tells no force or moment with what drives it
std::optional<std::string> table_preview(const std::filesystem::path& file,
                                         const CsvOptions& reading);

}  // namespace pliant
