#include "apps/pliant/summary.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/number_text.h"
#include "pliant/base/number_with_error.h"
#include "pliant/base/quantity.h"
#include "pliant/experiment/registry.h"
#include "pliant/experiment/strain_words.h"
#include "pliant/material/bending_strain.h"
#include "pliant/report/readable_unit.h"

namespace pliant {
namespace {

/// "3640 +- 170 N/m" in a unit in which it reads well; without an error that would make it look
/// known.
std::string value_text(const ParameterEstimate& p) {
  const bool uncertain = !p.fixed && !p.at_bound && p.identified && p.std_error.value_or(0) > 0;
  const report::ReadableUnit unit = report::readable_unit(p.unit, std::abs(p.value));
  const double value = unit.factor * p.value;
  std::string text =
      uncertain ? number_with_error(value, unit.factor * *p.std_error) : format_number(value, 3);
  if (p.unit != "1") text += " " + unit.name;
  if (p.fixed) return text + ", fixed";
  if (p.at_bound) return text + ", at its bound";
  return p.identified ? text : text + ", not determined";
}

/// How far a sheet was moved or stretched, in the terms of its test.
std::string way_text(const ExperimentResult& e) {
  const Session& measured = e.sheet->measured;
  if (measured.kind == SessionKind::strip) {
    return fmt::format("extension to {:.3g} %", 100 * e.strain_range.second);
  }
  const double way =
      e.strain_range.second * std::max(measured.sample.width, measured.sample.height);
  return fmt::format("{} {:.3g} mm", measured.table ? "overhang to" : "clips moved by", way * 1e3);
}

/// Of strips and sheets whose shapes are measured: there is no force, and bending has two sides.
std::string distance_text(const ExperimentResult& e) {
  std::string text = fmt::format("{:.3g} mm ({:.2f} % of length", e.rms * 1e3, e.rms_percent);
  if (e.elastic_rms) text += fmt::format("; best elastic curve: {:.3g} mm", *e.elastic_rms * 1e3);
  if (e.folds) text += fmt::format("; height of folds: {:.3g} mm", e.folds->height * 1e3);
  return text + ")";
}

std::string data_text(const ExperimentResult& e, MembraneMeasure measure) {
  if (e.sheet && e.quantity.kind == "distance") return way_text(e);
  if (e.quantity.kind == "distance") {
    const auto [low, high] = e.strain_range;
    return fmt::format("curvature to {:.3g} 1/m",
                       std::max(std::abs(low), std::abs(high)) / kStrainPerCurvature);
  }
  if (facts_of_test(e.type).has_unknown_zero) {
    return fmt::format("span {:.3g} mN, curvature to {:.3g} 1/m", e.peak_force * 1e3,
                       e.strain_range.second / kStrainPerCurvature);
  }
  if (e.sheet) return fmt::format("peak {:.3g} N, {}", e.peak_force, way_text(e));
  if (e.quantity.kind == "stress") {
    return fmt::format("peak {}, stretches {:.3g} to {:.3g}",
                       format_quantity(e.peak_force, Dimension::stress, 3),
                       1 + e.strain_range.first, 1 + e.strain_range.second);
  }
  if (e.quantity.kind == "reading") return "forces and positions";
  if (is_contraction(e.component)) {
    return fmt::format("narrower by {:.3g} mm, {} at most", e.peak_force * 1e3,
                       strain_in_words(e.component, e.strain_range.second, measure));
  }
  return fmt::format("peak {:.3g} {}, {} at most", e.peak_force,
                     e.quantity.kind == "force per width" ? "N/m" : "N",
                     strain_in_words(e.component, e.strain_range.second, measure));
}

std::string error_text(const ExperimentResult& e) {
  if (e.quantity.kind == "distance") return distance_text(e);
  std::string text = fmt::format("{:.2f} % of peak", e.rms_percent);
  if (facts_of_test(e.type).has_unknown_zero) {
    text = fmt::format("{:.2g} mN, {:.2f} % of span", e.rms * 1e3, e.rms_percent);
    if (e.noise_floor) text += fmt::format(", rows scatter by {:.2g} mN", *e.noise_floor * 1e3);
  }
  if (e.r_squared) text += fmt::format(", R^2 {:.4f}", *e.r_squared);
  if (e.quantity.kind == "length") text = fmt::format("{:.3g} mm", e.rms * 1e3);
  if (e.quantity.kind == "reading") {
    text =
        fmt::format("{:.3g} times the stated noise, {:.2f} % of the largest", e.rms, e.rms_percent);
  }
  if (e.elastic_percent && e.quantity.kind != "length") {
    text += fmt::format(" (best elastic curve: {:.2f} %)", *e.elastic_percent);
  }
  return text;
}

}  // namespace

void say_experiments(const CommandContext& context, const StudyResult& result) {
  for (const ExperimentResult& e : result.experiments) {
    context.say(fmt::format("{:<24} {:<9} {} rows, {}: error {}", e.name,
                            e.role == ExperimentRole::fit ? "fitted" : "predicted", e.points,
                            data_text(e, result.material.membrane), error_text(e)));
  }
  for (const WholeSheetResult& whole : result.whole_sheets) {
    const MeasuredQuantity& quantity = whole.info.quantity;
    context.say(fmt::format("{:<24} {:<9} {} rows, {}: measured {:.3g} {}, predicted {:.3g} {}",
                            whole.info.name, "predicted", whole.measured.size(), quantity.kind,
                            quantity.per_si * whole.measured.mean(), quantity.unit,
                            quantity.per_si * whole.prediction.value.mean(), quantity.unit));
    for (const std::string& told : whole.prediction.told) context.say("  " + told);
  }
  for (const SkippedExperiment& e : result.skipped) {
    context.run.progress.message(Level::warning,
                                 fmt::format("{}: not predicted, the material has no {}", e.name,
                                             fmt::join(e.missing, ", ")));
  }
  for (const auto* sentences : {&result.questions, &result.warnings}) {
    for (const std::string& warning : *sentences) {
      context.run.progress.message(Level::warning, warning);
    }
  }
  context.say(result.judgement.headline);
  for (const CriterionJudgement& criterion : result.judgement.criteria) {
    context.say("  " + criterion.text());
  }
}

void say_fit(const CommandContext& context, const StudyResult& result) {
  say_experiments(context, result);
  for (const ParameterEstimate& p : result.parameters) {
    context.say(fmt::format("{:<32} {}", p.name, value_text(p)));
  }
  for (const ModelRank& m : result.models) {
    context.say(fmt::format("{:<14} {:<32} {:.2f} % of peak, {} parameters, BIC {:+.1f}",
                            m.component, m.name, m.rms_percent, m.parameters, m.delta_bic));
  }
  for (const Profile& p : result.profiles) {
    const auto end = [](const std::optional<double>& value) {
      return value ? fmt::format("{:.4g}", *value) : std::string("open");
    };
    context.say(fmt::format("{:<32} 95 % interval by its profile: {} to {} {}", p.parameter,
                            end(p.lower), end(p.upper), p.unit == "1" ? "" : p.unit));
  }
  for (const std::string& what : result.undetermined) {
    context.run.progress.message(Level::warning, "not determined by the data: " + what);
  }
}

}  // namespace pliant
