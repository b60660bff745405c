#include "pliant/study/solid_results.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/number_text.h"
#include "pliant/estimation/component_curve.h"
#include "pliant/estimation/estimate.h"
#include "pliant/estimation/problem.h"
#include "pliant/estimation/sampled_numbers.h"
#include "pliant/experiment/stored_rows.h"

namespace pliant {
namespace {

/// Direction and specimen of each row.
void describe_rows(const Experiment& experiment, ExperimentResult& result) {
  const auto rows = static_cast<std::size_t>(experiment.rows());
  result.direction_of_row.assign(rows, 1);
  result.specimen_of_row.assign(rows, 0);
  for (const Frame& frame : experiment.frames()) {
    const double first = std::abs(result.strain[static_cast<std::size_t>(frame.first)]);
    const double last =
        std::abs(result.strain[static_cast<std::size_t>(frame.first + frame.count - 1)]);
    for (int i = frame.first; i < frame.first + frame.count; ++i) {
      result.direction_of_row[static_cast<std::size_t>(i)] = last < first ? -1 : 1;
      result.specimen_of_row[static_cast<std::size_t>(i)] = frame.specimen;
    }
  }
  result.unloads = std::ranges::find(result.direction_of_row, -1) != result.direction_of_row.end();
}

void measure_errors(const Experiment& experiment, ExperimentResult& result) {
  const Eigen::ArrayXd weights = experiment.weights(), measured = experiment.measured();
  const Eigen::ArrayXd off = result.predicted.array() - measured;
  const double rows = std::max(weights.sum(), 1.0);
  const double mean = (weights * measured).sum() / rows;
  result.rms = std::sqrt((weights * off.square()).sum() / rows);
  result.rms_percent = 100 * result.rms / experiment.reference();
  const double variance = (weights * (measured - mean).square()).sum();
  if (variance > 0) result.r_squared = 1 - (weights * off.square()).sum() / variance;
}

void warn_of_undetermined(const SolidFit& fit, StudyResult& result) {
  std::vector<std::string> at_bound;
  for (std::size_t i = 0; i < fit.unknowns.size(); ++i) {
    const Unknown& unknown = fit.unknowns[i];
    if (unknown.fixed) continue;
    if (fit.uncertainty.at_bound[i]) {
      // A convex energy that is linear somewhere has a control value of zero there.
      if (!unknown.strain) at_bound.push_back(unknown.name);
      result.undetermined.push_back(unknown.name + " (the data pushes it to its bound)");
    } else if (fit.uncertainty.determination[i] == Determination::none) {
      const bool interval = std::isfinite(fit.uncertainty.std_error(static_cast<Eigen::Index>(i)));
      result.undetermined.push_back(unknown.name + (interval ? " (its 95 % interval includes zero)"
                                                             : " (the data leaves it free)"));
    }
  }
  warn_of_bounds(at_bound, result);
}

}  // namespace

ExperimentResult compare_solid(const Experiment& experiment, const Material& material) {
  const ExperimentInfo& info = experiment.info();
  const auto predictor = experiment.predictor(material);
  StoredRows rows(experiment);
  if (!predictor->predict(predictor->values(), {}, {}, rows)) {
    throw SolverError("experiment " + info.name + ": with these numbers its equilibrium", 0, 0);
  }
  ExperimentResult result;
  result.name = info.name;
  result.type = info.type;
  result.role = info.role;
  result.quantity = info.quantity;
  result.measured = experiment.measured();
  result.predicted = rows.rows().value;
  result.peak_force = experiment.reference();
  result.points = static_cast<int>(std::ranges::count(info.used, 1));
  result.excluded = experiment.rows() - result.points;
  result.specimens = info.specimens;
  result.noise_source = "not used: predicted, not fitted";
  result.stated_noise = info.stated_noise();
  result.handled = info.handled;
  result.columns = info.columns;
  result.time = info.time;
  result.used = info.used;
  result.strain = experiment.imposed();
  if (result.strain.empty()) {
    result.strain = predictor->strains("fibre.x", predictor->values(), {});
  }
  const auto [low, high] = std::ranges::minmax(result.strain);
  result.strain_range = {low, high};
  describe_rows(experiment, result);
  measure_errors(experiment, result);
  std::ranges::move(experiment.differences(result.predicted), std::back_inserter(result.handled));
  result.noise = result.rms;
  return result;
}

void add_band(const SolidFit& fit, const Experiment& experiment, const RunContext& context,
              ExperimentResult& result) {
  const auto unknown = [&](const char* why) {
    result.handled.push_back(
        std::string("how far the prediction may be off the data do not tell: it ") + why);
  };
  std::vector<ProblemPart> parts;
  parts.push_back({&experiment, experiment.predictor(fit.material)});
  const Problem problem(std::move(parts), fit.unknowns, {context.threads, context.stop});
  const auto rows = problem.predict(0, fit.values, /*derivatives=*/true);
  if (!rows) return unknown("has no derivatives there");
  Eigen::ArrayXd half(rows->value.size());
  for (Eigen::Index i = 0; i < half.size(); ++i) {
    const auto error = fit.uncertainty.error_of(rows->by.row(i));
    if (!error) return unknown("depends on numbers that they do not determine");
    half(i) = error->half_width;
  }
  const auto inside = ((rows->value - experiment.measured()).array().abs() <= half).cast<double>();
  const double percent = 100 / result.peak_force;
  result.handled.push_back(fmt::format(
      "the 95 % band of the prediction, by the errors of the fitted numbers, is +- {:.3g} % of the "
      "peak (root mean square), {:.3g} % at most; {:.0f} % of the rows lie in it",
      percent * std::sqrt(half.square().mean()), percent * half.maxCoeff(), 100 * inside.mean()));
  result.half_band = half.matrix();
}

void add_solid_curves(const Material& material, const SolidFit* fit, StudyResult& result) {
  Eigen::Index first = 0;
  for (const std::string& name : ordered_components(material.components, material.kind)) {
    const auto law = law_of(material, name);
    if (!law) continue;
    const auto& range = material.components.at(name).range;
    const int copies = copies_of(material, name);  // of samples the curve is the mean
    const ErrorOfLaw errors =
        fit && copies == 1 ? errors_of_law(fit->uncertainty, first) : ErrorOfLaw{};
    if (range && range->second > 0) {
      result.curves.push_back(component_curve(name, *law, range->second, errors));
    }
    first += copies * law->parameter_count();
  }
}

void add_solid_fit(const SolidFit& fit, StudyResult& result) {
  for (Eigen::Index i = 0; i < fit.values.size(); ++i) {
    ParameterEstimate estimate = estimate_of(fit.unknowns, fit.values, fit.uncertainty, i);
    if (fit.mesh_error.size() > 0 && !estimate.fixed) {
      estimate.note +=
          fmt::format("{:.2g} of the error by the mesh; ", std::abs(fit.mesh_error(i)));
    }
    const auto& strain = fit.unknowns[static_cast<std::size_t>(i)].strain;
    if (strain) estimate.note = "at a strain of " + format_number(*strain, 4);
    result.parameters.push_back(std::move(estimate));
  }
  result.material = fit.material;
  result.covariance = fit.uncertainty.covariance;
  result.singular_values["solid"] = fit.uncertainty.singular_values;
  result.converged = fit.converged;
  if (!fit.converged) {
    result.warnings.push_back(fmt::format(
        "the fit did not converge: its search stopped after {} iterations", fit.iterations));
  }
  std::ranges::copy(fit.stages, std::back_inserter(result.stages));
  std::ranges::copy(fit.questions, std::back_inserter(result.questions));
  std::ranges::copy(fit.notes, std::back_inserter(result.warnings));
  add_starts(fit.starts, result);
  warn_of_undetermined(fit, result);
  add_solid_curves(fit.material, &fit, result);
}

}  // namespace pliant
