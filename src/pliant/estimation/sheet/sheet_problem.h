#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/base/run_context.h"
#include "pliant/estimation/least_squares.h"
#include "pliant/estimation/sheet/cord_unknown.h"
#include "pliant/estimation/sheet/sheet_prior.h"
#include "pliant/estimation/sheet/sheet_unknown.h"
#include "pliant/experiment/session/sheet_predictor.h"
#include "pliant/experiment/session/sheet_test.h"

namespace pliant {

/// Shapes of the equilibria of tests by name, where searches for the next may begin.
using SheetGuesses = std::map<std::string, std::vector<Eigen::Matrix3Xd>>;

/// What a fit of some groups of a material to some tests minimises ([T] Eq. 3.6): the differences
/// of forces or positions of all frames, each test's in units of its own `scale`, at equilibria.
/// Unknowns are the parameters of the groups and the friction of cords, test by test. A prior adds
/// a difference, weighed against the noise of the measured ones.
class SheetProblem {
 public:
  /// @param tests     outlive the problem
  /// @param material  complete; says where a search begins
  /// @param strains   largest strain of each group, for bounds and scales of friction
  /// @param cords     friction of cords where a search begins
  /// @param with_cords  whether it is among the unknowns where nobody knows it; else it counts as 0
  /// @param options   bounds, fixed values and priors
  SheetProblem(std::vector<const SheetTest*> tests, const Material& material,
               std::vector<ComponentGroup> groups, std::vector<double> strains,
               const RunContext& context, const CordFrictions& cords = {},
               const FitOptions& options = {}, bool with_cords = true);

  const std::vector<const SheetTest*>& tests() const { return tests_; }
  const std::vector<SheetUnknown>& unknowns() const { return unknowns_; }
  const Eigen::VectorXd& start() const { return start_; }
  Material material_at(const Eigen::VectorXd& values) const;
  /// Adds the frictions of cords.
  void keep_cords(const Eigen::VectorXd& values, CordFrictions& cords) const;

  /// Weight of each test: what its differences are divided by (N or m).
  const std::vector<double>& scales() const { return scales_; }
  void set_scales(std::vector<double> scales) { scales_ = std::move(scales); }

  bool has_priors() const { return !priors_.empty(); }
  /// Standard deviation of what is measured (N or m), against which priors are weighed.
  void set_noise(double noise) { noise_ = noise; }
  /// Root mean square of the measured differences (N or m) at a solution of `least_squares`.
  double rms(const LeastSquaresSummary& solution) const;

  /// Searches begin at these shapes instead of the measured ones, of tests that have any.
  void begin_at(const SheetGuesses& guesses);
  /// Adds the shapes that were found last.
  void keep(SheetGuesses& guesses) const;

  /// Shapes of all frames of a test at some values of the unknowns; nothing where there is no
  /// equilibrium.
  std::optional<std::vector<SheetShape>> predict(std::size_t test, const Eigen::VectorXd& values,
                                                 bool derivatives, int threads) const;

  /// Frames of a test without equilibrium where a search begins.
  std::vector<int> lost_frames(std::size_t test, int threads) const;

  /// `evaluate` keeps the equilibria of the last values for the next.
  LeastSquaresProblem least_squares() const;

  /// What all predictions until now have cost, in seconds on the clock.
  EquilibriumWork work() const;

 private:
  /// The parameters of a test's prediction that unknowns set, and which.
  struct Places {
    std::vector<int> parameters, unknowns;
  };
  Places places_in(const SheetPredictor& predictor) const;
  /// The parameters of a test's prediction at some values of the unknowns.
  Eigen::VectorXd parameters_of(std::size_t test, const Eigen::VectorXd& values) const;
  /// `predict`, while others may be at work.
  std::optional<std::vector<SheetShape>> shapes_of(std::size_t test, const Eigen::VectorXd& values,
                                                   bool derivatives, int threads) const;
  /// Unknowns that differences would change to find a test's derivatives.
  int free_unknowns(std::size_t test) const;
  /// The widths of the loops of a test's cords.
  Eigen::VectorXd widths(std::size_t test, const Eigen::VectorXd& values) const;
  int measured_rows() const;
  /// The elastic tangents of all groups, by all unknowns.
  Eigen::MatrixXd tangents() const;
  /// Of a prior, in units of the differences of forces or positions.
  double prior_weight() const { return noise_ / scales_.front(); }
  bool evaluate(const Eigen::VectorXd& values, Eigen::VectorXd& residual,
                Eigen::MatrixXd* jacobian) const;

  std::vector<const SheetTest*> tests_;
  Material material_;
  std::vector<ComponentGroup> groups_;
  std::vector<SheetUnknown> unknowns_;
  std::vector<SheetPrior> priors_;
  std::vector<double> scales_;
  std::vector<std::unique_ptr<SheetPredictor>> predictors_;
  std::vector<Places> places_;           // of each test
  std::vector<std::vector<int>> cords_;  // unknowns that are cords of each test
  Eigen::VectorXd start_;
  bool monotone_stress_;
  double noise_ = 1;
  mutable double seconds_ = 0;  // on the clock, of predictions
  const RunContext& context_;
};

}  // namespace pliant
