#include "pliant/estimation/solid/solid_growth.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "pliant/estimation/statistics/correlation_length.h"
#include "pliant/estimation/statistics/model_growth.h"
#include "pliant/math/tangent_spline.h"

namespace pliant {
namespace {

constexpr int kQuantiles = 8;
constexpr double kAccuracy = 1e-6;  // of a hundredth of the peak: as good as any
constexpr LeastSquaresOptions kLinear{
    .max_iterations = 60, .function_tolerance = 1e-9, .parameter_tolerance = 1e-9};

bool is_spline(const MaterialComponent& component) {
  return component.stiffness && component.stiffness->kind() == CurveKind::spline;
}

/// Places that control points may have: rest, the ends, and quantiles of either side.
std::vector<double> places_of(const MetricData& data, bool even) {
  std::vector<double> below, above;
  for (const double strain : data.strains) {
    (strain < 0 && !even ? below : above).push_back(std::abs(strain));
  }
  std::vector<double> places{0};
  const auto add = [&](std::vector<double>& strains, double sign) {
    std::ranges::sort(strains);
    for (int q = 1; q <= kQuantiles && !strains.empty(); ++q) {
      const auto rank = (strains.size() - 1) * static_cast<std::size_t>(q) / kQuantiles;
      places.push_back(sign * strains[rank]);
    }
  };
  add(below, -1);
  add(above, 1);
  std::ranges::sort(places);
  const double apart = 0.02 * data.scale.strain;
  std::vector<double> distinct;
  for (const double place : places) {
    if (distinct.empty() || place - distinct.back() > apart) distinct.push_back(place);
  }
  if (std::ranges::find(distinct, 0.0) != distinct.end()) return distinct;
  // Zero, which splines turn at, stands for what is near it.
  *std::ranges::min_element(distinct, {}, [](double x) { return std::abs(x); }) = 0;
  return distinct;
}

ScalarCurve with_knots(const ScalarCurve& curve, const std::vector<double>& knots) {
  std::vector<double> values;
  const Eigen::Map<const Eigen::VectorXd> own(curve.values().data(), curve.size());
  for (const double knot : knots) {
    values.push_back(spline_tangent_weights(curve.knots(), knot).dot(own));
  }
  return ScalarCurve::spline(knots, values, curve.even());
}

std::vector<double> with_place(std::vector<double> knots, double place) {
  knots.insert(std::ranges::lower_bound(knots, place), place);
  return knots;
}

/// The problem linearised about a material whose component has control points at all places; with
/// fewer points its values there are linear combinations of theirs.
class LinearisedSpline {
 public:
  LinearisedSpline(SolidProblem& problem, const Material& material, const std::string& component,
                   const std::vector<double>& places)
      : places_(places), spline_(*material.components.at(component).stiffness) {
    Material dense = material;
    std::vector<double> all = places;
    for (const double knot : spline_.knots()) {
      if (std::ranges::find(all, knot) == all.end()) all = with_place(all, knot);
    }
    places_ = all;
    dense.components.at(component).stiffness = with_knots(spline_, all);
    const Problem own = problem.problem(dense);
    unknowns_ = own.unknowns();
    at_ = starts_of(unknowns_);
    while (first_ < std::ssize(unknowns_) &&
           unknowns_[static_cast<std::size_t>(first_)].owner != component) {
      ++first_;
    }
    const LeastSquaresProblem squares = own.least_squares();
    residual_.setZero(squares.residuals);
    jacobian_.setZero(squares.residuals, at_.size());
    valid_ = squares.evaluate(at_, residual_, &jacobian_);
  }

  bool is_valid() const { return valid_; }

  /// Least cost of a spline with these control points, and its values.
  LeastSquaresSummary solve(const std::vector<double>& knots, const StopToken& stop) const {
    const Eigen::Index dense = std::ssize(places_), own = std::ssize(knots);
    const Eigen::Index others = at_.size() - dense;
    Eigen::MatrixXd dense_of = Eigen::MatrixXd::Zero(at_.size(), own + others);
    for (Eigen::Index i = 0; i < dense; ++i) {
      dense_of.block(first_ + i, 0, 1, own) =
          spline_tangent_weights(knots, places_[static_cast<std::size_t>(i)]).transpose();
    }
    LeastSquaresProblem problem;
    const ScalarCurve start = with_knots(spline_, knots);
    Eigen::VectorXd begin(own + others);
    begin.head(own) = Eigen::Map<const Eigen::VectorXd>(start.values().data(), own);
    problem.lower = problem.upper = problem.scale = begin;
    const auto bound = [&](Eigen::Index to, std::size_t from) {
      problem.lower(to) = unknowns_[from].lower;
      problem.upper(to) = unknowns_[from].upper;
      problem.scale(to) = unknowns_[from].scale;
    };
    for (Eigen::Index i = 0; i < own; ++i) bound(i, static_cast<std::size_t>(first_));
    Eigen::Index next = own;
    for (Eigen::Index u = 0; u < at_.size(); ++u) {
      if (u >= first_ && u < first_ + dense) continue;
      dense_of(u, next) = 1;
      begin(next) = at_(u);
      bound(next++, static_cast<std::size_t>(u));
    }
    const Eigen::MatrixXd slope = jacobian_ * dense_of;
    const Eigen::VectorXd offset = residual_ - jacobian_ * at_;
    problem.residuals = static_cast<int>(residual_.size());
    problem.evaluate = [&](const Eigen::VectorXd& p, Eigen::VectorXd& residual,
                           Eigen::MatrixXd* jacobian) {
      residual = offset + slope * p;
      if (jacobian) *jacobian = slope;
      return true;
    };
    return solve_least_squares(problem, begin, kLinear, stop);
  }

