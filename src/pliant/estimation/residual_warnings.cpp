#include "pliant/estimation/residual_warnings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "pliant/base/number_text.h"

namespace pliant {
namespace {

constexpr double kShare = 0.5;       // of the residuals' mean square, for a cause to be named
constexpr double kAboveScatter = 3;  // times what neighbouring rows scatter by
constexpr int kFewestRows = 8;

/// The rows that count, with their residuals.
struct ResidualRows {
  std::vector<std::size_t> row;
  std::vector<double> residual;

  double mean_square() const {
    double sum = 0;
    for (const double r : residual) sum += r * r;
    return sum / static_cast<double>(residual.size());
  }
};

ResidualRows rows_of(const ExperimentResult& e) {
  ResidualRows rows;
  for (std::size_t i = 0; i < e.used.size(); ++i) {
    if (!e.used[i]) continue;
    const auto at = static_cast<Eigen::Index>(i);
    rows.row.push_back(i);
    rows.residual.push_back(e.measured(at) - e.predicted(at));
  }
  return rows;
}

/// Share of the mean square that the means of groups of rows explain, less what as many groups of
/// chance would.
template <class GroupOf>
double explained_by(const ResidualRows& rows, const GroupOf& group_of) {
  std::map<int, std::pair<double, int>> groups;  // sum and count
  for (std::size_t i = 0; i < rows.row.size(); ++i) {
    auto& [sum, count] = groups[group_of(rows.row[i])];
    sum += rows.residual[i];
    ++count;
  }
  if (groups.size() < 2) return 0;
  double explained = 0, spent = 0;
  const auto all = static_cast<double>(rows.residual.size());
  for (const auto& [group, sums] : groups) {
    explained += sums.first * sums.first / sums.second;
    ++spent;
  }
  const double share = explained / all / rows.mean_square();
  return 1 - (1 - share) * (all - 1) / std::max(all - spent, 1.0);
}

/// Number of the cycle of each row within its specimen: a new one begins where loading does.
std::vector<int> cycles_of(const MeasuredPath& path) {
  std::vector<int> cycles;
  int cycle = 0;
  for (std::size_t i = 0; i < path.direction.size(); ++i) {
    const bool begins = i > 0 && path.specimen[i] != path.specimen[i - 1];
    const bool turns = i > 0 && path.direction[i] > 0 && path.direction[i - 1] < 0;
    if (begins) cycle = 0;
    if (!begins && turns) ++cycle;
    cycles.push_back(cycle);
  }
  return cycles;
}

/// The same of a straight line along the rows in their order.
double explained_by_order(const ResidualRows& rows) {
  const double middle = static_cast<double>(rows.row.front() + rows.row.back()) / 2;
  double xy = 0, xx = 0;
  for (std::size_t i = 0; i < rows.row.size(); ++i) {
    const double x = static_cast<double>(rows.row[i]) - middle;
    xy += x * rows.residual[i];
    xx += x * x;
  }
  return xx > 0 ? xy * xy / xx / static_cast<double>(rows.row.size()) / rows.mean_square() : 0;
}

/// One thing that residuals may go with.
struct Cause {
  double share;
  const char* words;
};

std::optional<Cause> leading_cause(const ExperimentResult& e, const MeasuredPath& path,
                                   const ResidualRows& rows) {
  const std::vector<int> cycles = cycles_of(path);
  const bool both_sides = std::ranges::any_of(
      path.strain, [&](double strain) { return strain < -0.1 * std::ranges::max(path.strain); });
  const auto side_of = [&](std::size_t row) { return path.strain[row] > 0 ? 1 : 0; };
  const bool sides = both_sides && path.starts_flat.empty();
  // From coarse to fine: what a coarse one explains the finer ones explain too.
  const Cause causes[] = {
      {explained_by_order(rows),
       "with the order of its rows: the zero drifts, or the specimen creeps"},
      {sides ? explained_by(rows, side_of) : 0,
       "with the side: the zero of what is imposed, or the cloth, is not even"},
      {explained_by(rows, [&](std::size_t row) { return path.specimen[row]; }),
       "with its specimens: they are not of one stiffness or one length, and errors that take them "
       "for one are too small"},
      {explained_by(rows, [&](std::size_t row) { return cycles[row]; }),
       "with its cycles: repeats differ, as where the cloth is worked in or rows are out of "
       "order"}};
  constexpr double kAsGood = 0.8;  // of the finest
  const bool scatter = e.noise_floor && e.rms < kAboveScatter * *e.noise_floor;
  const double most = std::ranges::max(causes, {}, &Cause::share).share;
  if (scatter || most < kShare) return std::nullopt;
  return *std::ranges::find_if(causes,
                               [&](const Cause& cause) { return cause.share >= kAsGood * most; });
}

/// The step of readings that stand on a grid; nothing where they do not.
std::optional<double> step_of(const Eigen::VectorXd& measured) {
  constexpr double kRounding = 1e-3;  // of the step
  std::vector<double> values(measured.begin(), measured.end());
  std::ranges::sort(values);
  const double range = values.back() - values.front();
  double step = range;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double gap = values[i] - values[i - 1];
    if (gap > 1e-9 * range) step = std::min(step, gap);
  }
  if (!(step > 0)) return std::nullopt;
  for (const double value : values) {
    const double steps = (value - values.front()) / step;
    if (std::abs(steps - std::round(steps)) > kRounding * std::max(steps, 1.0)) return std::nullopt;
  }
  return step;
}

std::optional<std::string> coarse_readings(const ExperimentResult& e) {
  constexpr double kCoarse = 0.5;  // of the RMS error, that rounding alone makes
  constexpr double kFewestSteps = 5, kMostSteps = 100;  // finer readings are no worse than others
  const std::optional<double> step = step_of(e.measured);
  if (!step || *step / std::sqrt(12) < kCoarse * e.rms) return std::nullopt;
  const double steps = (e.measured.maxCoeff() - e.measured.minCoeff()) / *step;
  if (steps < kFewestSteps || steps > kMostSteps) return std::nullopt;
  return fmt::format(
      "{}: readings stand on a grid of {} {}, and their rounding is most of the misfit: a finer "
      "resolution tells more",
      e.name, format_number(*step * e.quantity.per_si, 3), e.quantity.unit);
}

}  // namespace

std::vector<std::string> residual_warnings(const ExperimentResult& experiment,
                                           const MeasuredPath& path) {
  const ResidualRows rows = rows_of(experiment);
  if (rows.row.size() < kFewestRows || !(rows.mean_square() > 0)) return {};
  std::vector<std::string> warnings;
  if (const auto cause = leading_cause(experiment, path, rows)) {
    warnings.push_back(fmt::format("{}: {:.0f} % of what the law misses goes {}", experiment.name,
                                   100 * cause->share, cause->words));
  }
  if (auto coarse = coarse_readings(experiment)) warnings.push_back(std::move(*coarse));
  return warnings;
}

}  // namespace pliant
