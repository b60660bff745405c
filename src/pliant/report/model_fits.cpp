#include "pliant/report/model_fits.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pliant/io/json_object.h"

namespace pliant::report {
namespace {

struct ModelName {
  std::string_view model, title, in_sentence;
};
constexpr std::array<ModelName, 3> kModels = {
    {{"soft-constraint", "Soft constraints", "soft constraints"},
     {"stvk", "St. Venant-Kirchhoff", "St. Venant-Kirchhoff"},
     {"springs", "Springs", "springs"}}};

const ModelName* known(const std::string& model) {
  const auto* found = std::ranges::find(kModels, model, &ModelName::model);
  return found == kModels.end() ? nullptr : found;
}

/// `nonlinear-orthotropic` with something else between its words.
std::string joined_by(std::string_view between, std::string_view variant) {
  const std::size_t dash = variant.find('-');
  if (dash == std::string_view::npos) return std::string(variant);
  return fmt::format("{}{}{}", variant.substr(0, dash), between, variant.substr(dash + 1));
}

/// The errors of a row, in the order of the sessions, which are those of the first row with any.
void read_errors(const JsonObject& json, std::vector<ComparedSession>& sessions, ModelFitRow& row) {
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
    row.errors.push_back(e.number("rms"));
  }
}

ModelFitRow read_row(const JsonObject& json, std::vector<ComparedSession>& sessions) {
  ModelFitRow row;
  row.model = json.text("model");
  row.variant = json.text("variant");
  row.failure = json.text_or("failure", "");
  if (json.has("folder")) row.folder = json.relative_file_or("folder", "");
  row.converged = json.flag_or("converged", true);
  if (json.has("parameters")) row.parameters = json.integer_or("parameters", 0);
  row.seconds = json.number("seconds");
  row.misfit = json.number("misfit_percent");
  read_errors(json, sessions, row);
  return row;
}

}  // namespace

ModelFits read_model_fits(const std::filesystem::path& directory) {
  const std::filesystem::path file = directory / "summary.json";
  const nlohmann::json document = read_json_file(file);
  const JsonObject json(document, file.string(), "");
  const std::string type = json.text("pliant");
  if (type != "fits-of-models/1") {
    json.fail("pliant", "unknown document `" + type + "`", "fits-of-models/1");
  }
  ModelFits fits;
  fits.name = json.text_or("name", "unnamed");
  fits.command = json.text_or("command", "");
  fits.created = json.text_or("created", "");
  fits.version = json.text_or("version", "");
  fits.study = json.text_or("study", "");
  fits.study_sha256 = json.text_or("study_sha256", "");
  for (const JsonObject& row : json.objects("fits")) {
    fits.rows.push_back(read_row(row, fits.sessions));
  }
  for (ModelFitRow& row : fits.rows) row.errors.resize(fits.sessions.size());
  return fits;
}

std::string model_title(const std::string& model) {
  const ModelName* name = known(model);
  return name ? std::string(name->title) : model;
}

std::string variant_title(const std::string& variant) { return joined_by(", ", variant); }

std::string fit_title(const ModelFitRow& row) {
  const ModelName* name = known(row.model);
  return fmt::format("{} {}", joined_by(" ", row.variant), name ? name->in_sentence : row.model);
}

}  // namespace pliant::report
