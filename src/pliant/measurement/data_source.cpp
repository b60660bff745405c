#include "pliant/measurement/data_source.h"

#include <algorithm>
#include <map>
#include <set>

#include "pliant/base/name_order.h"
#include "pliant/base/name_pattern.h"
#include "pliant/measurement/column_synonyms.h"

namespace pliant {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> matching_files(const fs::path& folder, const std::string& pattern) {
  std::vector<fs::path> files;
  const fs::path directory = (folder / pattern).parent_path();
  const std::string name_pattern = fs::path(pattern).filename().string();
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(directory.empty() ? "." : directory, error)) {
    const std::string name = entry.path().filename().string();
    if (name[0] != '.' && matches(name_pattern, name)) files.push_back(directory / name);
  }
  std::ranges::sort(files, [](const fs::path& one, const fs::path& other) {
    return comes_before(one.filename().string(), other.filename().string());
  });
  return files;
}

std::vector<fs::path> find_files(const Value& value, const std::string& written) {
  const fs::path folder = fs::path(value.location().file).parent_path();
  if (written.find('*') == std::string::npos) return {folder / written};
  std::vector<fs::path> files = matching_files(folder, written);
  if (files.empty())
    value.fail(quoted_value(written) + " matches no file", "an existing file or pattern");
  return files;
}

int row_count(const CsvTable& table) { return static_cast<int>(table.rows()); }

// Runs of equal values in the column `specimen`.
std::vector<SpecimenRows> specimens_of_column(const CsvTable& table, int first) {
  const std::vector<std::string> names = table.texts("specimen");
  std::vector<SpecimenRows> specimens;
  std::set<std::string> seen;
  for (int i = 0; i < row_count(table); ++i) {
    const std::string& name = names[static_cast<size_t>(i)];
    if (!specimens.empty() && name == specimens.back().name) {
      ++specimens.back().count;
      continue;
    }
    if (!seen.insert(name).second) {
      throw InputError({table.file(), table.line(static_cast<size_t>(i)), "specimen"},
                       "specimen " + quoted_value(name) + " comes a second time",
                       "the rows of a specimen one after the other, as measured");
    }
    specimens.push_back({name, first + i, 1});
  }
  return specimens;
}

}  // namespace

bool names_column_numbers(const std::map<std::string, std::string>& columns) {
  return std::ranges::any_of(columns, [](const auto& column) {
    return !column.second.empty() && column.second[0] >= '0' && column.second[0] <= '9';
  });
}

DataSource read_data_source(const Value& value) {
  DataSource source;
  source.where = value.location();
  source.csv.synonyms = column_synonyms();
  if (!value.is_mapping()) {
    source.written = value.text("a CSV file, a pattern of files, or a mapping with `file`");
    source.files = find_files(value, source.written);
    return source;
  }
  Fields fields = value.fields();
  const Value file = fields.require("file");
  source.written = file.text();
  source.files = find_files(file, source.written);
  if (auto v = fields.optional("encoding")) source.csv.encoding = v->text();
  if (auto v = fields.optional("skip_rows")) source.csv.skip_rows = v->integer(0, 100000);
  if (auto v = fields.optional("sheet")) source.csv.sheet = v->text();
  if (auto v = fields.optional("columns")) {
    Fields columns = v->fields();
    for (auto& [name, header] : columns.all()) source.csv.columns[name] = header.text();
  }
  source.csv.numbered_columns = names_column_numbers(source.csv.columns);
  fields.finish();
  return source;
}

DataRows::DataRows(const DataSource& source) {
  for (const fs::path& file : source.files) {
    if (!fs::exists(file)) {
      throw InputError(source.where, "the file " + quoted_value(file.string()) + " does not exist",
                       "a data file, relative to the study");
    }
    tables_.push_back(read_csv(file, source.csv));
    rows_ += static_cast<int>(tables_.back().rows());
  }
}

