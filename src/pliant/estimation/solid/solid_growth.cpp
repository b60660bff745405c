#include "pliant/estimation/solid/solid_growth.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "pliant/estimation/solid/effective_rows.h"
#include "pliant/estimation/solid/linearised_problem.h"
#include "pliant/estimation/statistics/model_growth.h"
#include "pliant/math/tangent_spline.h"

namespace pliant {
namespace {

constexpr int kQuantiles = 8;
constexpr double kAccuracy = 1e-6;  // of a hundredth of the peak: as good as any

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

std::vector<double> with_places(std::vector<double> all, const std::vector<double>& more) {
  for (const double place : more) {
    if (std::ranges::find(all, place) == all.end()) all = with_place(all, place);
  }
  return all;
}

Material with_spline(Material material, const std::string& component, ScalarCurve spline) {
  material.components.at(component).stiffness = std::move(spline);
  return material;
}

/// The problem linearised about a material whose component has control points at all places; with
/// fewer points its values there are linear combinations of theirs.
class LinearisedSpline {
 public:
  LinearisedSpline(SolidProblem& problem, const Material& material, const std::string& component,
                   const std::vector<double>& places)
      : spline_(*material.components.at(component).stiffness),
        places_(with_places(places, spline_.knots())),
        problem_(problem, with_spline(material, component, with_knots(spline_, places_))) {
    while (first_ < problem_.unknowns().size() && problem_.unknowns()[first_].owner != component) {
      ++first_;
    }
  }

  bool is_valid() const { return problem_.is_valid(); }

  /// Least cost of a spline with these control points, and its values.
  LeastSquaresSummary solve(const std::vector<double>& knots, const StopToken& stop) const {
    const std::size_t all = problem_.unknowns().size(), dense = places_.size();
    const auto own = std::ssize(knots), few = own + static_cast<Eigen::Index>(all - dense);
    Eigen::MatrixXd combinations = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(all), few);
    for (std::size_t i = 0; i < dense; ++i) {
      combinations.block(static_cast<Eigen::Index>(first_ + i), 0, 1, own) =
          spline_tangent_weights(knots, places_[i]).transpose();
    }
    std::vector<std::size_t> alike(knots.size(), first_);
    const ScalarCurve start = with_knots(spline_, knots);
    Eigen::VectorXd begin(few);
    begin.head(own) = Eigen::Map<const Eigen::VectorXd>(start.values().data(), own);
    for (std::size_t u = 0; u < all; ++u) {
      if (u >= first_ && u < first_ + dense) continue;
      const auto next = std::ssize(alike);
      combinations(static_cast<Eigen::Index>(u), next) = 1;
      begin(next) = problem_.unknowns()[u].start;
      alike.push_back(u);
    }
    return problem_.solve(combinations, alike, begin, stop);
  }

 private:
  ScalarCurve spline_;
  std::vector<double> places_;
  LinearisedProblem problem_;
  std::size_t first_ = 0;
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

  /// The material with all control points that it may have.
  Material rich(Material material) const {
    for (const auto& [name, places] : places_) {
      ScalarCurve& own = *material.components.at(name).stiffness;
      own = with_knots(own, places);
    }
    return material;
  }

 private:
  SolidProblem& problem_;
  std::map<std::string, std::vector<double>> places_;
};

}  // namespace

GrownSolid grow_points(SolidProblem& problem, const GrownSolid& from, int first,
                       const Material& rich, const OneMorePoint& one_more) {
  GrownSolid result = from;
  const int rows = problem.rows();
  const double effective = effective_rows(problem, rich);
  std::map<int, std::pair<Material, LeastSquaresSummary>> fits;
  const auto fit_of = [&](int points) -> std::optional<FittedModel> {
    if (points == first) {
      fits[points] = {from.material, from.solution};
    } else {
      LeastSquaresSummary solution;
      const auto more = one_more(fits.at(points - 1).first, solution);
      if (!more || !std::isfinite(solution.cost)) return std::nullopt;
      fits[points] = {*more, solution};
    }
    const auto& [own, end] = fits.at(points);
    const auto count = static_cast<int>(end.parameters.size());
    return FittedModel{rms_of(end, rows), count, points - first, effective};
  };
  const Growth chosen =
      grow_model(first, std::max(problem.options().control_points, first), fit_of, kAccuracy);
  for (const GrowthStep& step : chosen.steps) {
    result.stages.push_back({step.points, step.fit.rms, step.accepted});
  }
  if (!chosen.steps.empty()) result.stages.back().end = chosen.end;
  const auto best = fits.find(chosen.points);
  if (best == fits.end()) return result;
  std::tie(result.material, result.solution) = best->second;
  return result;
}

GrownSolid grow_splines(SolidProblem& problem, const GrownSolid& from) {
  SplineGrowth growth(problem, from.material);
  if (growth.splines() == 0) return from;
  return grow_points(problem, from, growth.splines(), growth.rich(from.material),
                     [&](const Material& material, LeastSquaresSummary& solution) {
                       return growth.one_more(material, solution);
                     });
}

}  // namespace pliant
