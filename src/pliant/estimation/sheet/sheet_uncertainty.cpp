#include "pliant/estimation/sheet/sheet_uncertainty.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <Eigen/LU>
#include <fmt/format.h>

#include "pliant/estimation/autocorrelation.h"
#include "pliant/estimation/sheet/sheet_options.h"
#include "pliant/estimation/sheet/sheet_problem.h"

namespace pliant {
namespace {

/// Information below this part of the largest one, in units of the values, is none.
constexpr double kNoInformation = 1e-10;
/// What is left of the information on an unknown without one of the frames, at least.
constexpr double kLeftWithout = 1e-3;

using Indices = std::vector<Eigen::Index>;

/// What a frame adds to G and g, in units of the values: zero rows for unknowns of other tests.
struct FramePart {
  Eigen::MatrixXd slope;
  Eigen::VectorXd part;
};

/// What a test tells.
struct TestPart {
  std::vector<FramePart> frames;
  double together = 1;          // frames whose parts go together
  double variance = 0;          // of the residuals
  Eigen::VectorXd information;  // on each unknown, in units of the test's residual variance
  EquilibriumWork work;
};

/// Mean over unknowns: how many frames have parts that go together. Parts are counted in units of
/// their scatter under noise.
double frames_together(const std::vector<FramePart>& frames, const Indices& own) {
  double sum = 0;
  for (const Eigen::Index u : own) {
    std::vector<double> series;
    for (const FramePart& frame : frames) {
      const double scatter = std::sqrt(frame.slope(u, u));
      series.push_back(scatter > 0 ? frame.part(u) / scatter : 0);
    }
    sum += integrated_autocorrelation(series);
  }
  return sum / static_cast<double>(own.size());
}

/// The unknowns that the prediction of a test depends on: those of the material and its own cords.
Indices places_in(const SheetTest& test, const std::vector<Unknown>& unknowns) {
  Indices places;
  for (std::size_t u = 0; u < unknowns.size(); ++u) {
    const bool of_material = unknowns[u].of_material;
    if (of_material || unknowns[u].owner == test.name()) {
      places.push_back(static_cast<Eigen::Index>(u));
    }
  }
  return places;
}

/// @param own     unknowns whose last stage takes the test
/// @param places  unknowns that its prediction depends on
/// @param unit    of each unknown
TestPart part_of(const SheetTest& test, const SheetFit& fit, const Indices& own,
                 const Indices& places, const Eigen::VectorXd& unit, const RunContext& context) {
  const SheetProblem problem({&test}, fit.material, fit.groups,
                             std::vector<double>(fit.groups.size(), 1), context, fit.cords);
  const auto predicted = problem.rows().predict(0, problem.start(), /*derivatives=*/true);
  TestPart result;
  result.work = problem.rows().work();
  if (!predicted) return result;
  const Eigen::ArrayXd weights = test.weights();
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(test.rows(), unit.size());
  jacobian(Eigen::all, places) = weights.matrix().asDiagonal() * predicted->by;
  const Eigen::VectorXd residual = weights * (predicted->value - test.measured()).array();
  const double size = test.measured().cwiseAbs().maxCoeff();
  result.variance = std::max(residual.squaredNorm() / test.rows(), 1e-20 * size * size);
  result.information = jacobian.colwise().squaredNorm().transpose() / result.variance;
  jacobian *= unit.asDiagonal();
  const Eigen::Index n = unit.size();
  Eigen::Index row = 0;
  for (int frame = 0; frame < test.frame_count(); ++frame) {
    const auto rows = jacobian.middleRows(row, test.rows(frame));
    const Eigen::MatrixXd product = rows.transpose() * rows;
    const Eigen::VectorXd upright = rows.transpose() * residual.segment(row, test.rows(frame));
    FramePart& part = result.frames.emplace_back();
    part.slope = Eigen::MatrixXd::Zero(n, n);
    part.part = Eigen::VectorXd::Zero(n);
    part.slope(own, Eigen::all) = product(own, Eigen::all);
    part.part(own) = upright(own);
    row += test.rows(frame);
  }
  result.together = frames_together(result.frames, own);
  return result;
}

/// The tests of a plan, in its order, and the last stage of each.
std::vector<std::pair<const SheetTest*, const SheetStage*>> last_stages(
    const std::vector<SheetStage>& plan) {
  std::vector<std::pair<const SheetTest*, const SheetStage*>> tests;
  for (const SheetStage& stage : plan) {
    for (const SheetTest* test : stage.tests) {
      const auto known =
          std::ranges::find(tests, test, &std::pair<const SheetTest*, const SheetStage*>::first);
      if (known == tests.end())
        tests.emplace_back(test, &stage);
      else
        known->second = &stage;
    }
  }
  return tests;
}

/// The unknowns of a fit, and the last stage of each.
std::vector<const SheetStage*> take_unknowns(const SheetFit& fit, const FitOptions& options,
                                             SheetUncertainty& result) {
  const std::vector<SheetStage>& plan = fit.plan;
  std::vector<const SheetStage*> stage_of;
  for (const ComponentGroup& group : fit.groups) {
    const SheetStage* last = nullptr;
    for (const SheetStage& stage : plan) {
      if (std::ranges::find(stage.groups, group) != stage.groups.end()) last = &stage;
    }
    for (const Unknown& unknown : unknowns_of(fit.material, {group}, {largest_strain(fit, group)},
                                              shortest_edge(*plan.front().tests.front()))) {
      result.unknowns.push_back(unknown);
      stage_of.push_back(last);
    }
  }
  for (const auto& [test, stage] : last_stages(plan)) {
    const std::vector<Unknown> cords = cord_unknowns(*test, fit.cords);
    result.unknowns.insert(result.unknowns.end(), cords.begin(), cords.end());
    stage_of.insert(stage_of.end(), cords.size(), stage);
  }
  result.values = starts_of(result.unknowns);
  apply_options(options, result.unknowns);
  return stage_of;
}

/// In units of the values: g and p are both of the size of 1.
Eigen::VectorXd units_of(const SheetUncertainty& result) {
  Eigen::VectorXd unit = result.values.cwiseAbs();
  for (Eigen::Index u = 0; u < unit.size(); ++u) {
    if (unit(u) == 0) unit(u) = result.unknowns[static_cast<std::size_t>(u)].scale;
  }
  return unit;
}

/// An order that is the same in every run, as sums over tests are then.
struct ByName {
  bool operator()(const SheetTest* a, const SheetTest* b) const { return a->name() < b->name(); }
};
using TestParts = std::map<const SheetTest*, TestPart, ByName>;

/// The unknowns on which there is information, in more than one frame.
Indices known_unknowns(const Eigen::MatrixXd& slope, const TestParts& tests,
                       const std::vector<const SheetStage*>& stage_of,
                       const std::vector<Unknown>& unknowns) {
  Eigen::VectorXd of_one = Eigen::VectorXd::Zero(slope.rows());
  for (const auto& [test, part] : tests) {
    for (const FramePart& frame : part.frames) of_one = of_one.cwiseMax(frame.slope.diagonal());
  }
  Indices known;
  for (Eigen::Index u = 0; u < slope.rows(); ++u) {
    if (unknowns[static_cast<std::size_t>(u)].fixed) continue;
    double largest = 0;
    for (Eigen::Index v = 0; v < slope.rows(); ++v) {
      const bool same =
          stage_of[static_cast<std::size_t>(v)] == stage_of[static_cast<std::size_t>(u)];
      if (same) largest = std::max(largest, slope(v, v));
    }
    const bool informed = slope(u, u) > kNoInformation * largest;
    if (informed && slope(u, u) - of_one(u) > kLeftWithout * slope(u, u)) known.push_back(u);
  }
  return known;
}

/// In units of the values; nothing where a frame cannot be left out.
std::optional<Eigen::MatrixXd> jackknife(const Eigen::MatrixXd& slope, const TestParts& tests,
                                         const Indices& known) {
  const auto n = static_cast<Eigen::Index>(known.size());
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(n, n);
  for (const auto& [test, part] : tests) {
    for (const FramePart& frame : part.frames) {
      const Eigen::FullPivLU<Eigen::MatrixXd> without(
          Eigen::MatrixXd((slope - frame.slope)(known, known)));
      if (!without.isInvertible()) return std::nullopt;
      const Eigen::VectorXd change = without.solve(Eigen::VectorXd(frame.part(known)));
      covariance += part.together * change * change.transpose();
    }
  }
  return covariance;
}

/// What priors add to G, and the covariance of what they add to g: in units of the values, against
/// the noise of what a stage compares.
struct PriorPart {
  Eigen::MatrixXd slope, variance;
};

PriorPart prior_part(const SheetUncertainty& result, const Eigen::VectorXd& unit,
                     const TestParts& tests, const std::vector<const SheetStage*>& stage_of) {
  const Eigen::Index n = unit.size();
  PriorPart part{Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n)};
  for (const SumPrior& prior : priors_of(result.unknowns)) {
    double squares = 0, rows = 0;
    const auto first = static_cast<std::size_t>(prior.sum.front().first);
    for (const SheetTest* test : stage_of[first]->tests) {
      squares += tests.at(test).variance * test->rows();
      rows += test->rows();
    }
    Eigen::VectorXd derivative = Eigen::VectorXd::Zero(n);
    for (const auto& [unknown, factor] : prior.sum) {
      derivative(unknown) = factor * unit(unknown) / prior.sd;
    }
    const Eigen::MatrixXd slope = squares / rows * derivative * derivative.transpose();
    part.slope += slope;
    part.variance += squares / rows * slope;
  }
  return part;
}

/// Independent frames of the tests of an unknown, less the unknowns that are found in them.
double degrees_of(const SheetStage& stage, const TestParts& tests, std::ptrdiff_t unknowns) {
  double frames = 0;
  for (const SheetTest* test : stage.tests) {
    const TestPart& part = tests.at(test);
    frames += static_cast<double>(part.frames.size()) / part.together;
  }
  return std::max(frames - static_cast<double>(unknowns), 1.0);
}

/// The tests of a stage by their share of the information on an unknown.
std::string told_by(const SheetStage& stage, const TestParts& tests, Eigen::Index unknown) {
  double all = 0;
  std::vector<std::pair<double, std::string>> shares;
  for (const SheetTest* test : stage.tests) {
    const TestPart& part = tests.at(test);
    if (part.information.size() == 0) continue;
    shares.emplace_back(part.information(unknown), test->name());
    all += part.information(unknown);
  }
  std::ranges::sort(shares, std::greater());
  std::string text;
  for (const auto& [share, name] : shares) {
    if (all <= 0 || share < 0.01 * all) continue;
    text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", name, 100 * share / all);
  }
  return text;
}

}  // namespace

