#include "pliant/estimation/law_uncertainty.h"

#include <cmath>

#include "pliant/estimation/statistics/covariance.h"

namespace pliant {

Uncertainty estimate_uncertainty(const ComponentProblem& problem, const LawFit& fit) {
  return uncertainty_of(problem_of(problem, fit), fit.solution.parameters);
}

void raise_error(Uncertainty& uncertainty, Eigen::Index unknown, const SpecimenSpread& spread,
                 const LawFit& fit) {
  if (std::isnan(uncertainty.std_error(unknown))) return;
  const MeanError error =
      fabric_mean_error(uncertainty.std_error(unknown), uncertainty.degrees(unknown), spread);
  uncertainty.std_error(unknown) = error.sd;
  uncertainty.degrees(unknown) = error.degrees;
  uncertainty.half_width(unknown) = error.half_width;
  uncertainty.covariance = raised_to(uncertainty.covariance, uncertainty.std_error);
  const auto index = static_cast<std::size_t>(unknown);
  uncertainty.determination[index] = determination_of(fit.solution.parameters(unknown),
                                                      error.half_width, fit.unknowns[index].scale);
}

}  // namespace pliant
