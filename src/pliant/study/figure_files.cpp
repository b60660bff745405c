#include "pliant/study/figure_files.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pliant/experiment/textile_figure.h"
#include "pliant/io/csv_writer.h"

namespace pliant {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json usual_json(const TextileFigure& kind) {
  if (kind.usual_most == 0) return nullptr;
  return Json::array({kind.usual_least, kind.usual_most});
}

/// The value of a figure of the same name; NaN where there is none.
double value_of(const std::vector<LoopFigure>& figures, const std::string& name) {
  const auto found = std::ranges::find(figures, name, &LoopFigure::name);
  return found == figures.end() ? kNone : found->value;
}

/// Ends a row with what a standard says of a figure.
void end_with_kind(const TextileFigure& kind, CsvWriter& csv) {
  const bool usual = kind.usual_most > 0;
  csv.cell(std::string(kind.lab_unit)).cell(std::string(kind.standard));
  csv.cell(usual ? kind.usual_least : kNone).cell(usual ? kind.usual_most : kNone);
  csv.end_row();
}

}  // namespace

Json figure_json(const LabFigure& figure) {
  Json json{{"component", figure.component},
            {"name", figure.name},
            {"value", number_or_null(figure.value)},
            {"unit", figure.unit},
            {"at", figure.at ? Json(*figure.at) : Json(nullptr)},
            {"std_error", nullptr},
            {"lower", nullptr},
            {"upper", nullptr},
            {"beyond_range", figure.beyond_range},
            {"standard", nullptr},
            {"lab_value", nullptr},
            {"lab_unit", nullptr},
            {"usual", nullptr}};
  if (figure.error) {
    json["std_error"] = number_or_null(figure.error->std_error);
    json["lower"] = number_or_null(figure.value - figure.error->half_width);
    json["upper"] = number_or_null(figure.value + figure.error->half_width);
  }
  if (const TextileFigure* kind = find_textile_figure(figure.name)) {
    json["standard"] = kind->standard;
    json["lab_value"] = number_or_null(kind->per_si * figure.value);
    json["lab_unit"] = kind->lab_unit;
    json["usual"] = usual_json(*kind);
  }
  return json;
}

Json loop_figures_json(const ExperimentResult& experiment) {
  Json list = Json::array();
  for (const LoopFigure& figure : experiment.measured_figures) {
    const TextileFigure* kind = find_textile_figure(figure.name);
    if (!kind) continue;
    const double predicted = value_of(experiment.predicted_figures, figure.name);
    list.push_back({{"name", figure.name},
                    {"standard", kind->standard},
                    {"unit", kind->lab_unit},
                    {"measured", number_or_null(kind->per_si * figure.value)},
                    {"predicted", number_or_null(kind->per_si * predicted)},
                    {"usual", usual_json(*kind)}});
  }
  return list;
}

std::string figures_csv(const StudyResult& result) {
  const std::vector<std::string> header{"source",    "name",        "value",
                                        "std_error", "measured",    "unit",
                                        "standard",  "usual_least", "usual_most"};
  CsvWriter csv(header);
  for (const LabFigure& figure : result.figures) {
    const TextileFigure* kind = find_textile_figure(figure.name);
    if (!kind) continue;
    csv.cell(figure.component).cell(figure.name).cell(kind->per_si * figure.value);
    csv.cell(figure.error ? kind->per_si * figure.error->std_error : kNone).cell(kNone);
    end_with_kind(*kind, csv);
  }
  for (const ExperimentResult& experiment : result.experiments) {
    for (const LoopFigure& figure : experiment.measured_figures) {
      const TextileFigure* kind = find_textile_figure(figure.name);
      if (!kind) continue;
      const double predicted = value_of(experiment.predicted_figures, figure.name);
      csv.cell(experiment.name).cell(figure.name).cell(kind->per_si * predicted).cell(kNone);
      csv.cell(kind->per_si * figure.value);
      end_with_kind(*kind, csv);
    }
  }
  return csv.text();
}

}  // namespace pliant
