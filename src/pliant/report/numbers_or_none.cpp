#include "pliant/report/numbers_or_none.h"

#include <limits>

#include "pliant/base/errors.h"
#include "pliant/base/number_text.h"

namespace pliant::report {

std::vector<double> numbers_or_none(const CsvTable& table, const std::string& column) {
  const std::vector<std::string> cells = table.texts(column);
  std::vector<double> numbers;
  for (std::size_t row = 0; row < cells.size(); ++row) {
    const auto number =
        cells[row].empty() ? std::numeric_limits<double>::quiet_NaN() : parse_number(cells[row]);
    if (!number) {
      throw InputError({table.file(), table.line(row), column},
                       quoted_value(cells[row]) + " is not a number", "a number or nothing");
    }
    numbers.push_back(*number);
  }
  return numbers;
}

}  // namespace pliant::report
