#include "pliant/study/whole_sheet_files.h"

#include <algorithm>

#include "pliant/io/csv_writer.h"

namespace pliant {
namespace {

using Json = nlohmann::ordered_json;

std::string prediction_file(const WholeSheetResult& whole) {
  return "predictions/" + whole.info.name + ".csv";
}

std::string picture_file(const WholeSheetResult& whole) {
  return "pictures/" + whole.info.name + ".svg";
}

Json whole_sheet_json(const WholeSheetResult& whole) {
  const MeasuredQuantity& quantity = whole.info.quantity;
  const auto used = std::ranges::count(whole.info.used, 1);
  return {{"name", whole.info.name},
          {"type", whole.type},
          {"quantity", quantity.name},
          {"unit", quantity.unit},
          {"rms", quantity.per_si * whole.rms},
          {"points", used},
          {"specimens", whole.info.specimens.size()},
          {"excluded", whole.measured.size() - used},
          {"measured_mean", quantity.per_si * whole.measured.mean()},
          {"predicted_mean", quantity.per_si * whole.prediction.value.mean()},
          {"handled", whole.info.handled},
          {"told", whole.prediction.told},
          {"figures", whole.prediction.figures},
          {"prediction_file", prediction_file(whole)},
          {"picture_file",
           whole.prediction.picture.empty() ? Json(nullptr) : Json(picture_file(whole))}};
}

std::string rows_csv(const WholeSheetResult& whole) {
  const MeasuredQuantity& quantity = whole.info.quantity;
  std::vector<OwnColumn> columns = whole.info.columns;
  columns.insert(columns.end(), whole.prediction.columns.begin(), whole.prediction.columns.end());
  std::vector<std::string> header;
  for (const OwnColumn& column : columns) header.push_back(column.header);
  header.insert(header.end(), {"used", "measured_" + quantity.name, "predicted_" + quantity.name});
  CsvWriter csv(header);
  for (Eigen::Index i = 0; i < whole.measured.size(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    for (const OwnColumn& column : columns) csv.cell(column.cells[row]);
    csv.cell(whole.info.used[row] ? 1 : 0);
    csv.cell(quantity.per_si * whole.measured(i)).cell(quantity.per_si * whole.prediction.value(i));
    csv.end_row();
  }
  return csv.text();
}

}  // namespace

Json whole_sheets_json(const std::vector<WholeSheetResult>& results) {
  Json list = Json::array();
  for (const WholeSheetResult& whole : results) list.push_back(whole_sheet_json(whole));
  return list;
}

void add_files(const std::vector<WholeSheetResult>& results,
               std::vector<std::pair<std::string, std::string>>& files) {
  for (const WholeSheetResult& whole : results) {
    files.emplace_back(prediction_file(whole), rows_csv(whole));
    if (whole.prediction.picture.empty()) continue;
    files.emplace_back(picture_file(whole), whole.prediction.picture);
  }
}

}  // namespace pliant
