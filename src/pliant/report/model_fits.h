#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pliant::report {

/// An experiment that all fits of a comparison take.
struct ComparedSession {
  std::string name;
  std::string unit;  ///< of its RMS error, `N` or `mm`
  bool validation = false;
};

/// One cloth model in one variant, as summary.json states it.
struct ModelFitRow {
  std::string model, variant;
  std::string folder;   ///< of its own results; empty where it failed
  std::string failure;  ///< empty where there is a result
  bool converged = true;
  std::optional<int> parameters;
  std::optional<double> seconds;
  std::optional<double> misfit;               ///< per cent
  std::vector<std::optional<double>> errors;  ///< RMS of each session, in its unit

  /// `nonlinear-orthotropic`: stiffness is a curve, weft and warp have their own.
  bool is_nonlinear() const { return variant.starts_with("nonlinear"); }
  bool is_orthotropic() const { return variant.ends_with("orthotropic"); }
};

/// Several cloth models fitted to the same sessions: summary.json.
struct ModelFits {
  std::string name, command, created, version, study, study_sha256;
  std::vector<ComparedSession> sessions;
  std::vector<ModelFitRow> rows;  ///< variant by variant, in each the models
};

/// Reads `directory`/summary.json.
/// @throws InputError where it is missing, broken, or a field is not what it must be
ModelFits read_model_fits(const std::filesystem::path& directory);

/// `stvk` -> `St. Venant-Kirchhoff`; names it does not know come back as they are.
std::string model_title(const std::string& model);

/// `nonlinear-orthotropic` -> `nonlinear, orthotropic`
std::string variant_title(const std::string& variant);

/// `nonlinear orthotropic springs`
std::string fit_title(const ModelFitRow& row);

}  // namespace pliant::report
