#include "pliant/estimation/uncertainty.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/SVD>
#include <fmt/format.h>

#include "pliant/estimation/estimating_equations.h"
#include "pliant/estimation/statistics/covariance.h"
#include "pliant/estimation/statistics/curve_error.h"

namespace pliant {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kBoundShare = 1e-6;  // of the scale: nearer than this counts as at the bound

using Indices = std::vector<Eigen::Index>;

bool is_at_bound(const Unknown& unknown, double value) {
  const double gap = kBoundShare * unknown.scale;
  return value - unknown.lower <= gap || unknown.upper - value <= gap;
}

/// The coarsest groups of rows that are enough to judge by: specimens, cycles, or frames. What
/// differs between specimens or cycles is in the frames of both alike.
std::vector<GroupSum> groups_to_leave_out(const Problem& problem,
                                          const std::vector<GroupSum>& frames) {
  constexpr std::size_t kEnough = 10;
  const GroupLabels labels = labels_of(problem);
  for (const std::vector<int>* clusters : {&labels.specimen, &labels.cycle}) {
    std::vector<GroupSum> groups = clustered(frames, *clusters);
    if (groups.size() >= kEnough) return groups;
  }
  return frames;
}

ParameterErrors errors_of(const Problem& problem, EstimatingSums sums, const Eigen::VectorXd& unit,
                          const std::vector<ExperimentNoise>& noise) {
  std::vector<double> degrees;
  for (const ExperimentNoise& own : noise) degrees.push_back(own.degrees);
  sums.groups = groups_to_leave_out(problem, sums.groups);
  return parameter_errors(sums, unit, degrees);
}

/// The parts of a problem by their share of the information on an unknown.
std::string shares_of(const Problem& problem, const MeasuredNoise& noise, const ToldUnknowns& told,
                      Eigen::Index unknown) {
  double all = 0;
  std::vector<std::pair<double, std::string>> shares;
  for (std::size_t p = 0; p < noise.rows.size(); ++p) {
    if (!told.empty() && !told[p][static_cast<std::size_t>(unknown)]) continue;
    const double own = noise.weight[p].cwiseProduct(noise.rows[p].by.col(unknown)).squaredNorm();
    shares.emplace_back(own, problem.parts()[p].experiment->info().name);
    all += own;
  }
  std::ranges::sort(shares, std::greater());
  std::string text;
  for (const auto& [share, name] : shares) {
    if (all <= 0 || share < 0.01 * all) continue;
    text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", name, 100 * share / all);
  }
  return text;
}

std::vector<Outlier> outliers_of(const Problem& problem, const MeasuredNoise& noise,
                                 std::size_t p) {
  const ExperimentNoise& own = noise.of[p];
  const Eigen::VectorXd sd = noise.row_sd[p];
  Eigen::VectorXd residual = noise.rows[p].value - problem.parts()[p].experiment->measured();
  for (Eigen::Index i = 0; i < residual.size(); ++i) {
    residual(i) = noise.weight[p](i) > 0 ? residual(i) / sd(i) : 0;
  }
  // A robust scale does not know the rows that are far off.
  const bool measured = own.source == NoiseSource::residuals && problem.loss() == RobustLoss::none;
  return outliers(
      residual, noise.leverage[p],
      measured ? own.spare_rows * own.correlation_length : std::numeric_limits<double>::infinity());
}

Determination grade(const Unknown& unknown, double value, double half_width, double sd) {
  if (unknown.prior && !(sd < unknown.prior->sd / 2)) return Determination::none;
  return determination_of(value, half_width, unknown.scale);
}

void take_errors(const Problem& problem, const Eigen::VectorXd& values, Uncertainty& result) {
  const Indices& free = result.free;
  const ParameterErrors& errors = result.errors;
  result.covariance(free, free) = errors.covariance;
  result.formula_sd(free) = errors.formula_sd;
  result.jackknife_sd(free) = errors.jackknife_sd;
  result.degrees(free) = errors.degrees;
  result.unseen = Eigen::MatrixXd::Zero(values.size(), errors.unseen.cols());
  result.unseen(free, Eigen::all) = errors.unseen;
  for (std::size_t i = 0; i < free.size(); ++i) {
    const Eigen::Index u = free[i];
    const auto index = static_cast<std::size_t>(u);
    const auto at = static_cast<Eigen::Index>(i);
    const Unknown& unknown = problem.unknowns()[index];
    result.at_bound[index] = is_at_bound(unknown, values(u)) ? 1 : 0;
    if (result.at_bound[index] || std::isnan(errors.sd(at))) continue;
    result.std_error(u) = errors.sd(at);
    result.half_width(u) = errors.half_width(at);
    result.determination[index] = grade(unknown, values(u), errors.half_width(at), errors.sd(at));
  }
}

}  // namespace

std::optional<CurveError> Uncertainty::error_of(const Eigen::VectorXd& gradient) const {
  if (errors.covariance.size() == 0) return std::nullopt;
  return curve_error(gradient(free), errors, unit);
}

