#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

namespace pliant {

/// How well a model of some size meets the rows that all models are fitted to.
struct FittedModel {
  double rms = 0;             ///< of the weighted residuals (any unit, the same for all models)
  int parameters = 0;         ///< that the fit was free to choose, nuisance parameters included
  int placed = 0;             ///< of them control points whose places the data chose
  double effective_rows = 0;  ///< sum of rows / L, see below
};

/// Whether a richer model is worth its parameters: its rms is lower by 1 % ([T] 3.4.2) and
///
///     (n - p) log(rms_simple^2 / rms_rich^2) > log(n) (parameters more + points placed more / 2)
///
/// with n effective rows and p parameters of the richer fit. That is the Bayesian criterion
/// ([Schwarz1978]) with two changes. A control point whose place the data chose is worth more than
/// its value alone ([Friedman1991]); half a parameter more is what keeps noise from earning one
/// (docs/estimation.md has the rates). And n - p in place of n makes the gain that of an F test, so
/// that few rows do not look as if they told more.
///
/// Rows go together because of noise, and because a model too poor misses them all in one way. The
/// latter must not hide what a richer model would tell: take L from the residuals of the richest
/// fit at hand (a curve with the most points, evenly spaced and fitted linearly, will do), the same
/// for all fits of one growth.
/// @param accuracy  an rms below it is as good as any (in the unit of rms)
bool is_worth(const FittedModel& simple, const FittedModel& rich, double accuracy = 0);

/// By how much the left side above is larger than the right one: of richer models that with the
/// largest gain is worth most. Minus infinity where no rows are to spare.
double growth_gain(const FittedModel& simple, const FittedModel& rich);

/// Fits a model with so many control points; nothing where there is no such model or no fit.
using FitOfPoints = std::function<std::optional<FittedModel>(int points)>;

/// One model that was tried.
struct GrowthStep {
  int points = 0;
  FittedModel fit;
  bool accepted = false;
};

/// Why a growth has ended.
enum class GrowthEnd {
  not_worth_it,  ///< what was tried beyond it explains no more than chance does
  most,          ///< there may be no more, or there is no place for them
  accurate,      ///< its residuals are below the accuracy asked for
  no_fit,        ///< a richer model could not be fitted
};
std::string_view name_of(GrowthEnd end);

/// A model that has grown.
struct Growth {
  int points = 0;  ///< of the last accepted model; 0: not even the first was fitted
  GrowthEnd end = GrowthEnd::no_fit;
  std::vector<GrowthStep> steps;  ///< in the order they were fitted
};

/// Grows a model from `first` points to `most`, or until it is as good as any. One point more may
/// do nothing where two do (a curve that falls and rises again): growth ends only when neither one
/// nor two more are worth it.
/// @param fit_of    is called with rising numbers of points, each once
/// @param patience  how many points more are tried; 1 where a fit takes very long
Growth grow_model(int first, int most, const FitOfPoints& fit_of, double accuracy = 0,
                  int patience = 2);

}  // namespace pliant
