#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace pliant::testing {

/// A results directory as `pliant fit` or `pliant evaluate` writes it, with loops from a formula.
struct SampleOptions {
  std::size_t rows = 300;          ///< of each experiment
  bool evaluation = false;         ///< evaluation.json in place of fit.json
  bool rich = true;                ///< profiles, rival models, a shear and a hanging-weights test
  bool loading_only_bias = false;  ///< the bias strip never unloads
  std::string name = "Jersey 1x1";
  std::string warning = "bias-stretch-8cm: the clamps slipped by 0.4 mm in row 212";
  std::string question = {};  ///< of the data; the first of the warnings
  std::string skipped = {};   ///< an experiment that needs shear
};

/// What the numbers of the sample say, below its headline.
inline constexpr const char* kSampleDetails =
    "The material reproduces 5 of 5 fitted experiments within 1.2 % of peak force.";

/// A temporary folder that goes with its owner.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

void write_sample_results(const std::filesystem::path& directory,
                          const SampleOptions& options = {});

/// Writes `text` to a file, whose folder is made when it is missing.
void write_text(const std::filesystem::path& file, const std::string& text);

}  // namespace pliant::testing
