#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "pliant/base/run_context.h"
#include "pliant/estimation/fit_settings.h"
#include "pliant/estimation/least_squares.h"
#include "pliant/estimation/problem.h"
#include "pliant/estimation/solid/convexity.h"

namespace pliant {

/// What differences of solids' fits are told in.
inline constexpr const char* kDifferenceUnit = "% of the largest stress";

/// What data show of a metric of the Green strain.
struct MetricData {
  std::vector<double> strains;  ///< of all rows, sorted; three a row of principal stretches
  DataScale scale;              ///< the stress is energy per strain

  double low() const { return strains.front(); }
  double high() const { return strains.back(); }
  /// Whether any row changes it.
  bool is_seen() const;
};

/// Whether a component resists changes of volume, which data of any solid tell little of.
inline bool is_of_volume(const std::string& component) {
  return component == "J" || component == "log-J";
}

/// The estimation of a solid from all experiments together: unknowns are the numbers of the laws of
/// all its components.
///
/// Each experiment counts by its largest stress, or by the noise that the study states of it: what
/// a law misses is a share of the stress, and a law that misses one mode by much must not be pulled
/// to those that it happens to meet.
class SolidProblem {
 public:
  /// @param experiments  outlive it
  SolidProblem(const FitSettings& settings, std::vector<const Experiment*> experiments,
               const RunContext& context);

  const std::vector<const Experiment*>& experiments() const { return experiments_; }
  const FitOptions& options() const { return settings_.fit; }
  const RunContext& context() const { return context_; }
  int rows() const;

  /// What the data show of a metric.
  const MetricData& data_of(const std::string& metric);

  /// The least-squares problem of a material of some form, which begins at its numbers.
  Problem problem(const Material& material);

  /// Where the energy of a material's terms of two strains is kept convex: what the data show of
  /// these, by their names.
  std::map<std::string, PairDomain> pair_domains(const Material& material);

  /// From here on rows count by the study's loss as they stand to a material.
  /// @return the largest relative change of an experiment's weights
  double count_by_loss(const Material& material);

  /// Numbers of the material that make the differences least, from its own on: of those, where the
  /// search came to no better ones.
  LeastSquaresSummary solve(Material& material, const LeastSquaresOptions& options = {});

 private:
  std::vector<double> strains_of(const std::string& metric);
  LeastSquaresSummary solve_convex(const Material& material, const LeastSquaresProblem& search,
                                   const Eigen::VectorXd& start,
                                   const LeastSquaresOptions& options);

  const FitSettings& settings_;
  std::vector<const Experiment*> experiments_;
  RunContext context_;
  double energy_ = 0;                               // largest of the data, roughly
  double seconds_ = 1;                              // that the longest took; 1 where none has times
  std::vector<std::unique_ptr<Predictor>> probes_;  // of the experiments
  std::map<std::string, MetricData> data_;
  std::vector<Eigen::VectorXd> by_loss_;  // weights of rows; empty: squares count
};

/// Gives the laws of a material's components other numbers, in the order of `unknowns_of` a solid.
void set_numbers(const Eigen::VectorXd& numbers, Material& material);

/// Root mean square of the weighted differences.
double rms_of(const LeastSquaresSummary& solution, int rows);

}  // namespace pliant
