#include "pliant/estimation/residual_warnings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "pliant/base/number_text.h"
#include "pliant/estimation/reading_grid.h"

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

std::optional<Cause> leading_cause(const MeasuredPath& path, const ResidualRows& rows) {
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
  constexpr double kChance = 20;   // rows that a share of chance explains at most
  const double most = std::ranges::max(causes, {}, &Cause::share).share;
  if (most < kShare || most * static_cast<double>(rows.row.size()) < kChance) return std::nullopt;
  return *std::ranges::find_if(causes,
                               [&](const Cause& cause) { return cause.share >= kAsGood * most; });
}

std::optional<std::string> coarse_readings(const ExperimentResult& e) {
  const std::optional<double> step = coarse_step(e.measured, e.rms);
  if (!step) return std::nullopt;
  return fmt::format(
      "{}: readings stand on a grid of {} {}, and their rounding is most of the misfit: a finer "
      "resolution tells more",
      e.name, format_number(*step * e.quantity.per_si, 3), e.quantity.unit);
}

/// The law misses more than chance does.
std::optional<std::string> more_than_scatter(const ExperimentResult& e) {
  constexpr double kMatters = 1;  // per cent
  const bool scatter = !e.noise_floor || e.rms < kAboveScatter * *e.noise_floor;
  if (scatter || e.rms_percent < kMatters) return std::nullopt;
  return fmt::format(
      "{}: the law misses {:.1f} times what neighbouring rows scatter by: it lacks something of "
      "what the cloth does (`--compare laws`, more branches), or the test does",
      e.name, e.rms / *e.noise_floor);
}

}  // namespace

std::vector<std::string> residual_warnings(const ExperimentResult& experiment,
                                           const MeasuredPath& path) {
  const ResidualRows rows = rows_of(experiment);
  if (rows.row.size() < kFewestRows || !(rows.mean_square() > 0)) return {};
  std::vector<std::string> warnings;
  if (const auto cause = leading_cause(path, rows)) {
    warnings.push_back(fmt::format("{}: {:.0f} % of what the law misses goes {}", experiment.name,
                                   100 * cause->share, cause->words));
  } else if (auto more = more_than_scatter(experiment)) {
    warnings.push_back(std::move(*more));
  }
  if (auto coarse = coarse_readings(experiment)) warnings.push_back(std::move(*coarse));
  return warnings;
}

}  // namespace pliant
