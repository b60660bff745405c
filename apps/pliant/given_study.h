#pragma once

#include <filesystem>
#include <string>

#include "pliant/io/result_directory.h"

#include "apps/pliant/command.h"

namespace pliant {

/// The study file to read.
struct StudyFile {
  std::filesystem::path path;
  std::filesystem::path results_base;  ///< folder that paths in the resolved study are relative to
};

/// The study file itself, or the study that an instrument file was imported to, under `imported/`
/// in the results.
StudyFile study_or_imported(const CommandContext& context, const std::filesystem::path& file,
                            ResultDirectory& results);

/// A folder for the results of one of several studies: the file's stem, or its folder's name for a
/// study.yaml.
std::string folder_name(const std::filesystem::path& study);

}  // namespace pliant
