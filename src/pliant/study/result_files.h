#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pliant/estimation/fit_result.h"

namespace pliant {

/// Facts about a run that its result files carry.
struct RunFacts {
  std::string command;  ///< as typed
  std::string created;  ///< ISO 8601, UTC
  std::string version;
  std::string study, study_sha256;
  std::string material_file;  ///< of an evaluation
};

/// The files of a fit (docs/formats/results.md): name in the result directory and content. The
/// report is not among them.
std::vector<std::pair<std::string, std::string>> fit_files(const StudyResult& result,
                                                           const RunFacts& facts);

/// The files of an evaluation: evaluation.json, curves.csv, predictions.
std::vector<std::pair<std::string, std::string>> evaluation_files(const StudyResult& result,
                                                                  const RunFacts& facts);

/// fit.json or evaluation.json as text; also what `--json` prints.
std::string summary_text(const StudyResult& result, const RunFacts& facts, bool fitted);

}  // namespace pliant
