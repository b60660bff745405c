#include "apps/pliant/summary.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/experiment/registry.h"
#include "pliant/experiment/strain_words.h"
#include "pliant/material/bending_strain.h"

namespace pliant {
namespace {

std::string uncertainty_text(const ParameterEstimate& p) {
  if (p.fixed) return "fixed";
  if (p.at_bound) return "at its bound";
  if (!p.identified) return "not determined";
  return fmt::format("+- {:.2g}", *p.std_error);
}

/// Of strips and sheets whose shapes are measured: there is no force, and bending has two sides.
std::string distance_text(const ExperimentResult& e) {
  std::string text = fmt::format("{:.3g} mm ({:.2f} % of length", e.rms * 1e3, e.rms_percent);
  if (e.elastic_rms) text += fmt::format("; best elastic curve: {:.3g} mm", *e.elastic_rms * 1e3);
  if (e.folds) text += fmt::format("; height of folds: {:.3g} mm", e.folds->height * 1e3);
  return text + ")";
}

std::string data_text(const ExperimentResult& e, MembraneMeasure measure) {
  if (e.sheet && e.quantity.kind == "distance") {
    const SessionSample& sample = e.sheet->measured.sample;
    const double way = e.strain_range.second * std::max(sample.width, sample.height);
    return fmt::format("{} {:.3g} mm", e.sheet->measured.table ? "overhang to" : "clips moved by",
                       way * 1e3);
  }
  if (e.quantity.kind == "distance") {
    const auto [low, high] = e.strain_range;
    return fmt::format("curvature to {:.3g} 1/m",
                       std::max(std::abs(low), std::abs(high)) / kStrainPerCurvature);
  }
  if (facts_of_test(e.type).has_unknown_zero) {
    return fmt::format("span {:.3g} mN, curvature to {:.3g} 1/m", e.peak_force * 1e3,
                       e.strain_range.second / kStrainPerCurvature);
  }
  if (e.sheet) {
    return fmt::format("peak {:.3g} N, strain to {:.3g}", e.peak_force, e.strain_range.second);
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
  if (e.quantity.kind == "length") text = fmt::format("{:.3g} mm", e.rms * 1e3);
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
    context.say(fmt::format("{:<32} {:>10.5g} {:<4} {}", p.name, p.value,
                            p.unit == "1" ? "" : p.unit, uncertainty_text(p)));
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
