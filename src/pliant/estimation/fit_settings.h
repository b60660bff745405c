#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pliant/base/errors.h"
#include "pliant/estimation/statistics/robust_loss.h"
#include "pliant/experiment/experiment.h"
#include "pliant/experiment/model_options.h"

namespace pliant {

enum class EstimatorKind {
  path,    ///< stress carried along the path, exact solution of [T] Eq. 5.2
  anchor,  ///< the published estimator ([T] Eqs. 5.4-5.6)
};

/// How the energy of a solid that is no sum of convex terms by itself is kept convex ([T] 4.3.3).
enum class Convexity {
  within,     ///< by conditions that the search keeps
  projected,  ///< each update goes to the nearest convex energy, as published
  free,       ///< not at all
};

inline std::string_view name_of(Convexity convexity) {
  if (convexity == Convexity::free) return "free";
  return convexity == Convexity::within ? "within" : "projected";
}

/// One stage of an incremental fit of sheets.
struct PlanStage {
  std::vector<std::string> components;
  std::vector<std::string> experiments;  ///< names, or patterns with `*`
  Location where;
};

/// `fit:` of a study. Keys of the maps are parameter names or patterns with `*`.
struct FitOptions {
  EstimatorKind estimator = EstimatorKind::path;
  int control_points = 5;                   ///< most control points of a hermite stiffness
  bool monotone_stress = false;             ///< elastic stress never falls where strain rises
  Convexity convexity = Convexity::within;  ///< of solids
  RobustLoss loss = RobustLoss::none;
  std::map<std::string, std::pair<double, double>> bounds;
  std::map<std::string, double> fix;
  std::map<std::string, GaussianPrior> priors;
  std::vector<PlanStage> plan;  ///< of sheets; empty: the thesis'
};

/// What a fit is told beside its experiments.
struct FitSettings {
  std::string file;    ///< that states it, for errors
  std::string name;    ///< of the material
  double density = 0;  ///< kg/m^2; 0 = not stated
  std::string digest;  ///< of all that was stated: the progress of a fit with another is refused
  ModelOptions model;
  FitOptions fit;
};

}  // namespace pliant
