#include "apps/pliant/table_preview.h"

#include <fmt/format.h>

#include "pliant/exchange/tester_file.h"
#include "pliant/experiment/understood_columns.h"
#include "pliant/report/preview.h"

namespace pliant {
namespace {

/// A column in the unit in which it was written.
struct Drawn {
  report::QuantityLabel label;
  std::vector<double> values;
};

/// The first of these quantities that the table has; none where it has none of them.
std::optional<Drawn> first_of(const CsvTable& table, const UnderstoodColumns& columns,
                              std::initializer_list<const char*> names) {
  for (const std::string name : names) {
    for (const auto& [header, column] : columns) {
      if (column.quantity != name) continue;
      Drawn drawn{{name, column.unit}, table.quantity(name, column.dimension)};
      drawn.label.name.front() = static_cast<char>(drawn.label.name.front() - 'a' + 'A');
      const UnitConversion unit = *unit_conversion(column.unit, column.dimension);
      for (double& value : drawn.values) value = (value - unit.offset) / unit.scale;
      return drawn;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> table_preview(const std::filesystem::path& path,
                                         const CsvOptions& reading) {
  const TesterFile file = read_tester_file(path, reading);
  const CsvTable table = read_csv(path, file.csv);
  const UnderstoodColumns columns = understood_columns(table);
  const std::optional<Drawn> driver = first_of(
      table, columns, {"extension", "length", "strain", "angle", "curvature", "distance", "x"});
  const std::optional<Drawn> measured =
      first_of(table, columns, {"force", "moment", "weight", "y"});
  if (!driver || !measured) return std::nullopt;

  Preview preview;
  preview.title = path.filename().string();
  preview.facts = {{"Rows", fmt::format("{}", file.rows)},
                   {"Specimens", fmt::format("{}", file.specimens)}};
  if (file.passes) preview.facts.emplace_back("Ways to and fro", fmt::format("{}", *file.passes));
  for (const TesterFact& fact : file.facts) preview.facts.emplace_back(fact.field, fact.value);
  preview.driver = driver->label;
  preview.measured = measured->label;
  const std::vector<std::string> specimens =
      table.has("specimen") ? table.texts("specimen") : std::vector<std::string>(table.rows());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (row == 0 || specimens[row] != specimens[row - 1]) {
      preview.series.push_back({specimens[row], {}, {}});
    }
    preview.series.back().driver.push_back(driver->values[row]);
    preview.series.back().measured.push_back(measured->values[row]);
  }
  return preview_page(preview);
}

}  // namespace pliant