template <class Read>
auto DataRows::gather(Read read) const {
  decltype(read(tables_.front())) all;
  for (const CsvTable& table : tables_) {
    const auto part = read(table);
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

std::vector<double> DataRows::quantity(std::string_view name, Dimension dimension) const {
  return gather([&](const CsvTable& table) { return table.quantity(name, dimension); });
}

std::optional<std::vector<double>> DataRows::optional_quantity(std::string_view name,
                                                               Dimension dimension) const {
  const bool somewhere = std::any_of(tables_.begin(), tables_.end(), [&](const CsvTable& table) {
    return table.quantity_column(name, dimension).has_value();
  });
  if (!somewhere) return std::nullopt;
  return quantity(name, dimension);
}

std::string DataRows::quantity_unit(std::string_view name) const {
  return tables_.front().quantity_unit(name).value_or("");
}

std::optional<std::vector<long>> DataRows::optional_integers(std::string_view name) const {
  const bool somewhere = std::any_of(tables_.begin(), tables_.end(),
                                     [&](const CsvTable& table) { return table.has(name); });
  if (!somewhere) return std::nullopt;
  return gather([&](const CsvTable& table) { return table.integers(name); });
}

std::optional<std::vector<std::string>> DataRows::optional_texts(std::string_view name) const {
  const bool somewhere = std::any_of(tables_.begin(), tables_.end(),
                                     [&](const CsvTable& table) { return table.has(name); });
  if (!somewhere) return std::nullopt;
  return gather([&](const CsvTable& table) { return table.texts(name); });
}

std::vector<SpecimenRows> DataRows::specimens() const {
  std::vector<SpecimenRows> specimens;
  std::map<std::string, int> times;
  int first = 0;
  for (const CsvTable& table : tables_) {
    const std::string file = fs::path(table.file()).stem().string();
    const std::vector<SpecimenRows> own =
        table.has("specimen") ? specimens_of_column(table, first)
                              : std::vector<SpecimenRows>{{file, first, row_count(table)}};
    for (const SpecimenRows& specimen : own) ++times[specimen.name];
    specimens.insert(specimens.end(), own.begin(), own.end());
    first += row_count(table);
  }
  // Files that number their specimens alike: the file's name tells them apart.
  for (SpecimenRows& specimen : specimens) {
    if (times[specimen.name] == 1) continue;
    const std::string file = fs::path(location(specimen.first, "").file).stem().string();
    specimen.name = file + "." + specimen.name;
  }
  return specimens;
}

std::vector<OwnColumn> DataRows::own_columns() const {
  std::vector<OwnColumn> columns;
  for (const std::string& header : tables_.front().headers()) {
    const bool everywhere = std::all_of(tables_.begin(), tables_.end(), [&](const CsvTable& table) {
      const std::vector<std::string> headers = table.headers();
      return std::find(headers.begin(), headers.end(), header) != headers.end();
    });
    if (!everywhere) continue;
    columns.push_back({header, gather([&](const CsvTable& table) { return table.texts(header); })});
  }
  return columns;
}

std::vector<std::string> DataRows::columns_by_synonym() const {
  std::set<std::string> found;
  for (const CsvTable& table : tables_) {
    for (const auto& [name, header] : table.found_by_synonym()) {
      found.insert(name + ": the column " + quoted_value(header));
    }
  }
  return {found.begin(), found.end()};
}

std::vector<std::string> DataRows::lines_left_out() const {
  constexpr std::size_t kLongest = 60;
  std::vector<std::string> texts;
  for (const CsvTable& table : tables_) {
    if (table.footer().empty()) continue;
    texts.push_back(quoted_value(one_line(table.footer(), kLongest)) +
                    " below the rows is left out");
  }
  return texts;
}

std::vector<std::string> DataRows::unused_columns() const {
  std::set<std::string> unused;
  for (const CsvTable& table : tables_) {
    for (const std::string& header : table.unused_columns()) unused.insert(header);
  }
  return {unused.begin(), unused.end()};
}

Location DataRows::location(int row, std::string_view column) const {
  size_t local = static_cast<size_t>(row);
  for (const CsvTable& table : tables_) {
    if (local < table.rows()) return {table.file(), table.line(local), std::string(column)};
    local -= table.rows();
  }
  return {tables_.back().file(), 0, std::string(column)};
}

}  // namespace pliant
