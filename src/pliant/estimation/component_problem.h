#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "pliant/base/journal.h"
#include "pliant/estimation/measured_noise.h"
#include "pliant/estimation/problem.h"
#include "pliant/estimation/unknown.h"
#include "pliant/experiment/component_experiment.h"

namespace pliant {

/// The estimation of one strain component from all experiments that measure it.
///
/// Unknowns are the parameters of the law followed by the nuisance parameters of each experiment.
/// Residuals are weighed by what is known of the noise: at first what the study states, or 1 % of
/// the measured range, then what the residuals of a solution show. That of a row that is left out
/// is zero.
class ComponentProblem {
 public:
  /// @param experiments  all of one component, role fit; they outlive the problem
  /// @param stop         ends everything that works with the problem
  /// @param journal      of the searches that are made with it; outlives the problem
  /// @param threads      that predictions use; their results do not depend on it
  explicit ComponentProblem(std::vector<const ComponentExperiment*> experiments,
                            StopToken stop = {}, RobustLoss loss = RobustLoss::none,
                            Journal& journal = forgetful_journal(), int threads = 1);

  /// The same with the easy parts of its experiments alone; nothing where none has one.
  std::optional<ComponentProblem> easy_part() const;

  /// The same problem with fewer rows.
  using RowChoice = std::function<bool(size_t experiment, size_t row)>;
  ComponentProblem restricted_to(const RowChoice& takes) const;
  /// The same problem with one specimen's rows alone.
  ComponentProblem restricted_to(size_t experiment, int specimen) const;

  const std::vector<const ComponentExperiment*>& experiments() const { return experiments_; }
  const StopToken& stop() const { return stop_; }
  Journal& journal() const { return *journal_; }
  RobustLoss loss() const { return loss_; }
  /// Rows of an experiment that take part.
  const std::vector<char>& used(size_t experiment) const { return used_[experiment]; }
  int nuisance_count() const { return nuisance_count_; }
  int used_rows() const { return used_rows_; }
  /// Index of an experiment's first nuisance parameter among all nuisance parameters.
  int first_nuisance(size_t experiment) const { return first_nuisance_[experiment]; }
  /// The unknowns of a law of some form, with what a study says of them.
  std::vector<Unknown> unknowns(const ComponentLaw& shape, const FitOptions& options) const;

  DataScale scale() const { return {peak_stress_, largest_strain_, seconds_}; }
  double peak_stress() const { return peak_stress_; }
  double largest_strain() const { return largest_strain_; }

  /// Takes the weights that the noise at a solution gives. Returns the largest relative change of
  /// those of an experiment.
  double take_noise(const MeasuredNoise& noise);

  /// The least-squares problem of a law of this shape.
  /// @param unknowns  as `unknowns` gives them for the shape
  Problem problem(const ComponentLaw& shape, std::vector<Unknown> unknowns) const;

 private:
  std::vector<const ComponentExperiment*> experiments_;
  std::vector<std::shared_ptr<const ComponentExperiment>> parts_;  // of an easy part
  StopToken stop_;
  RobustLoss loss_;
  Journal* journal_;
  int threads_ = 1;
  std::vector<int> first_nuisance_;
  std::vector<std::vector<char>> used_;
  std::vector<Eigen::VectorXd> weight_;  // of each experiment
  int nuisance_count_ = 0;
  int used_rows_ = 0;
  double peak_stress_ = 0;
  double largest_strain_ = 0;
  double seconds_ = 1;  // that its longest experiment takes; 1 where none has times
};

}  // namespace pliant
