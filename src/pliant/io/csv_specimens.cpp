#include "pliant/io/csv_specimens.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

namespace pliant {

void CsvSpecimens::begin(std::size_t first_row, const std::vector<std::string>& above) {
  const bool named = above.size() == 1;
  specimens_.push_back(
      {first_row, named ? above.front() : fmt::format("{}", specimens_.size() + 1)});
}

void CsvSpecimens::take_apart(const RepeatedColumns& groups, std::vector<std::string> above,
                              CsvTable& table) {
  const std::size_t width = table.columns_.size();
  const std::vector<CsvTable::Cell> side_by_side = std::move(table.cells_);
  const std::vector<int> lines = std::move(table.lines_);
  table.cells_.clear();
  table.lines_.clear();
  std::erase(above, "");
  const bool named = above.size() == groups.count;
  for (std::size_t group = 0; group < groups.count; ++group) {
    specimens_.push_back(
        {table.lines_.size(), named ? above[group] : fmt::format("{}", group + 1)});
    for (std::size_t row = 0; row < lines.size(); ++row) {
      const auto common = side_by_side.begin() + static_cast<std::ptrdiff_t>(row * width);
      const auto own = common + static_cast<std::ptrdiff_t>(groups.common + group * groups.size);
      const auto own_end = own + static_cast<std::ptrdiff_t>(groups.size);
      if (std::all_of(own, own_end, [](const auto& cell) { return cell.size == 0; })) continue;
      table.cells_.insert(table.cells_.end(), common,
                          common + static_cast<std::ptrdiff_t>(groups.common));
      table.cells_.insert(table.cells_.end(), own, own_end);
      table.lines_.push_back(lines[row]);
    }
  }
  table.columns_.resize(groups.common + groups.size);
}

void CsvSpecimens::add_column(CsvTable& table) const {
  const std::size_t width = table.columns_.size();
  const std::vector<CsvTable::Cell> cells = std::move(table.cells_);
  table.cells_.clear();
  table.columns_.push_back({"specimen", {}});
  for (std::size_t i = 0; i < specimens_.size(); ++i) {
    const std::string& word = specimens_[i].name;
    const CsvTable::Cell name{static_cast<std::uint32_t>(table.text_.size()),
                              static_cast<std::uint32_t>(word.size())};
    table.text_ += word;
    const std::size_t end =
        i + 1 < specimens_.size() ? specimens_[i + 1].first_row : table.lines_.size();
    for (std::size_t row = specimens_[i].first_row; row < end; ++row) {
      const auto first = cells.begin() + static_cast<std::ptrdiff_t>(row * width);
      table.cells_.insert(table.cells_.end(), first, first + static_cast<std::ptrdiff_t>(width));
      table.cells_.push_back(name);
    }
  }
}

}  // namespace pliant
