#pragma once

#include <memory>
#include <vector>

#include "pliant/mechanics/potential.h"

namespace pliant {

/// A potential with parameters of a material, for estimation: how its forces and its history depend
/// on them along a quasi-static path ([T] Eqs. 3.7, 4.9).
class ParametricPotential : public HistoryPotential {
 public:
  /// Its law with other values.
  /// @param all  the parameters of the whole system
  virtual std::shared_ptr<const ParametricDensity> law(const Eigen::VectorXd& all) const = 0;

  /// Adds d gradient / d parameters at fixed positions, the history's dependence included.
  /// @param by                     parameters of the whole system
  /// @param history_by_parameter   history_size() x by
  /// @param gradient_by_parameter  3 points x by (N per unit of each)
  virtual void add_force_sensitivity(const Evaluation& at, const std::vector<int>& by,
                                     const Eigen::Ref<const Eigen::MatrixXd>& history_by_parameter,
                                     Eigen::MatrixXd& gradient_by_parameter) const = 0;

  /// Carries d history / d parameters over an accepted step that ended at `at`.
  /// @param positions_by_parameter  3 points x by, at the end of the step
  virtual void advance_sensitivity(const Evaluation& at, const std::vector<int>& by,
                                   const Eigen::MatrixXd& positions_by_parameter,
                                   Eigen::Ref<Eigen::MatrixXd> history_by_parameter) const = 0;
};

}  // namespace pliant
