#include "pliant/report/strip_shapes_file.h"

#include <algorithm>
#include <cmath>

#include "pliant/base/errors.h"
#include "pliant/io/csv.h"
#include "pliant/report/numbers_or_none.h"

namespace pliant::report {
namespace {

std::vector<ShapeLine>& lines_of(StripShapes& shapes, const CsvTable& table, std::size_t row,
                                 const std::string& series) {
  if (series == "measured") return shapes.measured;
  if (series == "predicted") return shapes.predicted;
  if (series == "bent") return shapes.bent;
  throw InputError({table.file(), table.line(row), "series"}, "unknown " + quoted_value(series),
                   "measured, predicted or bent");
}

}  // namespace

std::vector<double> StripShapes::settings() const {
  std::vector<double> all;
  for (const ShapeLine& line : predicted) all.push_back(line.setting_mm);
  std::sort(all.begin(), all.end(), [](double a, double b) {
    return std::abs(a) != std::abs(b) ? std::abs(a) < std::abs(b) : a > b;
  });
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

StripShapes read_strip_shapes(const std::filesystem::path& file) {
  const CsvTable table = read_csv(file, CsvOptions{});
  StripShapes shapes;
  shapes.setting = table.has("radius_mm") ? "radius" : "overhang";
  const std::vector<std::string> series = table.texts("series"), profile = table.texts("profile");
  const std::vector<double> setting = table.numbers(shapes.setting + "_mm");
  struct Column {
    const char* name;
    std::vector<double> ShapeLine::*member;
  };
  constexpr Column kColumns[] = {{"arc_length_mm", &ShapeLine::arc_length_mm},
                                 {"x_mm", &ShapeLine::x_mm},
                                 {"y_mm", &ShapeLine::y_mm},
                                 {"curvature_1_per_m", &ShapeLine::curvature},
                                 {"moment_N", &ShapeLine::moment},
                                 {"distance_mm", &ShapeLine::distance_mm}};
  std::vector<std::vector<double>> numbers;
  for (const Column& column : kColumns) numbers.push_back(numbers_or_none(table, column.name));
  const std::vector<double> used = numbers_or_none(table, "used");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    std::vector<ShapeLine>& lines = lines_of(shapes, table, row, series[row]);
    const bool same = row > 0 && series[row] == series[row - 1] &&
                      setting[row] == setting[row - 1] && profile[row] == profile[row - 1];
    if (!same) lines.emplace_back().setting_mm = setting[row];
    ShapeLine& line = lines.back();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      (line.*kColumns[i].member).push_back(numbers[i][row]);
    }
    line.used.push_back(used[row] > 0 ? 1 : 0);
  }
  return shapes;
}

}  // namespace pliant::report
