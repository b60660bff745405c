#include "apps/pliant/fit_models.h"

#include <algorithm>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/report/model_fits_report.h"
#include "pliant/report/report.h"
#include "pliant/study/model_fits.h"
#include "pliant/study/result_files.h"
#include "pliant/study/sheet_study.h"

#include "apps/pliant/run_facts.h"

namespace pliant {
namespace {

/// The table in the form of [T] Tables A.1-A.4: variants, in each the models, RMS of each session.
void say_table(const CommandContext& context, const ModelComparison& comparison) {
  const auto width = [](const ComparedSession& column) {
    return std::max<std::size_t>(column.name.size() + column.unit.size() + 3, 10);
  };
  std::string head = fmt::format("{:<22} {:<16}", "variant", "model");
  for (const ComparedSession& column : comparison.sessions) {
    head += fmt::format("{:>{}}", column.name + ", " + column.unit, width(column) + 1);
  }
  context.say(head + "  misfit");
  std::string variant;
  for (const ComparedFit& fit : comparison.fits) {
    std::string line =
        fmt::format("{:<22} {:<16}", fit.variant == variant ? "" : fit.variant, fit.model);
    variant = fit.variant;
    for (std::size_t i = 0; i < fit.errors.size(); ++i) {
      line += fmt::format("{:>{}.4g}", *fit.errors[i], width(comparison.sessions[i]) + 1);
    }
    context.say(line +
                (fit.misfit ? fmt::format("{:>6.2f} %", *fit.misfit) : "  failed: " + fit.failure));
  }
}

}  // namespace

std::string fit_models(const CommandContext& context, const Study& study,
                       const std::filesystem::path& study_file,
                       const std::vector<std::string>& models,
                       const std::vector<std::string>& variants, ResultDirectory& results) {
  if (!fits_sheets(study)) {
    throw InputError({study_file.string(), 0, "experiments"},
                     "has no session to be fitted, which is what cloth models are compared on",
                     "an experiment of the type session, or a fit without --models and --variants");
  }
  ModelFits fits{study.name, run_facts(context, study_file), {}, {}};
  fit_sheet_models(study, model_variants(models, variants), context.run, [&](const ModelFit& fit) {
    const std::string name = fit.combination.name();
    add_fit(fit, fits.comparison);
    if (!fit.failure.empty()) {
      context.run.progress.message(Level::warning, name + " failed: " + fit.failure);
      return;
    }
    for (const auto& [file, content] : fit_files(fit.result, fits.facts)) {
      results.write(name + "/" + file, content);
    }
    results.write(name + "/study.resolved.yaml",
                  resolved_study_text(fit.study, results.path() / name));
    results.write(name + "/report.html", make_report(results.staging() / name));
    context.say(fmt::format("{}: misfit {:.2f} %, {} parameters, {:.0f} s", name,
                            misfit_percent(fit.result.experiments), fit.result.parameters.size(),
                            fit.result.seconds));
  });
  fits.verdict = verdict(fits.comparison);
  results.write("summary.csv", summary_csv(fits.comparison));
  std::string summary = summary_json(fits);
  results.write("summary.json", summary);
  results.write("report.html", make_model_fits_report(results.staging()));
  say_table(context, fits.comparison);
  context.say(fmt::format("report: {}", (results.path() / "report.html").string()));
  return summary;
}

}  // namespace pliant
