#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pliant {

/// Whether a file is called like a workbook of a spreadsheet program, `.xlsx`.
bool is_workbook(const std::filesystem::path& path);

/// Whether this build reads workbooks (it has liborcus).
bool reads_workbooks();

/// The names of a workbook's sheets, in its order.
/// @throws InputError as `workbook_text`
std::vector<std::string> workbook_sheets(const std::filesystem::path& path);

/// A sheet of a workbook as text: a line a row, its cells quoted and separated by tabs.
/// @param sheet  its name; empty: the first that has a row with two numbers
/// @throws InputError when the file cannot be read, or has no such sheet, with those that it has,
///         and in a build without workbooks
std::string workbook_text(const std::filesystem::path& path, const std::string& sheet);

}  // namespace pliant
