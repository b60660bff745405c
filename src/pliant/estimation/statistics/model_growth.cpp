#include "pliant/estimation/statistics/model_growth.h"

#include <cmath>
#include <limits>

namespace pliant {
namespace {

constexpr double kWorthwhileFall = 0.01;  // of the rms
// Parameters that the place of a control point counts for. The test of false growth holds with it,
// and would not with 0; with 1 a weak true bump is found half as often.
constexpr double kPlaceCost = 0.5;

}  // namespace

bool is_worth(const FittedModel& simple, const FittedModel& rich, double accuracy) {
  if (simple.rms <= accuracy || !(rich.rms < (1 - kWorthwhileFall) * simple.rms)) return false;
  return growth_gain(simple, rich) > 0;
}

double growth_gain(const FittedModel& simple, const FittedModel& rich) {
  const double rows = rich.effective_rows;
  const double spare = rows - rich.parameters;
  if (spare <= 0) return -std::numeric_limits<double>::infinity();
  const double cost =
      rich.parameters - simple.parameters + kPlaceCost * (rich.placed - simple.placed);
  return 2 * spare * std::log(simple.rms / rich.rms) - std::log(rows) * cost;
}

std::string_view name_of(GrowthEnd end) {
  switch (end) {
    case GrowthEnd::not_worth_it:
      return "more is not worth it";
    case GrowthEnd::most:
      return "as many as there may be";
    case GrowthEnd::accurate:
      return "accurate enough";
    case GrowthEnd::no_fit:
      return "no richer fit";
  }
  return "";
}

Growth grow_model(int first, int most, const FitOfPoints& fit_of, double accuracy, int patience) {
  Growth growth;
  const auto start = fit_of(first);
  if (!start) return growth;
  growth.points = first;
  growth.steps.push_back({first, *start, true});
  FittedModel accepted = *start;
  const auto goes_on = [&](int points) {
    return accepted.rms > accuracy && points <= most && points <= growth.points + patience;
  };
  for (int points = first + 1; goes_on(points); ++points) {
    const auto fit = fit_of(points);
    if (!fit) return growth;
    const bool worth = is_worth(accepted, *fit, accuracy);
    growth.steps.push_back({points, *fit, worth});
    if (!worth) continue;
    accepted = *fit;
    growth.points = points;
  }
  growth.end = growth.points >= most ? GrowthEnd::most : GrowthEnd::not_worth_it;
  if (accepted.rms <= accuracy) growth.end = GrowthEnd::accurate;
  return growth;
}

}  // namespace pliant
