#include "apps/pliant/fit_models.h"

#include <algorithm>
#include <map>
#include <ranges>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pliant/base/errors.h"
#include "pliant/io/csv_writer.h"
#include "pliant/report/model_fits_report.h"
#include "pliant/report/report.h"
#include "pliant/study/result_files.h"
#include "pliant/study/sheet_model_fits.h"
#include "pliant/study/sheet_study.h"

#include "apps/pliant/run_facts.h"

namespace pliant {
namespace {

using Json = nlohmann::ordered_json;

/// How well one experiment is met.
struct SessionError {
  std::string name, role, unit;
  double rms = 0;  ///< in `unit`
};

/// What the summary says of one model in one variant.
struct Row {
  ModelVariant combination;
  std::string failure;
  bool converged = false;
  std::size_t parameters = 0;
  double seconds = 0, misfit = 0;  // misfit in per cent
  std::vector<SessionError> sessions;
};

Row row_of(const ModelFit& fit) {
  Row row;
  row.combination = fit.combination;
  row.failure = fit.failure;
  if (!fit.failure.empty()) return row;
  row.converged = fit.result.converged;
  row.parameters = fit.result.parameters.size();
  row.seconds = fit.result.seconds;
  row.misfit = misfit_percent(fit.result.experiments);
  for (const ExperimentResult& e : fit.result.experiments) {
    row.sessions.push_back({e.name, e.role == ExperimentRole::fit ? "fit" : "validate",
                            e.quantity.unit, e.quantity.per_si * e.rms});
  }
  return row;
}

/// The experiments of the fits that succeeded, which all have the same.
std::vector<SessionError> columns_of(const std::vector<Row>& rows) {
  for (const Row& row : rows) {
    if (row.failure.empty()) return row.sessions;
  }
  return {};
}

std::string summary_csv(const std::vector<Row>& rows) {
  std::vector<std::string> header{"model", "variant"};
  const std::vector<SessionError> columns = columns_of(rows);
  for (const SessionError& column : columns) header.push_back(column.name + "_" + column.unit);
  for (const char* name : {"misfit_percent", "parameters", "converged", "seconds", "failure"}) {
    header.emplace_back(name);
  }
  CsvWriter csv(header);
  for (const Row& row : rows) {
    csv.cell(row.combination.model.name).cell(row.combination.variant.name);
    if (row.failure.empty()) {
      for (const SessionError& session : row.sessions) csv.cell(session.rms);
      csv.cell(row.misfit).cell(static_cast<long>(row.parameters)).cell(row.converged ? 1 : 0);
      csv.cell(row.seconds);
    } else {
      for (std::size_t i = 0; i < columns.size() + 4; ++i) csv.cell("");
    }
    csv.cell(row.failure);
    csv.end_row();
  }
  return csv.text();
}

Json row_json(const Row& row) {
  const bool found = row.failure.empty();
  Json json{{"model", row.combination.model.name},
            {"variant", row.combination.variant.name},
            {"folder", found ? Json(row.combination.name()) : Json(nullptr)},
            {"failure", found ? Json(nullptr) : Json(row.failure)},
            {"converged", row.converged},
            {"parameters", found ? Json(row.parameters) : Json(nullptr)},
            {"seconds", found ? Json(row.seconds) : Json(nullptr)},
            {"misfit_percent", found ? Json(row.misfit) : Json(nullptr)}};
  json["experiments"] = Json::array();
  for (const SessionError& session : row.sessions) {
    json["experiments"].push_back({{"name", session.name},
                                   {"role", session.role},
                                   {"rms", session.rms},
                                   {"unit", session.unit}});
  }
  return json;
}

std::string summary_json(const Study& study, const std::vector<Row>& rows, const RunFacts& facts) {
  Json json{{"pliant", "fits-of-models/1"},      {"name", study.name},
            {"command", facts.command},          {"created", facts.created},
            {"version", facts.version},          {"study", facts.study},
            {"study_sha256", facts.study_sha256}};
  json["fits"] = Json::array();
  for (const Row& row : rows) json["fits"].push_back(row_json(row));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// The table in the form of [T] Tables A.1-A.4: variants, in each the models, RMS of each session.
void say_table(const CommandContext& context, const std::vector<Row>& rows) {
  const std::vector<SessionError> columns = columns_of(rows);
  const auto width = [](const SessionError& column) {
    return std::max<std::size_t>(column.name.size() + column.unit.size() + 3, 10);
  };
  std::string head = fmt::format("{:<22} {:<16}", "variant", "model");
  for (const SessionError& column : columns) {
    head += fmt::format("{:>{}}", column.name + ", " + column.unit, width(column) + 1);
  }
  context.say(head + "  misfit");
  std::string variant;
  for (const Row& row : rows) {
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
std::vector<Row> in_table_order(const std::map<std::string, Row>& rows) {
  std::vector<Row> ordered;
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
  std::map<std::string, Row> rows;
  fit_sheet_models(study, model_variants(models, variants), context.run, [&](const ModelFit& fit) {
    const std::string name = fit.combination.name();
    rows.emplace(name, row_of(fit));
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
  const std::vector<Row> ordered = in_table_order(rows);
  results.write("summary.csv", summary_csv(ordered));
  std::string summary = summary_json(study, ordered, facts);
  results.write("summary.json", summary);
  results.write("report.html", make_model_fits_report(results.staging()));
  say_table(context, ordered);
  context.say(fmt::format("report: {}", (results.path() / "report.html").string()));
  return summary;
}

}  // namespace pliant