Uncertainty part_of(const Uncertainty& all, const Indices& unknowns,
                    const std::vector<std::size_t>& parts) {
  Uncertainty part;
  part.covariance = all.covariance(unknowns, unknowns);
  part.std_error = all.std_error(unknowns);
  part.half_width = all.half_width(unknowns);
  part.degrees = all.degrees(unknowns);
  part.formula_sd = all.formula_sd(unknowns);
  part.jackknife_sd = all.jackknife_sd(unknowns);
  part.singular_values = all.singular_values;
  part.unseen = all.unseen(unknowns, Eigen::all);
  Indices among_free;
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const auto u = static_cast<std::size_t>(unknowns[i]);
    part.at_bound.push_back(all.at_bound[u]);
    part.determination.push_back(all.determination[u]);
    part.told_by.push_back(all.told_by[u]);
    const auto free = std::ranges::find(all.free, unknowns[i]);
    if (free == all.free.end()) continue;
    part.free.push_back(static_cast<Eigen::Index>(i));
    among_free.push_back(free - all.free.begin());
  }
  part.unit = all.unit(among_free);
  part.errors.covariance = all.errors.covariance(among_free, among_free);
  part.errors.sd = all.errors.sd(among_free);
  part.errors.degrees = all.errors.degrees(among_free);
  part.errors.half_width = all.errors.half_width(among_free);
  part.errors.formula_sd = all.errors.formula_sd(among_free);
  part.errors.jackknife_sd = all.errors.jackknife_sd(among_free);
  part.errors.unseen = all.errors.unseen(among_free, Eigen::all);
  for (const std::size_t p : parts) {
    part.outliers.push_back(all.outliers[p]);
    part.noise.of.push_back(all.noise.of[p]);
    part.noise.weight.push_back(all.noise.weight[p]);
    part.noise.row_sd.push_back(all.noise.row_sd[p]);
    part.noise.leverage.push_back(all.noise.leverage[p]);
    PredictedRows rows = all.noise.rows[p];
    rows.by = rows.by(Eigen::all, unknowns).eval();
    part.noise.rows.push_back(std::move(rows));
  }
  return part;
}

void add_systematic(const Eigen::VectorXd& bias, const std::vector<Unknown>& unknowns,
                    const Eigen::VectorXd& values, Uncertainty& uncertainty) {
  constexpr double kNormal = 1.96;
  for (std::size_t i = 0; i < uncertainty.free.size(); ++i) {
    const Eigen::Index u = uncertainty.free[i];
    const auto index = static_cast<std::size_t>(u);
    const auto at = static_cast<Eigen::Index>(i);
    const double before = uncertainty.std_error(u);
    if (!(before > 0)) continue;
    const double factor = std::hypot(before, bias(u)) / before;
    uncertainty.std_error(u) *= factor;
    uncertainty.half_width(u) = std::hypot(uncertainty.half_width(u), kNormal * bias(u));
    uncertainty.covariance.row(u) *= factor;
    uncertainty.covariance.col(u) *= factor;
    uncertainty.errors.covariance.row(at) *= factor;
    uncertainty.errors.covariance.col(at) *= factor;
    uncertainty.errors.sd(at) *= factor;
    uncertainty.determination[index] =
        grade(unknowns[index], values(u), uncertainty.half_width(u), uncertainty.std_error(u));
  }
}

Uncertainty uncertainty_of(const Problem& problem, const Eigen::VectorXd& values,
                           const ToldUnknowns& told) {
  const Eigen::Index n = values.size();
  Uncertainty result;
  result.covariance = Eigen::MatrixXd::Zero(n, n);
  result.std_error = Eigen::VectorXd::Constant(n, kNaN);
  result.half_width = result.formula_sd = result.jackknife_sd = result.std_error;
  result.degrees = Eigen::VectorXd::Ones(n);
  result.at_bound.assign(static_cast<std::size_t>(n), 0);
  result.determination.assign(static_cast<std::size_t>(n), Determination::none);
  result.noise = measure_noise(problem, values, told);
  result.free = free_unknowns(problem.unknowns());
  result.unit = units_of(problem.unknowns(), result.free);
  for (std::size_t p = 0; p < problem.parts().size(); ++p) {
    result.outliers.push_back(outliers_of(problem, result.noise, p));
  }
  for (Eigen::Index u = 0; u < n; ++u) {
    const bool free = std::ranges::find(result.free, u) != result.free.end();
    result.told_by.push_back(free ? shares_of(problem, result.noise, told, u) : "");
  }
  if (result.free.empty()) return result;
  const EstimatingSums sums = estimating_sums(problem, result.noise.rows, result.noise.weight,
                                              result.noise.scatter, result.free, told);
  if (told.empty()) {
    const auto unit = result.unit.asDiagonal();
    result.singular_values = (unit * sums.slope() * unit).jacobiSvd().singularValues().cwiseSqrt();
  }
  result.errors = errors_of(problem, sums, result.unit, result.noise.of);
  take_errors(problem, values, result);
  return result;
}

}  // namespace pliant
