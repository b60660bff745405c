#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pliant {

/// An experiment that all fits of a comparison take.
struct ComparedSession {
  std::string name;
  std::string unit;  ///< of its RMS error, `N` or `mm`
  bool validation = false;
};

/// What came of one cloth model in one variant.
struct ComparedFit {
  std::string model, variant;
  std::string folder;   ///< of its own results; empty where it failed
  std::string failure;  ///< empty where there is a result
  bool converged = false;
  std::optional<int> parameters;
  std::optional<double> seconds;
  std::optional<double> misfit;               ///< per cent
  std::vector<std::optional<double>> errors;  ///< RMS of each session, in its unit; or none

  std::optional<double> error(std::size_t session) const {
    return session < errors.size() ? errors[session] : std::nullopt;
  }

  /// `nonlinear-orthotropic`: stiffness is a curve, weft and warp have their own.
  bool is_nonlinear() const { return variant.starts_with("nonlinear"); }
  bool is_orthotropic() const { return variant.ends_with("orthotropic"); }
};

/// Several cloth models fitted to the same sessions.
struct ModelComparison {
  std::vector<ComparedSession> sessions;
  std::vector<ComparedFit> fits;  ///< variant by variant, in each the models ([T] Tables A.1-A.4)
};

/// What the table of several fits shows, in a few sentences: which is the best, what curves and
/// directions of their own are worth, whether a variant is worse than one that it contains, and
/// which fits predict best.
std::string verdict(const ModelComparison& comparison);

/// `stvk` -> `St. Venant-Kirchhoff`; names it does not know come back as they are.
std::string model_title(const std::string& model);

/// `nonlinear-orthotropic` -> `nonlinear, orthotropic`
std::string variant_title(const std::string& variant);

/// `nonlinear orthotropic springs`
std::string fit_title(const ComparedFit& fit);

}  // namespace pliant