 private:
  std::vector<double> places_;
  ScalarCurve spline_;
  std::vector<Unknown> unknowns_;
  Eigen::VectorXd at_, residual_;
  Eigen::MatrixXd jacobian_;
  Eigen::Index first_ = 0;
  bool valid_ = false;
};

class SplineGrowth {
 public:
  SplineGrowth(SolidProblem& problem, const Material& material) : problem_(problem) {
    for (const auto& [name, component] : material.components) {
      if (!is_spline(component)) continue;
      places_[name] = places_of(problem.data_of(name), component.stiffness->even());
    }
  }

  int splines() const { return static_cast<int>(places_.size()); }

  /// The material with one control point more, fitted; nothing where there is no place for it.
  std::optional<Material> one_more(const Material& material, LeastSquaresSummary& solution) {
    std::optional<Material> best;
    double least = INFINITY;
    for (const auto& [name, places] : places_) {
      const LinearisedSpline linearised(problem_, material, name, places);
      if (!linearised.is_valid()) continue;
      const std::vector<double>& knots = material.components.at(name).stiffness->knots();
      for (const double place : places) {
        if (std::ranges::find(knots, place) != knots.end()) continue;
        const std::vector<double> more = with_place(knots, place);
        const LeastSquaresSummary end = linearised.solve(more, problem_.context().stop);
        if (!(end.cost < least)) continue;
        least = end.cost;
        best = material;
        const Eigen::VectorXd values = end.parameters.head(std::ssize(more));
        best->components.at(name).stiffness = ScalarCurve::spline(
            more, {values.begin(), values.end()}, material.components.at(name).stiffness->even());
      }
    }
    if (best) solution = problem_.solve(*best);
    return best;
  }

  /// Rows that are independent as far as noise goes: of the splines with all points.
  double effective_rows(const Material& material) {
    Material rich = material;
    for (const auto& [name, places] : places_) {
      rich.components.at(name).stiffness =
          with_knots(*material.components.at(name).stiffness, places);
    }
    problem_.solve(rich, kLinear);
    const Problem own = problem_.problem(rich);
    double rows = 0;
    for (std::size_t p = 0; p < own.parts().size(); ++p) {
      const Experiment& experiment = *own.parts()[p].experiment;
      const auto predicted = own.predict(p, starts_of(own.unknowns()), /*derivatives=*/false);
      const double counted = experiment.weights().sum();
      rows += predicted ? counted / length_of(experiment, predicted->value) : counted;
    }
    return rows;
  }

 private:
  static double length_of(const Experiment& experiment, const Eigen::VectorXd& predicted) {
    const Eigen::ArrayXd weights = experiment.weights();
    std::vector<ResidualSeries> series;
    for (const std::vector<int>& rows : experiment.series()) {
      ResidualSeries& own = series.emplace_back();
      for (const int row : rows) {
        if (weights(row) > 0) own.push_back(predicted(row) - experiment.measured()(row));
      }
    }
    return correlation_length(series, /*leverage=*/0);
  }

  SolidProblem& problem_;
  std::map<std::string, std::vector<double>> places_;
};

}  // namespace

GrownSolid grow_solid(SolidProblem& problem, const Material& material,
                      const LeastSquaresSummary& fitted) {
  GrownSolid result{material, fitted, {}};
  SplineGrowth growth(problem, material);
  if (growth.splines() == 0) return result;
  const int rows = problem.rows(), least = growth.splines();
  const double effective = growth.effective_rows(material);
  std::map<int, std::pair<Material, LeastSquaresSummary>> fits;
  const auto fit_of = [&](int points) -> std::optional<FittedModel> {
    if (points == least) {
      fits[points] = {material, fitted};
    } else {
      LeastSquaresSummary solution;
      const auto more = growth.one_more(fits.at(points - 1).first, solution);
      if (!more || !std::isfinite(solution.cost)) return std::nullopt;
      fits[points] = {*more, solution};
    }
    const auto& [own, end] = fits.at(points);
    const auto count = static_cast<int>(end.parameters.size());
    return FittedModel{rms_of(end, rows), count, points - least, effective};
  };
  const Growth chosen =
      grow_model(least, std::max(problem.options().control_points, least), fit_of, kAccuracy);
  for (const GrowthStep& step : chosen.steps) {
    result.stages.push_back({step.points, step.fit.rms, step.accepted});
  }
  const auto best = fits.find(chosen.points);
  if (best == fits.end()) return result;
  result.material = best->second.first;
  result.solution = best->second.second;
  return result;
}

}  // namespace pliant
