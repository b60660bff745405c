#include "pliant/report/prediction.h"

#include "pliant/base/errors.h"
#include "pliant/io/csv.h"
#include "pliant/report/numbers_or_none.h"

namespace pliant::report {
namespace {

Branch branch_named(const CsvTable& table, const std::filesystem::path& file, std::size_t row,
                    const std::string& name) {
  if (name == "load") return Branch::load;
  if (name == "unload") return Branch::unload;
  if (name == "rest") return Branch::rest;
  throw InputError({file.string(), table.line(row), "branch"}, "unknown branch `" + name + "`",
                   "load, unload or rest");
}

std::string driver_column(const CsvTable& table, std::string_view quantity) {
  if (quantity.starts_with("length")) {
    for (const char* name : {"weight_N", "weight_g", "force_N"}) {
      if (table.has(name)) return name;
    }
  }
  for (const char* name : {"angle_deg", "distance_mm", "area_mm2", "depth_mm"}) {
    if (table.has(name)) return name;
  }
  return "";
}

}  // namespace

Prediction read_prediction(const std::filesystem::path& file, std::string_view quantity) {
  const CsvTable table = read_csv(file, CsvOptions{});
  const std::string name(quantity);
  Prediction p;
  p.strain = table.numbers("strain");
  p.measured = table.numbers("measured_" + name);
  p.predicted = numbers_or_none(table, "predicted_" + name);
  p.specimen =
      table.has("specimen") ? table.texts("specimen") : std::vector<std::string>(table.rows(), "1");
  const std::vector<std::string> branches = table.texts("branch");
  const std::vector<double> used =
      table.has("used") ? table.numbers("used") : std::vector<double>(table.rows(), 1.0);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    p.branch.push_back(branch_named(table, file, row, branches[row]));
    p.used.push_back(used[row] != 0.0 ? 1 : 0);
  }
  if (table.has("elastic_" + name)) p.elastic = table.numbers("elastic_" + name);
  if (table.has("low_" + name) && table.has("high_" + name)) {
    p.low = table.numbers("low_" + name);
    p.high = table.numbers("high_" + name);
  }
  if (table.has("time_s")) p.time = table.numbers("time_s");
  p.driver_column = driver_column(table, quantity);
  if (!p.driver_column.empty()) p.driver = table.numbers(p.driver_column);
  return p;
}

}  // namespace pliant::report
