#include "pliant/study/model_fits.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pliant/io/csv_writer.h"
#include "pliant/io/json_object.h"
#include "pliant/study/sheet_study.h"

namespace pliant {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kModelFitsDocument = "fits-of-models/1";

Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

template <class Number>
Json or_null(const std::optional<Number>& number) {
  return number ? Json(*number) : Json(nullptr);
}

Json fit_json(const ComparedFit& fit, const std::vector<ComparedSession>& sessions) {
  Json json{{"model", fit.model},
            {"variant", fit.variant},
            {"folder", text_or_null(fit.folder)},
            {"failure", text_or_null(fit.failure)},
            {"converged", fit.converged},
            {"parameters", or_null(fit.parameters)},
            {"seconds", or_null(fit.seconds)},
            {"misfit_percent", or_null(fit.misfit)},
            {"experiments", Json::array()}};
  if (!fit.failure.empty()) return json;
  for (std::size_t s = 0; s < sessions.size(); ++s) {
    json["experiments"].push_back({{"name", sessions[s].name},
                                   {"role", sessions[s].validation ? "validate" : "fit"},
                                   {"rms", or_null(fit.error(s))},
                                   {"unit", sessions[s].unit}});
  }
  return json;
}

/// The errors of a fit, in the order of the sessions, which are those of the first fit with any.
void read_errors(const JsonObject& json, std::vector<ComparedSession>& sessions, ComparedFit& fit) {
  const std::vector<JsonObject> experiments = json.objects("experiments");
  if (experiments.empty()) return;
  const bool first = sessions.empty();
  if (!first && experiments.size() != sessions.size()) {
    json.fail("experiments", "not as many as in the fits before",
              fmt::format("{} experiments", sessions.size()));
  }
  for (std::size_t i = 0; i < experiments.size(); ++i) {
    const JsonObject& e = experiments[i];
    const std::string name = e.text("name");
    if (first) sessions.push_back({name, e.text("unit"), e.text_or("role", "fit") == "validate"});
    if (sessions[i].name != name) {
      e.fail("name", "another experiment than in the fits before", sessions[i].name);
    }
    fit.errors.push_back(e.number("rms"));
  }
}

ComparedFit read_fit(const JsonObject& json, std::vector<ComparedSession>& sessions) {
  ComparedFit fit;
  fit.model = json.text("model");
  fit.variant = json.text("variant");
  fit.failure = json.text_or("failure", "");
  fit.folder = json.relative_file_or("folder", "");
  fit.converged = json.flag_or("converged", true);
  if (json.has("parameters")) fit.parameters = json.integer_or("parameters", 0);
  fit.seconds = json.number("seconds");
  fit.misfit = json.number("misfit_percent");
  read_errors(json, sessions, fit);
  return fit;
}

/// Where a fit stands in [T] Tables A.1-A.4: by variant, in each by model.
auto place_in_tables(const ComparedFit& fit) {
  return std::pair(std::ranges::find(sheet_variants(), fit.variant, &SheetVariant::name),
                   std::ranges::find(sheet_models(), fit.model, &SheetModel::name));
}

}  // namespace

void add_fit(const ModelFit& fit, ModelComparison& comparison) {
  ComparedFit row;
  row.model = fit.combination.model.name;
  row.variant = fit.combination.variant.name;
  row.failure = fit.failure;
  if (fit.failure.empty()) {
    const std::vector<ExperimentResult>& experiments = fit.result.experiments;
    row.folder = fit.combination.name();
    row.converged = fit.result.converged;
    row.parameters = static_cast<int>(fit.result.parameters.size());
    row.seconds = fit.result.seconds;
    row.misfit = misfit_percent(experiments);
    comparison.sessions.clear();  // all fits have the same
    for (const ExperimentResult& e : experiments) {
      comparison.sessions.push_back({e.name, e.quantity.unit, e.role == ExperimentRole::validate});
      row.errors.emplace_back(e.quantity.per_si * e.rms);
    }
  }
  auto& fits = comparison.fits;
  fits.insert(std::ranges::upper_bound(fits, place_in_tables(row), {}, place_in_tables),
              std::move(row));
}

std::string summary_csv(const ModelComparison& comparison) {
  std::vector<std::string> header{"model", "variant"};
  for (const ComparedSession& session : comparison.sessions) {
    header.push_back(session.name + "_" + session.unit);
  }
  for (const char* name : {"misfit_percent", "parameters", "converged", "seconds", "failure"}) {
    header.emplace_back(name);
  }
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  CsvWriter csv(header);
  for (const ComparedFit& fit : comparison.fits) {
    csv.cell(fit.model).cell(fit.variant);
    for (std::size_t i = 0; i < comparison.sessions.size(); ++i) {
      csv.cell(fit.error(i).value_or(kNone));
    }
    csv.cell(fit.misfit.value_or(kNone)).cell(fit.parameters ? *fit.parameters : kNone);
    csv.cell(fit.failure.empty() ? fit.converged : kNone).cell(fit.seconds.value_or(kNone));
    csv.cell(fit.failure);
    csv.end_row();
  }
  return csv.text();
}

std::string summary_json(const ModelFits& fits) {
  Json json{{"pliant", kModelFitsDocument},
            {"name", fits.name},
            {"command", fits.facts.command},
            {"created", fits.facts.created},
            {"version", fits.facts.version},
            {"study", fits.facts.study},
            {"study_sha256", fits.facts.study_sha256},
            {"verdict", fits.verdict},
            {"fits", Json::array()}};
  for (const ComparedFit& fit : fits.comparison.fits) {
    json["fits"].push_back(fit_json(fit, fits.comparison.sessions));
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

ModelFits read_model_fits(const std::filesystem::path& directory) {
  const std::filesystem::path file = directory / "summary.json";
  const nlohmann::json document = read_json_file(file);
  const JsonObject json(document, file.string(), "");
  const std::string type = json.text("pliant");
  if (type != kModelFitsDocument) {
    json.fail("pliant", "unknown document `" + type + "`", kModelFitsDocument);
  }
  ModelFits fits;
  fits.name = json.text_or("name", "unnamed");
  fits.facts = {json.text_or("command", ""),      json.text_or("created", ""),
                json.text_or("version", ""),      json.text_or("study", ""),
                json.text_or("study_sha256", ""), ""};
  ModelComparison& comparison = fits.comparison;
  for (const JsonObject& fit : json.objects("fits")) {
    comparison.fits.push_back(read_fit(fit, comparison.sessions));
  }
  fits.verdict = json.has("verdict") ? json.text("verdict") : verdict(comparison);
  return fits;
}

}  // namespace pliant
