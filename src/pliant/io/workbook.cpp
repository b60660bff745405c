#include "pliant/io/workbook.h"

#include "pliant/base/errors.h"
#include "pliant/base/letter_case.h"

#ifdef PLIANT_HAS_ORCUS

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <orcus/sax_parser.hpp>

#include "pliant/base/nearest_name.h"
#include "pliant/base/number_text.h"
#include "pliant/io/zip_file.h"

namespace pliant {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostCells = 20'000'000;
constexpr long kMostRows = 1 << 20;  // of a sheet, as the format has it
constexpr long kMostColumns = 1 << 14;

using Attributes = std::map<std::string, std::string, std::less<>>;

std::string attribute_of(const Attributes& attributes, std::string_view name) {
  const auto found = attributes.find(name);
  return found == attributes.end() ? std::string() : found->second;
}

/// Reads one of the XML files that a workbook consists of, element by element, their namespaces
/// aside.
class PartReader : public orcus::sax_handler {
 public:
  virtual ~PartReader() = default;

  void read(const std::string& xml) {
    orcus::sax_parser<PartReader>(xml.data(), xml.size(), *this).parse();
  }

  void attribute(const orcus::sax::parser_attribute& attribute) {
    attributes_[std::string(attribute.name)] = attribute.value;
  }
  void start_element(const orcus::sax::parser_element& element) {
    if (element.name == "rPh") in_phonetic_ = true;
    in_text_ = !in_phonetic_ && (element.name == "t" || element.name == "v");
    begin(element.name, std::exchange(attributes_, {}));
  }
  void end_element(const orcus::sax::parser_element& element) {
    if (element.name == "rPh") in_phonetic_ = false;
    in_text_ = false;
    end(element.name);
  }
  void characters(std::string_view text, bool) {
    if (in_text_) text_ += text;
  }

 protected:
  virtual void begin(std::string_view element, const Attributes& attributes) = 0;
  virtual void end(std::string_view) {}
  /// The texts and values since the last call, how they are pronounced aside.
  std::string take_text() { return std::exchange(text_, {}); }

 private:
  Attributes attributes_;  // of the element that comes next
  std::string text_;
  bool in_text_ = false;
  bool in_phonetic_ = false;
};

/// What the parts of a workbook are to each other.
class Relations : public PartReader {
 public:
  /// The part of an id, or of a type by the last word of its address.
  std::string by_id(std::string_view id) const { return attribute_of(by_id_, id); }
  std::string by_type(std::string_view type) const { return attribute_of(by_type_, type); }

 private:
  void begin(std::string_view element, const Attributes& attributes) override {
    if (element != "Relationship") return;
    const std::string target = attribute_of(attributes, "Target");
    const std::string type = attribute_of(attributes, "Type");
    by_id_[attribute_of(attributes, "Id")] = target;
    by_type_[type.substr(type.rfind('/') + 1)] = target;
  }

  Attributes by_id_, by_type_;
};

class SheetList : public PartReader {
 public:
  struct Entry {
    std::string name;
    std::string relation;
  };
  const std::vector<Entry>& sheets() const { return sheets_; }

 private:
  void begin(std::string_view element, const Attributes& attributes) override {
    if (element != "sheet") return;
    sheets_.push_back({attribute_of(attributes, "name"), attribute_of(attributes, "id")});
  }

  std::vector<Entry> sheets_;
};

class SharedStrings : public PartReader {
 public:
  const std::string& at(std::size_t index) const { return texts_.at(index); }

 private:
  void begin(std::string_view element, const Attributes&) override {
    if (element == "si") take_text();
  }
  void end(std::string_view element) override {
    if (element == "si") texts_.push_back(take_text());
  }

  std::vector<std::string> texts_;
};

std::string quoted_cell(std::string_view text) {
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? "\"\"" : std::string(1, c);
  return cell + "\"";
}

/// The number of a column, from 0, of the address of a cell, `B12`.
long column_of(std::string_view address) {
  long column = 0;
  for (std::size_t i = 0; i < address.size() && i < 4; ++i) {
    if (address[i] < 'A' || address[i] > 'Z') break;
    column = 26 * column + (address[i] - 'A' + 1);
  }
  return column - 1;
}

/// The cells of a sheet; of formulas what they had come to.
class Sheet : public PartReader {
 public:
  explicit Sheet(const SharedStrings& strings) : strings_(strings) {}

  bool has_numbers() const {
    return std::any_of(rows_.begin(), rows_.end(), [](const auto& row) {
      return std::count_if(row.second.begin(), row.second.end(), [](const auto& cell) {
               return parse_number(cell.second).has_value();
             }) > 1;
    });
  }

  std::string text() const {
    std::string text;
    long line = 0;
    for (const auto& [row, cells] : rows_) {
      for (; line < row; ++line) text += '\n';
      long column = 0;
      for (const auto& [at, cell] : cells) {
        for (; column < at; ++column) text += '\t';
        text += parse_number(cell) ? cell : quoted_cell(cell);
      }
      for (; column < last_column_; ++column) text += '\t';
    }
    return text + "\n";
  }

