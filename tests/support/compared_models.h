#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pliant/study/model_fits.h"

namespace pliant::test {

/// A fit of a comparison; without a misfit it failed.
struct SampleFit {
  std::string model, variant;
  std::optional<double> misfit;
  int parameters = 4;
  double pull = 0.5;    ///< RMS error of the fitted session (N)
  double corner = 0.7;  ///< of the one that is predicted (N)
  bool converged = true;
};

/// Two models in two variants: one curve for weft and warp doubles the misfit; springs need no
/// curves of their own, and fail without them.
inline std::vector<SampleFit> sample_fits() {
  return {{"stvk", "nonlinear-orthotropic", 2.0, 10, 0.123, 0.9},
          {"springs", "nonlinear-orthotropic", 3.0, 12, 0.2, 0.6},
          {"stvk", "nonlinear-isotropic", 4.0, 6, 0.25, 0.8},
          {"springs", "nonlinear-isotropic", {}}};
}

inline ModelComparison compared(const std::vector<SampleFit>& samples) {
  ModelComparison comparison{{{"pull", "N", false}, {"corner", "N", true}}, {}};
  for (const SampleFit& sample : samples) {
    ComparedFit fit{sample.model, sample.variant, "", "no grid", false, {}, {}, {}, {}};
    if (sample.misfit) {
      fit = {sample.model, sample.variant,   sample.model + "." + sample.variant,
             "",           sample.converged, sample.parameters,
             12.3,         sample.misfit,    {sample.pull, sample.corner}};
    }
    comparison.fits.push_back(fit);
  }
  return comparison;
}

inline ModelFits sample_model_fits(const std::vector<SampleFit>& fits = sample_fits()) {
  const ModelComparison comparison = compared(fits);
  return {"two models",
          {"pliant fit s.yaml --models all", "2024-01-01T00:00:00Z", "1.0", "s.yaml", "e3b0", ""},
          comparison,
          verdict(comparison)};
}

}  // namespace pliant::test
