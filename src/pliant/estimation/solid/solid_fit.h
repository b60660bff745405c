#pragma once

#include <string>
#include <vector>

#include "pliant/base/run_context.h"
#include "pliant/estimation/fit_result.h"
#include "pliant/estimation/fit_settings.h"
#include "pliant/estimation/uncertainty.h"
#include "pliant/experiment/experiment.h"

namespace pliant {

/// A solid fitted to all of its experiments together.
struct SolidFit {
  Material material;
  std::vector<Unknown> unknowns;
  Eigen::VectorXd values;
  Uncertainty uncertainty;
  Eigen::VectorXd mesh_error;  ///< of each unknown, either sign; empty: not known
  bool converged = true;
  int iterations = 0;
  double rms = 0;  ///< of the differences, in hundredths of the largest stress of each experiment
  std::vector<FitStage> stages;
  StartRecord starts;
  std::vector<std::string> notes;      ///< what was left out
  std::vector<std::string> questions;  ///< whether stresses are true ones, where that explains more
};

/// Fits the laws of a solid's components to experiments by bounded least squares, from all
/// combinations of where the numbers of its laws begin; spline energies grow control points. A
/// heterogeneous solid begins at the one that is the same everywhere.
/// @param samples       places and width, without components; none: the same everywhere
/// @param components    of the model (`solid_components`)
/// @param experiments   role fit; they outlive the fit
/// @param finer         the same with bodies of elements half as large, which tell the error of the
///                      mesh; none: it is not asked for
/// @throws InputError where an experiment shows nothing of the material, or a component nothing in
///         the experiments; SolverError without any prediction
SolidFit fit_solid(const FitSettings& settings,
                   const std::map<std::string, ComponentModel>& components,
                   const MaterialSamples& samples,
                   const std::vector<const Experiment*>& experiments,
                   const std::vector<const Experiment*>& finer, const RunContext& context);

}  // namespace pliant
