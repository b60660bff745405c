#include "pliant/io/csv_writer.h"

#include <cmath>

#include "pliant/base/assert.h"
#include "pliant/base/number_text.h"

namespace pliant {
namespace {

/// Whether the reader would take the bare text for something else: cells, a comment, no row at all,
/// or text with fewer blanks.
bool needs_quotes(std::string_view text) {
  return text.find_first_of(",;\"\r\n\t") != std::string_view::npos || text.starts_with('#') ||
         text != trimmed(text);
}

}  // namespace

CsvWriter::CsvWriter(std::span<const std::string> header) : columns_(header.size()) {
  PLIANT_ASSERT(columns_ > 0, "a table has columns");
  for (const std::string& name : header) cell(name);
  end_row();
}

CsvWriter& CsvWriter::cell(double value) {
  separate();
  if (!std::isnan(value)) text_ += format_number(value);
  return *this;
}

CsvWriter& CsvWriter::cell(long value) {
  separate();
  text_ += std::to_string(value);
  return *this;
}

CsvWriter& CsvWriter::cell(std::string_view text) {
  separate();
  if (!needs_quotes(text)) {
    text_ += text;
    return *this;
  }
  text_ += '"';
  for (const char character : text) {
    if (character == '"') text_ += '"';
    text_ += character;
  }
  text_ += '"';
  return *this;
}

void CsvWriter::end_row() {
  PLIANT_ASSERT(cells_in_row_ == columns_, "a row has as many cells as the header");
  text_ += '\n';
  cells_in_row_ = 0;
}

void CsvWriter::row(std::span<const double> values) {
  for (const double value : values) cell(value);
  end_row();
}

void CsvWriter::separate() {
  if (cells_in_row_++ > 0) text_ += ',';
}

}  // namespace pliant
