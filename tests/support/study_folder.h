#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "pliant/study/study.h"

#include "io/temporary_folder.h"

namespace pliant::test {

/// A temporary folder with measurements and studies of them.
class StudyFolder {
 public:
  const std::filesystem::path& path() const { return folder_.path(); }

  std::filesystem::path write(const std::string& name, std::string_view content) const {
    return folder_.write(name, content);
  }

  /// A study of a fabric of 0.15 kg/m^2 with one experiment, the YAML mapping `entry`; `more` are
  /// further lines of the study.
  Study study(const std::string& entry, const std::string& more = "") const {
    return read_study(write("study.yaml", "pliant: study/1\nname: jersey\ndensity: 0.15 kg/m^2\n" +
                                              more + "experiments:\n  - " + entry + "\n"));
  }

  std::unique_ptr<ComponentExperiment> experiment(const std::string& entry,
                                                  const std::string& more = "") const {
    const Study read = study(entry, more);
    return read_experiment(read.experiments.front(), read);
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace pliant::test
