#include "pliant/report/report_data.h"

#include <algorithm>

#include "pliant/io/text_file.h"
#include "pliant/material/material_file.h"

namespace pliant::report {
namespace {

std::optional<SheetData> read_sheet(const std::filesystem::path& directory,
                                    const ResultExperiment& e) {
  if (!e.measures_sheets()) return std::nullopt;
  SheetData sheet;
  sheet.session = read_sheet_session(directory / e.sheet_folder);
  if (sheet.session.is_seen()) sheet.rms_distance = rms_distance(sheet.session);
  if (e.quantity == "force_N") {
    sheet.rms_clip_force = rms_clip_force(directory / e.prediction_file);
  }
  return sheet;
}

}  // namespace

bool ReportData::is_of_sheets() const {
  return !sheets.empty() &&
         std::ranges::all_of(sheets, [](const auto& sheet) { return sheet.has_value(); });
}

bool ReportData::is_of_strips() const {
  return is_of_sheets() &&
         std::ranges::none_of(sheets, [](const auto& sheet) { return sheet->session.is_seen(); });
}

ReportData read_report_data(const std::filesystem::path& directory) {
  ReportData data;
  data.results = read_results(directory);
  const std::filesystem::path curves = directory / "curves.csv";
  if (!data.results.evaluation || std::filesystem::exists(curves))
    data.curves = read_curves(curves);
  for (const ResultExperiment& experiment : data.results.experiments) {
    data.predictions.push_back(
        read_prediction(directory / experiment.prediction_file, experiment.quantity));
    data.sheets.push_back(read_sheet(directory, experiment));
    data.shapes.emplace_back();
    if (experiment.shape_file.empty()) continue;
    data.shapes.back() = read_strip_shapes(directory / experiment.shape_file);
  }
  for (const ResultWholeSheet& stated : data.results.whole_sheets) {
    data.whole_sheets.push_back({stated, {}});
    if (stated.picture_file.empty()) continue;
    data.whole_sheets.back().picture = read_text_file(directory / stated.picture_file);
  }
  const std::filesystem::path material = directory / "material.json";
  const bool any_sheet =
      std::ranges::any_of(data.sheets, [](const auto& sheet) { return sheet.has_value(); });
  if ((any_sheet || data.results.has_samples()) && std::filesystem::exists(material))
    data.material = read_material(material);
  return data;
}

}  // namespace pliant::report
