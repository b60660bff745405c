#pragma once

#include <string>
#include <vector>

#include "pliant/study/result_files.h"
#include "pliant/study/sheet_model_fits.h"

namespace pliant {

/// What the summary of several cloth models, fitted to the same sessions, says of one.
struct ModelFitSummary {
  /// How well one experiment is met.
  struct Session {
    std::string name, role, unit;
    double rms = 0;  ///< in `unit`
  };

  ModelVariant combination;
  std::string failure;  ///< why there is no result; empty where there is one
  bool converged = false;
  std::size_t parameters = 0;
  double seconds = 0, misfit = 0;  ///< misfit in per cent
  std::vector<Session> sessions;
};

ModelFitSummary summary_of(const ModelFit& fit);

/// The experiments of the fits that succeeded, which all have the same.
std::vector<ModelFitSummary::Session> compared_sessions(const std::vector<ModelFitSummary>& rows);

/// summary.csv: a line for each fit.
std::string summary_csv(const std::vector<ModelFitSummary>& rows);

/// summary.json, fits-of-models/1.
/// @param name  of the study
std::string summary_json(const std::string& name, const std::vector<ModelFitSummary>& rows,
                         const RunFacts& facts);

}  // namespace pliant
