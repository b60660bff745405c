#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>

#include "pliant/estimation/sheet/sheet_unknown.h"

namespace pliant {

/// What is known of a sum of unknowns before anything is measured: a Gaussian.
struct SheetPrior {
  std::vector<std::pair<Eigen::Index, double>> sum;  ///< unknowns, each times its factor
  double mean = 0, sd = 0;

  /// How far some values of the unknowns are from the mean, in standard deviations.
  double miss(const Eigen::VectorXd& values) const;
};

/// The priors of unknowns, and that cords of a clip are alike: each has the friction of the one
/// before, +- 0.02 N. Of cords that move alike the data tell the sum alone, and otherwise the
/// smallest thing that goes wrong would say whose it is.
std::vector<SheetPrior> priors_of(const std::vector<SheetUnknown>& unknowns);

}  // namespace pliant
