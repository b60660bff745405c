#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "pliant/estimation/fit_settings.h"
#include "pliant/experiment/experiment.h"
#include "pliant/material/material.h"

namespace pliant {

/// Components that share one law: one in an orthotropic material, weft and warp in an isotropic
/// one. The first names them.
using ComponentGroup = std::vector<std::string>;

/// A number that a fit looks for: one of a law, or one that belongs to an experiment.
struct Unknown {
  std::string name;
  std::string owner;  ///< component of a number of a law (the first of its group), else experiment
  std::string unit;
  std::vector<std::string> parameters;  ///< of predictions, which it sets
  double start = 0, lower = 0, upper = kNoBound;
  double scale = 1;  ///< a change that matters
  std::optional<GaussianPrior> prior = {};
  std::string together = {};  ///< unknowns of one such name are nearly alike
  bool of_material = true;
  bool of_friction = false;
  bool fixed = false;                 ///< `lower` and `upper` are its value
  std::optional<double> strain = {};  ///< of a control point

  /// Holds it at a value.
  void hold(double value);
};

/// Characteristic magnitudes of the data of a law, from which bounds and scales follow.
struct DataScale {
  double stress = 1;
  double strain = 1;
  double seconds = 1;  ///< that it took
};

/// The numbers of a law that a group shares, which begin at their values: control values of the
/// stiffness, then those of friction and of addends. None is negative; tau lies between a
/// thousandth of the largest strain and three times it.
std::vector<Unknown> unknowns_of(const ComponentLaw& law, const ComponentGroup& group,
                                 const DataScale& data);

/// The limit of energies of a material, which begins at its value.
Unknown unknown_of(const EnergyLimit& limit, MaterialKind kind);

/// The nuisance parameters of an experiment.
std::vector<Unknown> unknowns_of(const Experiment& experiment);

/// Applies the bounds, fixed values and priors of a study. A name without the number of a control
/// value stands for all of them.
void apply_options(const FitOptions& options, std::vector<Unknown>& unknowns);

/// What is known of a sum of unknowns before anything is measured: a Gaussian.
struct SumPrior {
  std::vector<std::pair<Eigen::Index, double>> sum;  ///< unknowns, each times its factor
  double mean = 0, sd = 0;

  /// How far some values of the unknowns are from the mean, in standard deviations.
  double miss(const Eigen::VectorXd& values) const;
};

/// The priors of unknowns that are not fixed, and that those which belong together are alike: each
/// has the value of the one before, +- 0.02 in its unit. Of cords that move alike the data tell the
/// sum alone, and otherwise the smallest thing that goes wrong would say whose it is.
std::vector<SumPrior> priors_of(const std::vector<Unknown>& unknowns);

/// How many are free.
int free_count(const std::vector<Unknown>& unknowns);

/// Where their search begins, within their bounds.
Eigen::VectorXd starts_of(const std::vector<Unknown>& unknowns);

}  // namespace pliant
