#include "pliant/study/model_fit_summary.h"

#include <nlohmann/json.hpp>

#include "pliant/io/csv_writer.h"
#include "pliant/study/sheet_study.h"

namespace pliant {
namespace {

using Json = nlohmann::ordered_json;

Json row_json(const ModelFitSummary& row) {
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
  for (const ModelFitSummary::Session& session : row.sessions) {
    json["experiments"].push_back({{"name", session.name},
                                   {"role", session.role},
                                   {"rms", session.rms},
                                   {"unit", session.unit}});
  }
  return json;
}

}  // namespace

ModelFitSummary summary_of(const ModelFit& fit) {
  ModelFitSummary row;
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

std::vector<ModelFitSummary::Session> compared_sessions(const std::vector<ModelFitSummary>& rows) {
  for (const ModelFitSummary& row : rows) {
    if (row.failure.empty()) return row.sessions;
  }
  return {};
}

std::string summary_csv(const std::vector<ModelFitSummary>& rows) {
  std::vector<std::string> header{"model", "variant"};
  const std::vector<ModelFitSummary::Session> columns = compared_sessions(rows);
  for (const ModelFitSummary::Session& column : columns)
    header.push_back(column.name + "_" + column.unit);
  for (const char* name : {"misfit_percent", "parameters", "converged", "seconds", "failure"}) {
    header.emplace_back(name);
  }
  CsvWriter csv(header);
  for (const ModelFitSummary& row : rows) {
    csv.cell(row.combination.model.name).cell(row.combination.variant.name);
    if (row.failure.empty()) {
      for (const ModelFitSummary::Session& session : row.sessions) csv.cell(session.rms);
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

std::string summary_json(const std::string& name, const std::vector<ModelFitSummary>& rows,
                         const RunFacts& facts) {
  Json json{{"pliant", "fits-of-models/1"},      {"name", name},
            {"command", facts.command},          {"created", facts.created},
            {"version", facts.version},          {"study", facts.study},
            {"study_sha256", facts.study_sha256}};
  json["fits"] = Json::array();
  for (const ModelFitSummary& row : rows) json["fits"].push_back(row_json(row));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace pliant
