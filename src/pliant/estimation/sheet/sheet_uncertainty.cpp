#include "pliant/estimation/sheet/sheet_uncertainty.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/LU>
#include <fmt/format.h>

#include "pliant/estimation/sheet/sheet_options.h"
#include "pliant/estimation/sheet/sheet_problem.h"

namespace pliant {
namespace {

/// Information below this part of the largest one, in units of the values, is none.
constexpr double kNoInformation = 1e-10;

/// Residuals and derivatives of the frames of a test, by all unknowns.
struct Linearised {
  std::vector<Eigen::VectorXd> residual;
  std::vector<Eigen::MatrixXd> jacobian;
  double variance = 0;          // of the residuals
  Eigen::VectorXd information;  // of each unknown, in units of it
};

/// All unknowns of a fit.
struct Unknowns {
  std::vector<SheetUnknown> all;
  std::vector<const SheetStage*> stage_of;                       // the last of each
  std::map<const SheetTest*, std::vector<Eigen::Index>> places;  // in tests, whose own cords are
                                                                 // the last ones
  Eigen::VectorXd values;
};

template <class Takes>
const SheetStage* last_stage(const std::vector<SheetStage>& plan, const Takes& takes) {
  const SheetStage* last = nullptr;
  for (const SheetStage& stage : plan) {
    if (takes(stage)) last = &stage;
  }
  return last;
}

Unknowns all_unknowns(const SheetFit& fit, const std::vector<SheetStage>& plan,
                      const FitOptions& options) {
  Unknowns unknowns;
  std::vector<Eigen::Index> of_material;
  for (const ComponentGroup& group : fit.groups) {
    const SheetStage* last = last_stage(plan, [&](const SheetStage& stage) {
      return std::ranges::find(stage.groups, group) != stage.groups.end();
    });
    for (const SheetUnknown& unknown :
         unknowns_of(fit.material, {group}, {largest_strain(fit, group)})) {
      of_material.push_back(static_cast<Eigen::Index>(unknowns.all.size()));
      unknowns.all.push_back(unknown);
      unknowns.stage_of.push_back(last);
    }
  }
  unknowns.values = values_of(fit.material, fit.groups);
  for (const SheetStage& stage : plan) {
    for (const SheetTest* test : stage.tests) {
      if (unknowns.places.contains(test)) continue;
      const std::vector<SheetUnknown> cords = cord_unknowns(*test);
      const auto first = static_cast<Eigen::Index>(unknowns.all.size());
      const auto count = static_cast<Eigen::Index>(cords.size());
      std::vector<Eigen::Index> places = of_material;
      for (Eigen::Index i = 0; i < count; ++i) places.push_back(first + i);
      const SheetStage* last = last_stage(plan, [&](const SheetStage& other) {
        return std::ranges::find(other.tests, test) != other.tests.end();
      });
      unknowns.stage_of.insert(unknowns.stage_of.end(), cords.size(), last);
      unknowns.all.insert(unknowns.all.end(), cords.begin(), cords.end());
      unknowns.values.conservativeResize(first + count);
      if (count > 0) unknowns.values.tail(count) = cord_widths(*test, fit.cords);
      unknowns.places.emplace(test, std::move(places));
    }
  }
  apply_options(options, unknowns.all);
  return unknowns;
}

Linearised linearise(const SheetTest& test, const SheetFit& fit, const Unknowns& unknowns,
                     const RunContext& context) {
  const SheetProblem problem({&test}, fit.material, fit.groups,
                             std::vector<double>(fit.groups.size(), 1), context, fit.cords);
  const LeastSquaresProblem squares = problem.least_squares();
  Eigen::VectorXd residual(squares.residuals);
  Eigen::MatrixXd own;
  Linearised result;
  if (!squares.evaluate(problem.start(), residual, &own)) return result;
  const double scale = problem.scales().front();
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(test.rows(), unknowns.values.size());
  jacobian(Eigen::all, unknowns.places.at(&test)) = scale * own.topRows(test.rows());
  residual = scale * residual.head(test.rows()).eval();
  Eigen::Index row = 0;
  for (int frame = 0; frame < test.frame_count(); ++frame) {
    const int rows = test.rows(frame);
    result.residual.push_back(residual.segment(row, rows));
    result.jacobian.push_back(jacobian.middleRows(row, rows));
    row += rows;
  }
  result.variance = std::max(residual.squaredNorm() / test.rows(), 1e-20 * scale * scale);
  result.information = jacobian.colwise().squaredNorm().transpose() / result.variance;
  return result;
}

/// Of what a stage compares.
double mean_variance(const SheetStage& stage, const std::map<const SheetTest*, Linearised>& tests) {
  double squares = 0, rows = 0;
  for (const SheetTest* test : stage.tests) {
    squares += tests.at(test).variance * test->rows();
    rows += test->rows();
  }
  return squares / rows;
}

/// Frames whose parts of g go together.
int lag_of(int frames) { return static_cast<int>(std::lround(std::sqrt(frames))); }

}  // namespace

SheetUncertainty sheet_uncertainty(const SheetFit& fit, const std::vector<SheetStage>& plan,
                                   const FitOptions& options, const RunContext& context) {
  SheetUncertainty result;
  const Unknowns unknowns = all_unknowns(fit, plan, options);
  const std::vector<const SheetStage*>& stage_of = unknowns.stage_of;
  result.unknowns = unknowns.all;
  result.values = unknowns.values;
  const Eigen::Index n = unknowns.values.size();

  std::map<const SheetTest*, Linearised> tests;
  for (const SheetStage* stage : stage_of) {
    for (const SheetTest* test : stage->tests) {
      if (!tests.contains(test)) {
        tests.emplace(test, linearise(*test, fit, unknowns, context));
      }
    }
  }

  // In units of the values: g_i and p_i are both of the size of 1.
  Eigen::VectorXd unit = unknowns.values.cwiseAbs();
  for (Eigen::Index u = 0; u < n; ++u) {
    if (unit(u) == 0) unit(u) = result.unknowns[static_cast<std::size_t>(u)].scale;
  }
  Eigen::MatrixXd slope = Eigen::MatrixXd::Zero(n, n), meat = Eigen::MatrixXd::Zero(n, n);
  const auto takes = [&](Eigen::Index unknown, const SheetTest* test) {
    const auto& used = stage_of[static_cast<std::size_t>(unknown)]->tests;
    return std::ranges::find(used, test) != used.end();
  };
  for (const auto& [test, linear] : tests) {
    const int frames = static_cast<int>(linear.residual.size());
    Eigen::MatrixXd parts = Eigen::MatrixXd::Zero(n, frames);
    for (int f = 0; f < frames; ++f) {
      const auto i = static_cast<std::size_t>(f);
      const Eigen::MatrixXd jacobian = linear.jacobian[i] * unit.asDiagonal();
      const Eigen::MatrixXd product = jacobian.transpose() * jacobian;
      const Eigen::VectorXd part = jacobian.transpose() * linear.residual[i];
      for (Eigen::Index u = 0; u < n; ++u) {
        if (!takes(u, test)) continue;
        slope.row(u) += product.row(u);
        parts(u, f) = part(u);
      }
    }
    const int lag = lag_of(frames);
    for (int l = 0; l <= lag && l < frames; ++l) {
      const double weight = 1 - static_cast<double>(l) / (lag + 1);
      const Eigen::MatrixXd product =
          parts.rightCols(frames - l) * parts.leftCols(frames - l).transpose();
      if (l == 0)
        meat += product;
      else
        meat += weight * (product + product.transpose());
    }
  }

  for (Eigen::Index u = 0; u < n; ++u) {
    const auto& prior = result.unknowns[static_cast<std::size_t>(u)].prior;
    if (!prior) continue;
    const double variance = mean_variance(*stage_of[static_cast<std::size_t>(u)], tests);
    const double weight = unit(u) * unit(u) / (prior->sd * prior->sd) * variance;
    slope(u, u) += weight;
    meat(u, u) += weight * variance;
  }

  std::vector<Eigen::Index> known;
  result.determined = std::vector<char>(result.unknowns.size(), 0);
  for (Eigen::Index u = 0; u < n; ++u) {
    if (result.unknowns[static_cast<std::size_t>(u)].fixed) continue;
    double largest = 0;
    for (Eigen::Index v = 0; v < n; ++v) {
      const bool same =
          stage_of[static_cast<std::size_t>(v)] == stage_of[static_cast<std::size_t>(u)];
      if (same) largest = std::max(largest, slope(v, v));
    }
    if (slope(u, u) > kNoInformation * largest && slope(u, u) > 0) known.push_back(u);
  }
  const Eigen::MatrixXd part = slope(known, known);
  const Eigen::FullPivLU<Eigen::MatrixXd> factor(part);
  result.covariance = Eigen::MatrixXd::Zero(n, n);
  if (factor.isInvertible()) {
    const Eigen::MatrixXd inverse = factor.inverse();
    const Eigen::MatrixXd scaled = unit(known).asDiagonal() * inverse;
    result.covariance(known, known) = scaled * meat(known, known) * scaled.transpose();
    for (const Eigen::Index u : known) result.determined[static_cast<std::size_t>(u)] = 1;
  }

  for (Eigen::Index u = 0; u < n; ++u) {
    double all = 0;
    std::vector<std::pair<double, std::string>> shares;
    for (const SheetTest* test : stage_of[static_cast<std::size_t>(u)]->tests) {
      const Linearised& linear = tests.at(test);
      if (linear.information.size() == 0) continue;
      shares.emplace_back(linear.information(u), test->name());
      all += linear.information(u);
    }
    std::ranges::sort(shares, std::greater());
    std::string text;
    for (const auto& [share, name] : shares) {
      if (all <= 0 || share < 0.01 * all) continue;
      text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", name, 100 * share / all);
    }
    result.told_by.push_back(text);
  }
  return result;
}

}  // namespace pliant
