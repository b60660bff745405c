#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "pliant/estimation/problem.h"
#include "pliant/estimation/unknown.h"
#include "pliant/experiment/component_experiment.h"

namespace pliant {

/// How strongly the rows of one experiment count: the standard deviation of each row's residual.
struct RowNoise {
  Eigen::VectorXd sd;   ///< one per row, in the unit of the measured quantity
  bool stated = false;  ///< by the study; otherwise estimated from residuals
  double typical = 0;   ///< root mean square of `sd` over the used rows
};

/// The estimation of one strain component from all experiments that measure it.
///
/// Unknowns are the parameters of the law followed by the nuisance parameters of each experiment.
/// The residual of a row is (predicted - measured) / sd; that of a row that is left out is zero.
class ComponentProblem {
 public:
  /// @param experiments  all of one component, role fit; they outlive the problem
  explicit ComponentProblem(std::vector<const ComponentExperiment*> experiments);

  /// The same problem with fewer rows.
  using RowChoice = std::function<bool(size_t experiment, size_t row)>;
  ComponentProblem restricted_to(const RowChoice& takes) const;
  /// The same problem with one specimen's rows alone.
  ComponentProblem restricted_to(size_t experiment, int specimen) const;

  const std::vector<const ComponentExperiment*>& experiments() const { return experiments_; }
  /// Rows of an experiment that take part.
  const std::vector<char>& used(size_t experiment) const { return used_[experiment]; }
  int nuisance_count() const { return nuisance_count_; }
  int used_rows() const { return used_rows_; }
  /// Index of an experiment's first nuisance parameter among all nuisance parameters.
  int first_nuisance(size_t experiment) const { return first_nuisance_[experiment]; }
  /// The unknowns of a law of some form, with what a study says of them.
  std::vector<Unknown> unknowns(const ComponentLaw& shape, const FitOptions& options) const;

  double peak_stress() const { return peak_stress_; }
  double largest_strain() const { return largest_strain_; }
  double smallest_strain() const { return smallest_strain_; }

  const std::vector<RowNoise>& noise() const { return noise_; }
  /// Sets the noise of experiments whose noise is not stated from the residuals at a solution, and
  /// the share of stated length noise in forces from the slopes there. Returns the largest relative
  /// change.
  double update_noise(const ComponentLaw& law, const Eigen::VectorXd& nuisance);

  /// The least-squares problem of a law of this shape.
  /// @param unknowns  as `unknowns` gives them for the shape
  Problem problem(const ComponentLaw& shape, std::vector<Unknown> unknowns) const;

 private:
  std::vector<const ComponentExperiment*> experiments_;
  std::vector<int> first_nuisance_;
  std::vector<std::vector<char>> used_;
  std::vector<RowNoise> noise_;
  int nuisance_count_ = 0;
  int used_rows_ = 0;
  double peak_stress_ = 0;
  double largest_strain_ = 0;
  double smallest_strain_ = 0;
};

}  // namespace pliant
