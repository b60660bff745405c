#include "pliant/exchange/tester_study.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <yaml-cpp/yaml.h>

#include "pliant/base/errors.h"
#include "pliant/base/nearest_name.h"
#include "pliant/experiment/tensile/tensile_cycles_type.h"
#include "pliant/io/text_file.h"
#include "pliant/study/blank_fields.h"

namespace pliant {
namespace {

constexpr std::size_t kLongestComment = 70;
constexpr int kCommentColumn = 26;

std::string name_of(const TesterFile& file) { return file.path.filename().string(); }

/// A text as YAML writes it, in quotes where it needs them.
std::string yaml_text(const std::string& text) {
  const bool plain = !text.empty() && std::ranges::all_of(text, [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.';
  }) && std::isalpha(static_cast<unsigned char>(text.front())) != 0;
  if (plain || text == kBlank) return text;
  YAML::Emitter yaml;
  yaml << YAML::DoubleQuoted << text;
  return yaml.c_str();
}

/// `indent` KEY: VALUE, and a comment beside it.
std::string line(int indent, const std::string& field, const std::string& comment = {}) {
  const std::string text = std::string(static_cast<std::size_t>(indent), ' ') + field;
  if (comment.empty()) return text + "\n";
  return fmt::format("{:<{}}  # {}\n", text, kCommentColumn, one_line(comment, kLongestComment));
}

std::string origin(const TesterFact& fact) {
  return fmt::format("line {}: {}", fact.line, fact.written);
}

/// A test standard, and not any method of a laboratory's own.
bool is_standard(std::string_view text) {
  const auto bodies = {"ISO", "EN", "DIN", "ASTM", "BS", "JIS", "GB", "KES"};
  return std::ranges::any_of(bodies, [&](std::string_view body) {
    return text.starts_with(body) && text.size() > body.size() &&
           (text[body.size()] == ' ' || text[body.size()] == '-');
  });
}

std::string value_of(const TesterFile& file, std::string_view field) {
  const TesterFact* fact = find_fact(file.facts, field);
  return fact ? fact->value : std::string();
}

bool are_alike(const TesterFile& a, const TesterFile& b) {
  const auto same = [&](const char* field) { return value_of(a, field) == value_of(b, field); };
  return a.type == b.type && a.direction == b.direction && a.columns == b.columns &&
         a.csv.encoding == b.csv.encoding && a.csv.skip_rows == b.csv.skip_rows &&
         a.csv.sheet == b.csv.sheet && a.path.extension() == b.path.extension() && same("length") &&
         same("width") && same("pretension");
}

/// Files of one experiment: alike, and called alike up to a number or letter at the end.
using Group = std::vector<const TesterFile*>;

std::string without_number(const TesterFile& file) {
  const std::string stem = file.path.stem().string();
  return stem.substr(0, stem.find_last_not_of("0123456789-_. ()#") + 1);
}

std::vector<Group> groups_of(std::span<const TesterFile> files) {
  std::vector<Group> groups;
  for (const TesterFile& file : files) {
    const auto alike = std::ranges::find_if(groups, [&](const Group& group) {
      const std::string prefix = without_number(file);
      return !prefix.empty() && without_number(*group.front()) == prefix &&
             are_alike(*group.front(), file);
    });
    if (alike == groups.end()) {
      groups.push_back({&file});
    } else {
      alike->push_back(&file);
    }
  }
  return groups;
}

/// The file, or the pattern of the files of a group; a pattern takes no other file along.
std::string data_name(const Group& group) {
  if (group.size() == 1) return name_of(*group.front());
  return without_number(*group.front()) + "*" + group.front()->path.extension().string();
}

/// Patterns that would take files of other groups along are not used.
std::vector<Group> with_own_patterns(std::vector<Group> groups) {
  std::vector<Group> result;
  for (const Group& group : groups) {
    const std::string prefix = without_number(*group.front());
    const bool own = std::ranges::all_of(groups, [&](const Group& other) {
      return &other == &group || std::ranges::none_of(other, [&](const TesterFile* file) {
        return name_of(*file).starts_with(prefix);
      });
    });
    if (own) {
      result.push_back(group);
    } else {
      for (const TesterFile* file : group) result.push_back({file});
    }
  }
  return result;
}

/// A name for an experiment: letters, digits, `-`, `_`, `.`.
std::string experiment_name(const Group& group, std::set<std::string>& names) {
  std::string name =
      group.size() == 1 ? group.front()->path.stem().string() : without_number(*group.front());
  for (char& c : name) {
    const auto u = static_cast<unsigned char>(c);
    if (u >= 0x80 || (std::isalnum(u) == 0 && c != '-' && c != '_' && c != '.')) c = '-';
  }
  if (std::isalnum(static_cast<unsigned char>(name.front())) == 0) name = "test" + name;
  std::string unique = name;
  for (int i = 2; !names.insert(unique).second; ++i) unique = fmt::format("{}-{}", name, i);
  return unique;
}

std::string data_lines(const Group& group) {
  const TesterFile& file = *group.front();
  const CsvOptions& csv = file.csv;
  const std::string name = yaml_text(data_name(group));
  if (file.columns.empty() && csv.encoding.empty() && csv.skip_rows == 0 && csv.sheet.empty()) {
    return line(4, "data: " + name);
  }
  std::string text = line(4, "data:") + line(6, "file: " + name);
  if (!csv.encoding.empty()) {
    text += line(6, "encoding: " + yaml_text(csv.encoding), "as it seems");
  }
  if (csv.skip_rows > 0) text += line(6, fmt::format("skip_rows: {}", csv.skip_rows));
  if (!csv.sheet.empty()) {
    text += line(6, "sheet: " + yaml_text(csv.sheet), "of " + list_of_names(file.sheets));
  }
  if (!file.columns.empty()) text += line(6, "columns:");
  for (const auto& [ours, theirs] : file.columns) {
    const bool blank = theirs.find(kBlank) != std::string::npos;
    text += line(8, ours + ": " + yaml_text(theirs), blank ? blank_hint("columns") : "");
  }
  return text;
}

std::string required_line(const TesterFile& file, std::string_view field) {
  const auto written = [&](const std::string& value, const std::string& comment) {
    return line(4, fmt::format("{}: {}", field, value), comment);
  };
  const TesterFact* fact = find_fact(file.facts, field);
  if (fact) return written(fact->value, origin(*fact));
  if (field == "direction" && !file.direction.empty()) {
    return written(file.direction, "by the name of the file");
  }
  return written(std::string(kBlank), blank_hint(field));
}

bool is_told_by_column(const TesterFile& file, std::string_view field) {
  const auto has = [&](const auto& names) {
    return std::ranges::find(names, field) != std::end(names);
  };
  return has(file.type->told_by_columns) && has(file.headers);
}

std::string passes_text(const TesterFile& file) {
  std::string text = fmt::format("{} rows", file.rows);
  if (file.specimens > 1) text += fmt::format(" of {} specimens", file.specimens);
  if (!file.type->facts.deformation || file.type->facts.measures_profiles || !file.passes) {
    return text;
  }
  if (file.passes == 1) return text + ", one way: without the way back friction stays unknown";
  return text + fmt::format(", {} ways to and fro", *file.passes);
}

std::string lines_of_group(const Group& group, std::set<std::string>& names) {
  const TesterFile& file = *group.front();
  std::string text = line(2, "- name: " + experiment_name(group, names));
  text += line(4, fmt::format("type: {}", file.type->name),
               file.is_type_known ? passes_text(file) : "not told by the columns: another?");
  for (const std::string_view field : file.type->required) {
    if (!is_told_by_column(file, field)) text += required_line(file, field);
  }
  text += data_lines(group);
  const TesterFact* pretension = find_fact(file.facts, "pretension");
  if (pretension && file.type == &tensile_cycles_type()) {
    text += line(4, "pretension: " + pretension->value, origin(*pretension));
  }
  const std::string standard = value_of(file, "standard");
  if (is_standard(standard)) text += line(4, "standard: " + yaml_text(standard));
  return text;
}

/// What all files tell alike, or the only file does.
std::string info_lines(std::span<const TesterFile> files) {
  std::string text;
  for (const char* field : {"operator", "date", "speed", "specimen"}) {
    const std::string value = value_of(files.front(), field);
    const bool alike = std::ranges::all_of(
        files, [&](const TesterFile& file) { return value_of(file, field) == value; });
    const bool is_of_one = files.front().specimens == 1 || field != std::string_view("specimen");
    if (alike && is_of_one && !value.empty())
      text += line(2, fmt::format("{}: {}", field, yaml_text(value)));
  }
  return text.empty() ? text : "info:\n" + text;
}

bool are_of_solids(std::span<const TesterFile> files) {
  return std::ranges::all_of(
      files, [](const TesterFile& file) { return file.type->facts.measures_solids; });
}

std::string density_line(std::span<const TesterFile> files) {
  if (are_of_solids(files)) {
    return line(0, "# density: 950 kg/m^3", "mass of a piece divided by its volume");
  }
  const bool needed = std::ranges::any_of(
      files, [](const TesterFile& file) { return file.type->facts.needs_density; });
  return needed ? line(0, fmt::format("density: {}", kBlank), blank_hint("density"))
                : line(0, "# density: 150 g/m^2", "mass of a piece of the fabric per area");
}

/// Which sheets were taken of workbooks that have several.
std::vector<std::string> sheet_notes(std::span<const TesterFile> files) {
  std::vector<std::string> notes;
  for (const TesterFile& file : files) {
    if (file.csv.sheet.empty()) continue;
    notes.push_back(fmt::format("{}: the sheet {} of {}; `--sheet NAME` takes another",
                                name_of(file), quoted_value(file.csv.sheet),
                                list_of_names(file.sheets)));
  }
  return notes;
}

/// Each line of a study that is left blank, for the user.
std::vector<std::string> blank_notes(const std::string& study) {
  std::vector<std::string> notes;
  std::istringstream lines(study);
  std::string text;
  for (int number = 1; std::getline(lines, text); ++number) {
    const bool is_comment = text.starts_with('#');
    if (is_comment || text.find(kBlank) == std::string::npos) continue;
    const std::size_t first = text.find_first_not_of(" -");
    notes.push_back(fmt::format("to fill in: line {}: {}", number, text.substr(first)));
  }
  return notes;
}

}  // namespace

std::string experiment_lines(std::span<const TesterFile> files) {
  std::set<std::string> names;
  std::string text;
  for (const Group& group : with_own_patterns(groups_of(files))) {
    text += lines_of_group(group, names);
  }
  return text;
}

ImportedStudy tester_study(std::span<const TesterFile> files) {
  ImportedStudy study;
  std::set<std::string> names;
  for (const TesterFile& file : files) {
    if (!names.insert(name_of(file)).second) {
      throw InputError({file.path.string()}, "a second file of that name",
                       "files of different names");
    }
    study.files.emplace_back(name_of(file), read_text_file(file.path));
    study.notes.push_back(
        fmt::format("{}: {}, {}", name_of(file), file.type->name, passes_text(file)));
  }
  std::ranges::move(sheet_notes(files), std::back_inserter(study.notes));
  std::string material = value_of(files.front(), "material");
  if (material.empty()) material = without_number(files.front());
  if (material.empty()) material = files.front().path.stem().string();
  study.study_yaml = fmt::format(
                         "# A study of {}.\n# `pliant fit` names what is left blank ({}).\n"
                         "pliant: study/1\n",
                         fmt::join(names, ", "), kBlank) +
                     line(0, "name: " + yaml_text(material),
                          are_of_solids(files) ? "of the material" : "of the fabric") +
                     density_line(files) + info_lines(files) + "experiments:\n" +
                     experiment_lines(files);
  std::ranges::move(blank_notes(study.study_yaml), std::back_inserter(study.notes));
  return study;
}

}  // namespace pliant