SheetUncertainty sheet_uncertainty(const SheetFit& fit, const FitOptions& options,
                                   const RunContext& context) {
  SheetUncertainty result;
  const std::vector<const SheetStage*> stage_of = take_unknowns(fit, options, result);
  const Eigen::VectorXd unit = units_of(result);
  const Eigen::Index n = unit.size();

  std::map<const SheetTest*, Indices, ByName> unknowns_in;
  for (Eigen::Index u = 0; u < n; ++u) {
    const Unknown& unknown = result.unknowns[static_cast<std::size_t>(u)];
    for (const SheetTest* test : stage_of[static_cast<std::size_t>(u)]->tests) {
      if (unknown.of_material || unknown.owner == test->name()) unknowns_in[test].push_back(u);
    }
  }
  TestParts tests;
  Eigen::MatrixXd slope = Eigen::MatrixXd::Zero(n, n);
  for (const auto& [test, own] : unknowns_in) {
    const Indices places = places_in(*test, result.unknowns);
    TestPart& part =
        tests.emplace(test, part_of(*test, fit, own, places, unit, context)).first->second;
    for (const FramePart& frame : part.frames) slope += frame.slope;
    result.work += part.work;
  }

  const PriorPart priors = prior_part(result, unit, tests, stage_of);
  slope += priors.slope;
  const Indices known = known_unknowns(slope, tests, stage_of, result.unknowns);
  auto covariance = jackknife(slope, tests, known);
  result.covariance = Eigen::MatrixXd::Zero(n, n);
  result.determined = std::vector<char>(result.unknowns.size(), 0);
  if (covariance) {
    const Eigen::MatrixXd inverse = Eigen::MatrixXd(slope(known, known)).inverse();
    *covariance += inverse * Eigen::MatrixXd(priors.variance(known, known)) * inverse.transpose();
    const Eigen::VectorXd units = unit(known);
    result.covariance(known, known) = units.asDiagonal() * *covariance * units.asDiagonal();
    for (const Eigen::Index u : known) result.determined[static_cast<std::size_t>(u)] = 1;
  }

  result.degrees.resize(n);
  for (Eigen::Index u = 0; u < n; ++u) {
    const SheetStage* stage = stage_of[static_cast<std::size_t>(u)];
    result.degrees(u) = degrees_of(*stage, tests, std::ranges::count(stage_of, stage));
    result.told_by.push_back(told_by(*stage, tests, u));
  }
  return result;
}

}  // namespace pliant
