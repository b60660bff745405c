#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "pliant/io/csv.h"

namespace pliant {

/// Keeps its fields in the order in which they were added.
using Json = nlohmann::ordered_json;

/// Digits of the numbers that `pliant info` tells people.
inline constexpr int kInfoDigits = 4;

/// What `pliant info` says about a file: the same facts for programs and for people.
// ordered_json's own move constructor is what the check objects to.
// NOLINTNEXTLINE(bugprone-exception-escape)
struct FileInfo {
  Json json;                          ///< SI units; starts with `file` and `type`
  std::vector<std::string> lines;     ///< in units that read well
  std::vector<std::string> warnings;  ///< also in `json`
};

/// An empty description that starts with what the file is, e.g. "study/1".
FileInfo begin_info(const std::filesystem::path& path, const std::string& type);

/// A line of `lines`: a label and what it is, in two columns; `indent` 1 for what belongs to the
/// entry above.
std::string labelled(std::string_view label, std::string_view text, int indent = 0);

/// `.csv` of `a/b.CSV`.
std::string lower_case_extension(const std::filesystem::path& path);

/// Finds out what a file or directory is, reads all of it with the reader that the commands use,
/// and describes it.
/// @throws InputError where it is none of Pliant's files, or where its reader refuses it
/// @param reading  how a table is read, where it is one
FileInfo describe_file(const std::filesystem::path& path, const CsvOptions& reading = {});

// The kinds of file, each as `describe_file`.
FileInfo study_info(const std::filesystem::path& path);
FileInfo lab_info(const std::filesystem::path& path);
FileInfo scene_info(const std::filesystem::path& path);
FileInfo session_info(const std::filesystem::path& path);
FileInfo dic_info(const std::filesystem::path& path);
FileInfo pattern_info(const std::filesystem::path& path);
FileInfo rig_info(const std::filesystem::path& path);
FileInfo calibration_info(const std::filesystem::path& path);
FileInfo material_info(const std::filesystem::path& path);
FileInfo csv_info(const std::filesystem::path& path, const CsvOptions& reading = {});
FileInfo u3m_file_info(const std::filesystem::path& path);
FileInfo results_file_info(const std::filesystem::path& path);
FileInfo simulation_info(const std::filesystem::path& path);
FileInfo checkpoint_info(const std::filesystem::path& path);
FileInfo progress_info(const std::filesystem::path& path);
FileInfo answers_info(const std::filesystem::path& path);
FileInfo vtu_info(const std::filesystem::path& path);
FileInfo directory_info(const std::filesystem::path& path);

}  // namespace pliant
