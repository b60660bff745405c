#include "apps/pliant/fit_models.h"

#include <algorithm>
#include <map>
#include <ranges>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/report/model_fits_report.h"
#include "pliant/report/report.h"
#include "pliant/study/model_fit_summary.h"
#include "pliant/study/result_files.h"
#include "pliant/study/sheet_model_fits.h"
#include "pliant/study/sheet_study.h"

#include "apps/pliant/run_facts.h"

namespace pliant {
namespace {

/// The table in the form of [T] Tables A.1-A.4: variants, in each the models, RMS of each session.
void say_table(const CommandContext& context, const std::vector<ModelFitSummary>& rows) {
  const std::vector<ModelFitSummary::Session> columns = compared_sessions(rows);
  const auto width = [](const ModelFitSummary::Session& column) {
    return std::max<std::size_t>(column.name.size() + column.unit.size() + 3, 10);
  };
  std::string head = fmt::format("{:<22} {:<16}", "variant", "model");
  for (const ModelFitSummary::Session& column : columns) {
    head += fmt::format("{:>{}}", column.name + ", " + column.unit, width(column) + 1);
  }
  context.say(head + "  misfit");
  std::string variant;
  for (const ModelFitSummary& row : rows) {
    const std::string& name = row.combination.variant.name;
    std::string line =
        fmt::format("{:<22} {:<16}", name == variant ? "" : name, row.combination.model.name);
    variant = name;
    for (std::size_t i = 0; i < row.sessions.size(); ++i) {
      line += fmt::format("{:>{}.4g}", row.sessions[i].rms, width(columns[i]) + 1);
    }
    context.say(line + (row.failure.empty() ? fmt::format("{:>6.2f} %", row.misfit)
                                            : "  failed: " + row.failure));
  }
}

/// Rows in the order of the thesis' tables.
std::vector<ModelFitSummary> in_table_order(const std::map<std::string, ModelFitSummary>& rows) {
  std::vector<ModelFitSummary> ordered;
  for (const SheetVariant& variant : sheet_variants()) {
    for (const SheetModel& model : sheet_models()) {
      const auto found = rows.find(ModelVariant{model, variant}.name());
      if (found != rows.end()) ordered.push_back(found->second);
    }
  }
  return ordered;
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
  const RunFacts facts = run_facts(context, study_file);
  std::map<std::string, ModelFitSummary> rows;
  fit_sheet_models(study, model_variants(models, variants), context.run, [&](const ModelFit& fit) {
    const std::string name = fit.combination.name();
    rows.emplace(name, summary_of(fit));
    if (!fit.failure.empty()) {
      context.run.progress.message(Level::warning, name + " failed: " + fit.failure);
      return;
    }
    for (const auto& [file, content] : fit_files(fit.result, facts)) {
      results.write(name + "/" + file, content);
    }
    results.write(name + "/study.resolved.yaml",
                  resolved_study_text(fit.study, results.path() / name));
    results.write(name + "/report.html", make_report(results.staging() / name));
    context.say(fmt::format("{}: misfit {:.2f} %, {} parameters, {:.0f} s", name,
                            misfit_percent(fit.result.experiments), fit.result.parameters.size(),
                            fit.result.seconds));
  });
  const std::vector<ModelFitSummary> ordered = in_table_order(rows);
  results.write("summary.csv", summary_csv(ordered));
  std::string summary = summary_json(study.name, ordered, facts);
  results.write("summary.json", summary);
  results.write("report.html", make_model_fits_report(results.staging()));
  say_table(context, ordered);
  context.say(fmt::format("report: {}", (results.path() / "report.html").string()));
  return summary;
}

}  // namespace pliant
