#include "pliant/report/report_data.h"

#include <nlohmann/json.hpp>

#include "pliant/base/errors.h"
#include "pliant/io/text_file.h"
#include "pliant/report/json_reader.h"

namespace pliant::report {
namespace {

/// An evaluation's material file may stand elsewhere; the report then leaves the measure unnamed.
std::string membrane_measure(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return {};
  const nlohmann::json document =
      nlohmann::json::parse(read_text_file(file), nullptr, /*allow_exceptions=*/false);
  if (document.is_discarded()) {
    throw InputError({file.string(), 0, {}}, "not valid JSON", "a material file");
  }
  return JsonReader(document, file.string(), "").text_or("membrane", "");
}

}  // namespace

ReportData read_report_data(const std::filesystem::path& directory) {
  ReportData data;
  data.results = read_results(directory);
  const std::filesystem::path curves = directory / "curves.csv";
  if (!data.results.evaluation || std::filesystem::exists(curves))
    data.curves = read_curves(curves);
  for (const ResultExperiment& experiment : data.results.experiments) {
    data.predictions.push_back(
        read_prediction(directory / experiment.prediction_file, experiment.quantity));
    data.shapes.emplace_back();
    if (experiment.shape_file.empty()) continue;
    data.shapes.back() = read_strip_shapes(directory / experiment.shape_file);
  }
  data.membrane = membrane_measure(directory / "material.json");
  return data;
}

}  // namespace pliant::report
