#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

/// Builds the text of a CSV file (commas, decimal points, LF) that read_csv reads back as it was.
class CsvWriter {
 public:
  explicit CsvWriter(std::span<const std::string> header);

  /// Adds a cell: the shortest text that reads back as the same number; NaN (no value) as an empty
  /// cell.
  CsvWriter& cell(double value);
  CsvWriter& cell(long value);
  CsvWriter& cell(int value) { return cell(static_cast<long>(value)); }
  CsvWriter& cell(std::string_view text);
  CsvWriter& cell(const char* text) { return cell(std::string_view(text)); }

  /// Ends a row, which must have as many cells as the header.
  void end_row();

  /// A whole row of numbers.
  void row(std::span<const double> values);

  const std::string& text() const { return text_; }

 private:
  void separate();

  std::size_t columns_;
  std::size_t cells_in_row_ = 0;
  std::string text_;
};

}  // namespace pliant
