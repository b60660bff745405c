#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "report/sample_results.h"

namespace pliant::testing {

/// One row of a comparison; without a misfit it failed.
struct SampleFit {
  std::string model, variant;
  std::optional<double> misfit;
  int parameters = 4;
  double pull = 0.5;    ///< RMS error of the fitted session (N)
  double corner = 0.7;  ///< of the one that is predicted (N)
  bool converged = true;
};

inline std::string summary_json(const std::vector<SampleFit>& fits) {
  nlohmann::json json{{"pliant", "fits-of-models/1"}, {"name", "two models"}, {"version", "1.0"}};
  json["fits"] = nlohmann::json::array();
  for (const SampleFit& fit : fits) {
    nlohmann::json row{{"model", fit.model},
                       {"variant", fit.variant},
                       {"folder", nullptr},
                       {"failure", "no grid"},
                       {"experiments", nlohmann::json::array()}};
    if (fit.misfit) {
      row["folder"] = fit.model + "." + fit.variant;
      row["failure"] = nullptr;
      row["converged"] = fit.converged;
      row["parameters"] = fit.parameters;
      row["seconds"] = 12.3;
      row["misfit_percent"] = *fit.misfit;
      row["experiments"] = {
          {{"name", "pull"}, {"role", "fit"}, {"rms", fit.pull}, {"unit", "N"}},
          {{"name", "corner"}, {"role", "validate"}, {"rms", fit.corner}, {"unit", "N"}}};
    }
    json["fits"].push_back(row);
  }
  return json.dump(1);
}

/// Two models in two variants: one curve for weft and warp doubles the misfit; springs need no
/// curves of their own, and fail without them.
inline std::vector<SampleFit> sample_fits() {
  return {{"stvk", "nonlinear-orthotropic", 2.0, 10, 0.123, 0.9},
          {"springs", "nonlinear-orthotropic", 3.0, 12, 0.2, 0.6},
          {"stvk", "nonlinear-isotropic", 4.0, 6, 0.25, 0.8},
          {"springs", "nonlinear-isotropic", {}}};
}

inline void write_sample_model_fits(const std::filesystem::path& directory,
                                    const std::vector<SampleFit>& fits = sample_fits()) {
  write_text(directory / "summary.json", summary_json(fits));
}

}  // namespace pliant::testing
