#include "pliant/exchange/tester_file.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/experiment/buckling/buckling_bend_type.h"
#include "pliant/experiment/tensile/tensile_cycles_type.h"
#include "pliant/experiment/understood_columns.h"
#include "pliant/io/text_file.h"
#include "pliant/io/workbook.h"
#include "pliant/measurement/column_synonyms.h"
#include "pliant/measurement/turning_points.h"
#include "pliant/study/blank_fields.h"

namespace pliant {
namespace {

std::optional<std::string> decoded(const std::string& bytes, const std::string& encoding) {
  try {
    return decode_text(bytes, encoding, {});
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// Whether a text names a quantity in Chinese, whose characters fill three bytes of UTF-8.
bool names_in_chinese(const std::string& text) {
  return std::ranges::any_of(column_synonyms(), [&](const auto& quantity) {
    return std::ranges::any_of(quantity.second, [&](const std::string& name) {
      return static_cast<unsigned char>(name.front()) >= 0xe0 && text.find(name) != text.npos;
    });
  });
}

/// The first of the encodings of testers' files that the bytes may be in. Nearly any bytes may be
/// Chinese; only known words say that they are.
std::string found_encoding(const std::filesystem::path& path) {
  const std::string bytes = read_text_file(path);
  if (decoded(bytes, "")) return "";
  const bool has_nul = bytes.find('\0') != std::string::npos;
  if (has_nul) return decoded(bytes, "utf-16le") ? "utf-16le" : "";
  const std::optional<std::string> chinese = decoded(bytes, "gbk");
  if (chinese && names_in_chinese(*chinese)) return "gbk";
  return decoded(bytes, "windows-1252") ? "windows-1252" : "";  // the reader says what is wrong
}

/// Whether a sheet of a workbook holds a table; and whether its columns are those of a test.
enum class SheetContent { other, table, test };

SheetContent content_of_sheet(const std::filesystem::path& path, const CsvOptions& csv) {
  try {
    const CsvTable table = read_csv(path, csv);
    return usable_types(understood_columns(table)).empty() ? SheetContent::table
                                                           : SheetContent::test;
  } catch (const InputError&) {
    return SheetContent::other;
  }
}

/// The first sheet that holds a test, else the first that holds a table; empty where none does.
std::string found_sheet(const std::filesystem::path& path, CsvOptions csv,
                        const std::vector<std::string>& sheets) {
  std::string table;
  for (const std::string& sheet : sheets) {
    csv.sheet = sheet;
    const SheetContent content = content_of_sheet(path, csv);
    if (content == SheetContent::test) return sheet;
    if (content == SheetContent::table && table.empty()) table = sheet;
  }
  return table;
}

/// What drives a test along its path.
std::vector<double> driver(const CsvTable& table, const UnderstoodColumns& columns) {
  for (const char* name : {"extension", "length", "strain", "angle", "curvature", "distance"}) {
    for (const auto& [header, column] : columns) {
      if (column.quantity == name) return table.quantity(name, column.dimension);
    }
  }
  return {};
}

/// Counts the specimens, and the passes of that which has most.
void count_passes(const CsvTable& table, const UnderstoodColumns& columns, TesterFile& file) {
  const std::vector<double> path = driver(table, columns);
  const std::vector<std::string> names =
      table.has("specimen") ? table.texts("specimen") : std::vector<std::string>(table.rows());
  file.specimens = 0;
  for (std::size_t first = 0; first < names.size();) {
    std::size_t last = first;
    while (last < names.size() && names[last] == names[first]) ++last;
    ++file.specimens;
    if (!path.empty()) {
      const std::span<const double> own(path.data() + first, last - first);
      const auto passes = half_cycles_of(own, reversal_threshold(own, 0)).size();
      file.passes = std::max(file.passes.value_or(1), static_cast<int>(passes));
    }
    first = last;
  }
}

/// The column of a quantity that the study must tell, as far as it can be found: by its name
/// without its unit, or not at all.
std::string blank_column(const CsvTable& table, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (const auto header = table.quantity_column(name)) {
      return fmt::format("{} ({})", *header, kBlank);
    }
  }
  return std::string(kBlank);
}

/// Whether a table of forces and distances that could be a bent strip's pulls harder than one
/// does: strips that buckle push with some mN.
bool is_pull(const CsvTable& table, const TestType& type) {
  constexpr double kLargestBend = 1;  // N
  if (&type != &buckling_bend_type()) return false;
  const std::vector<double> force = table.quantity("force", Dimension::force);
  return std::ranges::any_of(force, [](double f) { return std::abs(f) > kLargestBend; });
}

/// Distances that begin near zero are counted from the gauge length.
std::string name_of_distance(const CsvTable& table, const std::string& header) {
  constexpr double kNearZero = 0.1;  // of the largest
  const std::vector<double> distance = table.numbers(header);
  const auto [least, most] = std::ranges::minmax_element(distance);
  return std::abs(*least) < kNearZero * *most ? "extension" : "length";
}

/// A strip that is pulled is what testers are used for most. Where a header does not tell what
/// stands below it, its unit may, if no other column has one of the kind.
void take_as_tensile(const CsvTable& table, const UnderstoodColumns& columns, TesterFile& file) {
  const auto is_understood = [&](std::string_view name) {
    return std::ranges::any_of(columns, [&](const auto& c) { return c.second.quantity == name; });
  };
  file.type = &tensile_cycles_type();
  file.is_type_known = false;
  if (!is_understood("force")) {
    const auto told = table.only_column_in(Dimension::force);
    file.columns["force"] = told ? *told : blank_column(table, {"force"});
  }
  if (is_understood("extension") || is_understood("length") || is_understood("strain")) return;
  if (const auto distance = table.only_column_in(Dimension::length)) {
    file.columns[name_of_distance(table, *distance)] = *distance;
    return;
  }
  if (const auto share = table.only_column_in(Dimension::fraction)) {
    file.columns["strain"] = *share;
    return;
  }
  const bool is_length = !table.quantity_column("extension") && table.is_stated("length");
  file.columns[is_length ? "length" : "extension"] = blank_column(table, {"extension", "length"});
}

}  // namespace

TesterFile read_tester_file(const std::filesystem::path& path, CsvOptions csv,
                            const TestType* type) {
  csv.synonyms = column_synonyms();
  csv.numbered_columns = true;
  std::vector<std::string> sheets;
  if (is_workbook(path)) {
    sheets = workbook_sheets(path);
    if (csv.sheet.empty() && sheets.size() > 1) csv.sheet = found_sheet(path, csv, sheets);
  } else if (csv.encoding.empty()) {
    csv.encoding = found_encoding(path);
  }
  const CsvTable table = read_csv(path, csv);
  const UnderstoodColumns columns = understood_columns(table);

  TesterFile file;
  file.path = path;
  file.sheets = std::move(sheets);
  file.columns = csv.columns;
  file.csv = std::move(csv);
  file.headers = table.headers();
  file.rows = static_cast<int>(table.rows());
  file.facts = tester_facts(table.preamble());
  const TesterFact* direction = find_fact(file.facts, "direction");
  file.direction = direction ? direction->value : told_direction(path.stem().string());

  const std::vector<const TestType*> types = usable_types(columns);
  const bool is_usable = std::ranges::find(types, type) != types.end();
  if (type && !is_usable && type != &tensile_cycles_type()) {
    throw InputError({path.string(), table.header_line()},
                     fmt::format("has not the columns of {} (it has {})", type->name,
                                 fmt::join(table.headers(), ", ")),
                     R"(these columns, told by "columns")");
  }
  file.type = is_usable || types.empty() ? type : type ? type : types.front();
  const bool is_unusable = !is_usable && (types.empty() || type);
  const bool is_misnamed = !type && !types.empty() && is_pull(table, *types.front());
  if (is_unusable || is_misnamed) take_as_tensile(table, columns, file);
  count_passes(table, columns, file);
  return file;
}

}  // namespace pliant
