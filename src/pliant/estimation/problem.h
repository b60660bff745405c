#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "pliant/base/run_context.h"
#include "pliant/estimation/least_squares.h"
#include "pliant/estimation/statistics/robust_loss.h"
#include "pliant/estimation/unknown.h"
#include "pliant/experiment/experiment.h"
#include "pliant/experiment/stored_rows.h"

namespace pliant {

/// An experiment of a problem, and what predicts it with the laws that the problem looks for.
struct ProblemPart {
  const Experiment* experiment = nullptr;  ///< outlives the problem
  std::unique_ptr<Predictor> predictor = nullptr;
  /// What the difference of each row is multiplied by: 1 / its standard deviation, or 0 where the
  /// row does not count.
  Eigen::VectorXd weight = {};
  /// Whether what the study states of the noise holds for the differences.
  bool takes_stated_noise = true;
  /// What a difference of 1 is, whatever the noise; absent: differences count by their noise.
  std::optional<double> unit = {};
};

/// Gives a problem the bounds and scales of its unknowns.
void set_bounds(const std::vector<Unknown>& unknowns, LeastSquaresProblem& problem);

/// The least-squares problem of any experiments ([T] Eq. 3.6): the unknowns that make the weighted
/// differences of predicted and measured rows least. A prior adds a difference.
class Problem {
 public:
  /// @param unknowns  each sets the parameters of predictions of its names, wherever they occur;
  ///                  what no unknown sets stays as the predictors have it
  Problem(std::vector<ProblemPart> parts, std::vector<Unknown> unknowns, Workers workers);

  const std::vector<ProblemPart>& parts() const { return parts_; }
  const std::vector<Unknown>& unknowns() const { return unknowns_; }
  const std::vector<SumPrior>& priors() const { return priors_; }

  void set_weight(std::size_t part, Eigen::VectorXd weight) {
    parts_[part].weight = std::move(weight);
  }
  /// Linear combinations of the unknowns that must not be negative, a row each.
  void set_not_negative(Eigen::MatrixXd rows) { not_negative_ = std::move(rows); }

  /// How residuals count. Weights carry it, as `measure_noise` finds them: a search with them and
  /// new weights at its end, in turn, lead to the least loss.
  void set_loss(RobustLoss loss) { loss_ = loss; }
  RobustLoss loss() const { return loss_; }

  /// Rows that count.
  int rows() const;
  /// What the differences of a part are multiplied by because the study gives experiments weights
  /// ([T] 4.3): the root of its own over the mean of all rows.
  double emphasis(std::size_t part) const;

  /// @return nothing where the laws cannot carry the loads
  std::optional<PredictedRows> predict(std::size_t part, const Eigen::VectorXd& values,
                                       bool derivatives) const;
  /// The same without storing it: frames go to a sink one by one, with derivatives by all unknowns.
  /// @return false where the laws cannot carry the loads; the sink may have seen some frames
  bool predict(std::size_t part, const Eigen::VectorXd& values, FrameSink& frames) const;

  /// `evaluate` refers to this problem.
  LeastSquaresProblem least_squares() const;

  /// @name Equilibria where searches begin
  /// @{
  std::vector<Eigen::Matrix3Xd> guesses(std::size_t part) const;
  void begin_at(std::size_t part, std::vector<Eigen::Matrix3Xd> guesses);
  /// @}

  /// What all predictions until now have cost, in seconds on the clock.
  EquilibriumWork work() const;

 private:
  /// Which parameters of a prediction are set by which unknowns; those of fixed unknowns come last.
  struct Places {
    std::vector<int> parameters, unknowns;
    std::size_t free = 0;
  };
  Places places_in(const Predictor& predictor) const;
  std::optional<PredictedRows> predict(std::size_t part, const Eigen::VectorXd& values,
                                       bool derivatives, int threads) const;
  bool predict(std::size_t part, const Eigen::VectorXd& values, bool derivatives, int threads,
               FrameSink& frames) const;
  bool evaluate(const Eigen::VectorXd& values, Eigen::VectorXd& residual,
                Eigen::MatrixXd* jacobian) const;

  std::vector<ProblemPart> parts_;
  std::vector<Unknown> unknowns_;
  std::vector<SumPrior> priors_;
  std::vector<Places> places_;  // of each part
  Eigen::MatrixXd not_negative_;
  RobustLoss loss_ = RobustLoss::none;
  Workers workers_;
  mutable double seconds_ = 0;  // on the clock, of predictions
};

}  // namespace pliant
