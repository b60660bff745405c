#pragma once

#include <string>
#include <utility>
#include <vector>

namespace pliant {

/// A study that was made from an instrument's file or from photographs, not yet written.
struct ImportedStudy {
  std::string study_yaml;                                  ///< content of study.yaml
  std::vector<std::pair<std::string, std::string>> files;  ///< name and content of its other files
  std::vector<std::string> notes;                          ///< what was understood
  std::vector<std::string> warnings;
};

}  // namespace pliant
