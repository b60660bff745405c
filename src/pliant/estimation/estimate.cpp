#include "pliant/estimation/estimate.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pliant {
namespace {

constexpr double kTogether = 1.5;  // rows for each that counts: fewer are not worth a sentence

std::optional<double> if_finite(double value) {
  return std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

std::string source_text(NoiseSource source) {
  switch (source) {
    case NoiseSource::stated:
      return "stated in the study";
    case NoiseSource::residuals:
    case NoiseSource::few_residuals:
      return "estimated from the residuals";
    case NoiseSource::resolution:
      return "the instrument's resolution";
    case NoiseSource::other_experiments:
      return "assumed: that of the other experiments of its kind";
    case NoiseSource::measured_range:
      return "assumed: 1 % of the measured range";
  }
  return "";
}

// More than chance makes of as many rows. The standard errors count it as noise.
void warn_of_stated_noise(const ExperimentResult& row, double stated,
                          std::vector<std::string>& warnings) {
  constexpr double kNoticeable = 0.2, kDeviations = 3;
  const double chance = kDeviations / std::sqrt(2.0 * std::max(row.points, 1));
  const double times = row.rms / stated;
  if (times < 1 + std::max(kNoticeable, chance)) return;
  warnings.push_back(fmt::format(
      "the residuals of {} are {:.2g} times its stated noise: the law or the noise is not what it "
      "was taken for, and the standard errors are as much larger than the noise would have them",
      row.name, times));
}

void warn_of_outliers(const ExperimentResult& row, std::vector<std::string>& warnings) {
  constexpr std::size_t kListed = 5;
  if (row.outliers.empty()) return;
  std::vector<std::string> listed;
  for (std::size_t i = 0; i < std::min(kListed, row.outliers.size()); ++i) {
    listed.push_back(fmt::format("{} ({:+.1f})", row.outliers[i].row + 1, row.outliers[i].in_sd));
  }
  warnings.push_back(fmt::format(
      "{}: the fit leaves {} row{} by more than 5 standard deviations of its noise: row {}{}",
      row.name, row.outliers.size(), row.outliers.size() == 1 ? "" : "s", fmt::join(listed, ", "),
      row.outliers.size() > kListed ? ", ..." : ""));
}

}  // namespace

ParameterEstimate estimate_of(const std::vector<Unknown>& unknowns, const Eigen::VectorXd& values,
                              const Uncertainty& uncertainty, Eigen::Index i) {
  const auto index = static_cast<std::size_t>(i);
  const Unknown& unknown = unknowns[index];
  ParameterEstimate estimate;
  estimate.name = unknown.name;
  estimate.owner = unknown.owner;
  estimate.unit = unknown.unit;
  estimate.value = values(i);
  estimate.fixed = unknown.fixed;
  estimate.of_friction = unknown.of_friction;
  if (unknown.fixed) return estimate;
  estimate.at_bound = uncertainty.at_bound[index];
  estimate.determination = uncertainty.determination[index];
  estimate.identified = estimate.determination != Determination::none;
  estimate.told_by = uncertainty.told_by[index];
  estimate.std_error = if_finite(uncertainty.std_error(i));
  if (estimate.std_error) {
    estimate.lower = estimate.value - uncertainty.half_width(i);
    estimate.upper = estimate.value + uncertainty.half_width(i);
  }
  return estimate;
}

void take_noise(const Uncertainty& uncertainty, std::size_t part, ExperimentResult& row,
                StudyResult& result) {
  const ExperimentNoise& noise = uncertainty.noise.of[part];
  const Eigen::ArrayXd sd = uncertainty.noise.row_sd[part].array();
  const Eigen::ArrayXd counts = (uncertainty.noise.weight[part].array() > 0).cast<double>();
  row.noise = std::sqrt((counts * sd.square()).sum() / std::max(counts.sum(), 1.0));
  row.noise_source = source_text(noise.source);
  row.effective_rows = noise.effective_rows;
  if (noise.rows <= kTogether * noise.effective_rows) return;
  result.assumptions.push_back(
      fmt::format("{}: neighbouring residuals go together; its {:.0f} rows count as {:.0f}",
                  row.name, noise.rows, noise.effective_rows));
}

void doubt_rows(const Uncertainty& uncertainty, std::size_t part, ExperimentResult& row,
                std::vector<std::string>& warnings) {
  const ExperimentNoise& noise = uncertainty.noise.of[part];
  row.outliers = uncertainty.outliers[part];
  if (noise.is_assumed()) {
    warnings.push_back(fmt::format(
        "the {:.0f} rows of {} cannot tell its noise: it is {} ({:.3g} {}); state it under `noise`",
        noise.rows, row.name, source_text(noise.source), noise.sd * row.quantity.per_si,
        row.quantity.unit));
  }
  if (row.stated_noise) warn_of_stated_noise(row, *row.stated_noise, warnings);
  warn_of_outliers(row, warnings);
}

void warn_of_bounds(const std::vector<std::string>& names, StudyResult& result) {
  if (names.empty()) return;
  result.warnings.push_back(
      fmt::format("at their bounds, to where the data push them: {}", fmt::join(names, ", ")));
}

void warn_of_bounds(StudyResult& result) {
  std::vector<std::string> names;
  for (const auto* estimates : {&result.parameters, &result.nuisance}) {
    for (const ParameterEstimate& estimate : *estimates) {
      if (estimate.at_bound && !estimate.fixed) names.push_back(estimate.name);
    }
  }
  warn_of_bounds(names, result);
}

}  // namespace pliant
