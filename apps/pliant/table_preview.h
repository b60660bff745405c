#pragma once

#include <filesystem>
#include <string>

#include "pliant/io/csv.h"

namespace pliant {

/// A page that draws the readings of a table before any fit (report/preview.h).
/// @throws InputError where the table tells no test whose readings could be drawn
std::string table_preview(const std::filesystem::path& file, const CsvOptions& reading);

}  // namespace pliant