 private:
  /// Rows and cells that do not say where they are follow the one before them.
  void begin(std::string_view element, const Attributes& attributes) override {
    const std::string address = attribute_of(attributes, "r");
    if (element == "row") {
      row_ = address.empty() ? row_ + 1 : parse_integer(address).value_or(0) - 1;
      column_ = -1;
    } else if (element == "c") {
      column_ = address.empty() ? column_ + 1 : column_of(address);
      type_ = attribute_of(attributes, "t");
      take_text();
    }
  }

  void end(std::string_view element) override {
    if (element == "c") put(value(take_text()));
  }

  /// A cell's content as its type says it; one without a type is a number.
  std::string value(const std::string& content) const {
    if (type_ == "s") return strings_.at(static_cast<std::size_t>(parse_integer(content).value()));
    if (type_ == "b") return content == "0" ? "false" : "true";
    const std::optional<double> number = parse_number(content);
    return number ? format_number(*number) : content;
  }

  void put(std::string text) {
    if (text.empty()) return;
    if (row_ < 0 || row_ >= kMostRows || column_ < 0 || column_ >= kMostColumns) {
      throw InputError({}, "a cell has no address");
    }
    if (++count_ > kMostCells) throw InputError({}, "the sheet is too large");
    rows_[row_][column_] = std::move(text);
    last_column_ = std::max(last_column_, column_);
  }

  const SharedStrings& strings_;
  std::map<long, std::map<long, std::string>> rows_;
  long last_column_ = 0;
  std::size_t count_ = 0;
  long row_ = -1;  // of the cell that is read
  long column_ = -1;
  std::string type_;
};

/// The list of a workbook's sheets, and each when it is asked for.
class Workbook {
 public:
  explicit Workbook(fs::path file) : file_(std::move(file)) {
    main_part_ = target_from("", relations_of("").by_type("officeDocument"));
    relations_ = relations_of(main_part_);
    read_part(main_part_, list_);
    const std::string strings = relations_.by_type("sharedStrings");
    if (!strings.empty()) read_part(target_from(main_part_, strings), strings_);
  }

  const std::vector<SheetList::Entry>& sheets() const { return list_.sheets(); }

  Sheet sheet(const SheetList::Entry& entry) const {
    Sheet sheet(strings_);
    read_part(target_from(main_part_, relations_.by_id(entry.relation)), sheet);
    return sheet;
  }

 private:
  void read_part(const std::string& part, PartReader& reader) const {
    reader.read(read_zip_entry(file_, part));
  }

  Relations relations_of(const std::string& part) const {
    Relations relations;
    const fs::path path(part);
    read_part((path.parent_path() / "_rels" / (path.filename().string() + ".rels")).string(),
              relations);
    return relations;
  }

  /// A part that another names: from the other's folder, or from the workbook's root.
  static std::string target_from(const std::string& part, const std::string& target) {
    if (target.starts_with('/')) return target.substr(1);
    return (fs::path(part).parent_path() / target).lexically_normal().generic_string();
  }

  fs::path file_;
  std::string main_part_;
  Relations relations_;
  SheetList list_;
  SharedStrings strings_;
};

/// The text of a sheet; none where there is no such sheet.
std::optional<std::string> sheet_text(const Workbook& workbook, const std::string& name) {
  for (const SheetList::Entry& entry : workbook.sheets()) {
    if (!name.empty() && entry.name != name) continue;
    const Sheet sheet = workbook.sheet(entry);
    if (!name.empty() || sheet.has_numbers()) return sheet.text();
  }
  return std::nullopt;
}

std::vector<std::string> names_of(const Workbook& workbook) {
  std::vector<std::string> names;
  for (const SheetList::Entry& entry : workbook.sheets()) names.push_back(entry.name);
  return names;
}

/// What a function makes of a workbook.
template <class Read>
auto read_workbook(const fs::path& path, Read read) {
  try {
    return read(Workbook(path));
  } catch (const std::exception& error) {
    throw InputError({path.string()},
                     fmt::format("cannot be read as a workbook: {}", one_line(error.what(), 200)));
  }
}

}  // namespace

bool reads_workbooks() { return true; }

std::vector<std::string> workbook_sheets(const fs::path& path) {
  return read_workbook(path, names_of);
}

std::string workbook_text(const fs::path& path, const std::string& sheet) {
  const auto text =
      read_workbook(path, [&](const Workbook& workbook) { return sheet_text(workbook, sheet); });
  if (text) return *text;
  if (sheet.empty()) throw InputError({path.string()}, "no sheet holds a table of numbers");
  const std::vector<std::string> names = workbook_sheets(path);
  throw InputError({path.string(), 0, "sheet"},
                   "there is no sheet " + quoted_value(sheet) + did_you_mean(sheet, names),
                   list_of_names(names));
}

#else

namespace pliant {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& path) {
  throw InputError({path.string()}, "is a workbook, which this build does not read",
                   "the sheet saved as CSV, or a build with liborcus (packages.txt)");
}

}  // namespace

bool reads_workbooks() { return false; }

std::vector<std::string> workbook_sheets(const std::filesystem::path& path) { refuse(path); }

std::string workbook_text(const std::filesystem::path& path, const std::string&) { refuse(path); }

#endif

bool is_workbook(const std::filesystem::path& path) {
  const std::string ending = lower_case(path.extension().string());
  return ending == ".xlsx" || ending == ".xlsm";
}

}  // namespace pliant
