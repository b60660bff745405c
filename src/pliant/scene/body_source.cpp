#include "pliant/scene/body_source.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <regex>
#include <set>
#include <system_error>

#include <fmt/format.h>

#include "pliant/geometry/mesh_file_fields.h"
#include "pliant/io/named_file.h"

namespace pliant {
namespace {

// Names of files that differ by a number.
struct NumberedFiles {
  std::filesystem::path folder;
  std::string before, after;
  int digits = 0;  // at least, filled with zeros

  std::filesystem::path file(int number) const {
    return folder / fmt::format("{}{:0{}}{}", before, number, digits, after);
  }
  std::optional<int> number_of(const std::string& name) const {
    if (name.size() <= before.size() + after.size() || !name.starts_with(before) ||
        !name.ends_with(after)) {
      return std::nullopt;
    }
    int number = 0;
    const char* end = name.data() + name.size() - after.size();
    const auto [stop, error] = std::from_chars(name.data() + before.size(), end, number);
    if (error != std::errc() || stop != end || file(number).filename() != name) return std::nullopt;
    return number;
  }
  std::set<int> numbers() const {
    std::set<int> numbers;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
      if (const auto number = number_of(entry.path().filename().string())) numbers.insert(*number);
    }
    return numbers;
  }
};

NumberedFiles read_pattern(const Value& value) {
  const std::string pattern = value.text("names of files, as walk/%04d.obj");
  const std::filesystem::path path(pattern);
  const std::string name = path.filename().string();
  static const std::regex kPattern("([^%]*)%(?:0([1-9]))?d([^%]*)");
  std::smatch parts;
  if (!std::regex_match(name, parts, kPattern)) {
    value.fail(quoted_value(pattern) + " does not tell where the number stands",
               "one %d, or %04d, in the name of the file");
  }
  NumberedFiles files;
  files.folder = std::filesystem::path(value.location().file).parent_path() / path.parent_path();
  if (files.folder.empty()) files.folder = ".";
  files.before = parts[1];
  files.after = parts[3];
  files.digits = parts[2].matched ? std::stoi(parts[2]) : 1;
  return files;
}

// All files from the first number on.
std::vector<std::filesystem::path> found_files(const Value& value, const NumberedFiles& named,
                                               std::optional<int> first) {
  const std::set<int> numbers = named.numbers();
  if (numbers.empty()) {
    value.fail("no such file is in " + quoted_value(named.folder.string()),
               "files relative to the document");
  }
  std::vector<std::filesystem::path> files;
  for (int number = first.value_or(*numbers.begin()); number <= *numbers.rbegin(); ++number) {
    files.push_back(named.file(number));
    if (!numbers.contains(number)) {
      value.fail("the file " + quoted_value(files.back().string()) + " does not exist",
                 fmt::format("all frames up to {}, without a gap", *numbers.rbegin()));
    }
  }
  if (files.empty()) {
    value.fail(fmt::format("the last file there is {}", *numbers.rbegin()),
               fmt::format("files from `first`, {}, on", *first));
  }
  return files;
}

void read_axes(Fields& fields, BodySource& source) {
  source.unit = read_file_unit(fields);
  source.up = read_file_up(fields).value_or(source.up);
}

}  // namespace

BodySource read_body_mesh(const Value& value) {
  Fields fields = value.fields();
  BodySource source;
  source.files.push_back(read_named_file(fields.require("file"), "a mesh file"));
  read_axes(fields, source);
  fields.finish();
  return source;
}

BodySource read_body_sequence(const Value& value) {
  Fields fields = value.fields();
  BodySource source;
  const Value files = fields.require("files");
  std::optional<int> first;
  if (auto v = fields.optional("first")) first = v->integer(0, std::numeric_limits<int>::max());
  source.files = found_files(files, read_pattern(files), first);
  source.rate = fields.require("rate").positive_quantity(Dimension::frequency);
  read_axes(fields, source);
  fields.finish();
  return source;
}

}  // namespace pliant
