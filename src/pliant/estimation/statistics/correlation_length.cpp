#include "pliant/estimation/statistics/correlation_length.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pliant {
namespace {

constexpr double kFewestSpareRows = 8;      // a correlation of fewer is noise
constexpr double kFewestEffectiveRows = 5;  // beside the unknowns, or no noise could be told
constexpr std::size_t kHighestOrder = 8;
constexpr std::size_t kRowsPerOrder = 6;
constexpr double kLargestTakenShare = 0.5;   // of the variance, by the fit
constexpr double kLargestReflection = 0.99;  // an autoregression beyond it is no noise
constexpr int kMostRounds = 20;
constexpr double kSettled = 0.01;

std::size_t rows_of(const std::vector<ResidualSeries>& series) {
  std::size_t rows = 0;
  for (const ResidualSeries& one : series) rows += one.size();
  return rows;
}

/// At lags 0, 1, ...: mean product of residuals that stand so many rows apart in one series, over
/// their mean square. Empty for residuals that are all zero.
std::vector<double> autocorrelations(const std::vector<ResidualSeries>& series, std::size_t lags) {
  std::vector<double> result;
  double mean_square = 0;
  for (std::size_t lag = 0; lag <= lags; ++lag) {
    double sum = 0;
    std::size_t pairs = 0;
    for (const ResidualSeries& one : series) {
      for (std::size_t i = lag; i < one.size(); ++i, ++pairs) sum += one[i] * one[i - lag];
    }
    if (pairs == 0) break;
    const double mean = sum / static_cast<double>(pairs);
    if (lag == 0) mean_square = mean;
    if (mean_square == 0) break;
    result.push_back(mean / mean_square);
  }
  return result;
}

/// Spectrum at frequency zero over the variance, of the autoregression with these autocorrelations
/// (Levinson's recursion) whose order has the least BIC.
double spectrum_at_zero(const std::vector<double>& correlation, double spare) {
  if (correlation[1] <= 0) return 1;  // neighbours do not go together
  std::vector<double> coefficients;
  double innovation = 1, least = 0, spectrum = 1;
  for (std::size_t order = 1; order < correlation.size(); ++order) {
    double reflection = correlation[order];
    for (std::size_t j = 0; j + 1 < order; ++j) {
      reflection -= coefficients[j] * correlation[order - 1 - j];
    }
    reflection = std::clamp(reflection / innovation, -kLargestReflection, kLargestReflection);
    std::vector<double> next(coefficients);
    for (std::size_t j = 0; j + 1 < order; ++j) next[j] -= reflection * coefficients[order - 2 - j];
    next.push_back(reflection);
    coefficients = next;
    innovation *= 1 - reflection * reflection;
    const double criterion =
        spare * std::log(innovation) + std::log(spare) * static_cast<double>(order);
    if (criterion >= least) continue;
    least = criterion;
    double gain = 1;
    for (const double coefficient : coefficients) gain -= coefficient;
    spectrum = innovation / (gain * gain);
  }
  return spectrum;
}

}  // namespace

double correlation_length(const std::vector<ResidualSeries>& series, double leverage) {
  const std::size_t rows = rows_of(series);
  const double spare = static_cast<double>(rows) - leverage;
  if (spare < kFewestSpareRows) return 1;
  const std::vector<double> seen =
      autocorrelations(series, std::min(kHighestOrder, rows / kRowsPerOrder));
  if (seen.size() < 2) return 1;
  const double longest =
      std::max(static_cast<double>(rows) / (leverage + kFewestEffectiveRows), 1.0);
  double length = 1;
  for (int round = 0; round < kMostRounds; ++round) {
    // An unknown takes L / rows of the variance, at all short lags alike.
    const double taken =
        std::min(leverage * length / static_cast<double>(rows), kLargestTakenShare);
    std::vector<double> correlation(seen);
    for (std::size_t lag = 1; lag < seen.size(); ++lag) {
      correlation[lag] = seen[lag] * (1 - taken) + taken;
    }
    const double next = std::clamp(spectrum_at_zero(correlation, spare), 1.0, longest);
    const bool settled = std::abs(next - length) < kSettled * length;
    length = next;
    if (settled) break;
  }
  return length;
}

}  // namespace pliant
