#pragma once

#include <string>
#include <vector>

#include "pliant/estimation/law_fit.h"
#include "pliant/estimation/law_uncertainty.h"

namespace pliant {

/// One stage of the published estimator.
struct AnchorStage {
  std::string name;
  double rms_force = 0;  ///< root mean square force error (N, or N/m where forces are per width)
};

struct AnchorFit {
  LawFit fit;
  std::vector<AnchorStage> stages;
};

/// The published estimator ([T] 5.3.2, 5.3.3, Eqs. 5.4-5.7): force errors, or of strips moment
/// errors, at the measured strains, friction from saturated anchors at the last turning point, the
/// approximate solution without b tau.
///
/// Staged as published: stiffness without friction; sigma_max with a very small tau; tau; all
/// together. Where strips were both hung and rolled, the hung ones give the stiffness, which is
/// held while the rolled ones give friction. It is kept as the reference: its assumptions bias it
/// (docs/estimation.md), and no nuisance parameter is estimated.
AnchorFit fit_anchor(const ComponentProblem& problem, const ComponentLaw& shape,
                     const FitOptions& options);

/// Linearised uncertainty of the published estimator's force errors, taken as independent and of
/// one size as it does; of a stiffness that was held, those of the strips that gave it.
Uncertainty estimate_anchor_uncertainty(const ComponentProblem& problem, const LawFit& fit);

}  // namespace pliant
