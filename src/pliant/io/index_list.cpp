#include "pliant/io/index_list.h"

#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "pliant/base/number_text.h"
#include "pliant/io/named_file.h"
#include "pliant/io/text_file.h"

namespace pliant {
namespace {

constexpr std::string_view kSeparators = " \t\r,;";

/// A number with the place where it stands.
struct PlacedNumber {
  int number = 0;
  Location where;
};

std::string_view next_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line.substr(0, line.find('#'));
}

int parse_index(std::string_view word, const Location& where) {
  const std::optional<long> number = parse_integer(word);
  if (!number || *number < 0 || *number > std::numeric_limits<int>::max()) {
    throw InputError(where, quoted_value(word) + " is no number of a list", "0, 1, 2, ...");
  }
  return static_cast<int>(*number);
}

std::vector<PlacedNumber> read_numbers(const std::filesystem::path& file) {
  const std::string content = decode_text(read_text_file(file), {}, file.string());
  std::vector<PlacedNumber> numbers;
  std::string_view text = content;
  for (Location where{file.string(), 1, {}}; !text.empty(); ++where.line) {
    const std::string_view line = next_line(text);
    for (std::size_t begin = line.find_first_not_of(kSeparators);
         begin != std::string_view::npos;) {
      const std::size_t end = std::min(line.find_first_of(kSeparators, begin), line.size());
      numbers.push_back({parse_index(line.substr(begin, end - begin), where), where});
      begin = line.find_first_not_of(kSeparators, end);
    }
  }
  return numbers;
}

std::vector<PlacedNumber> placed_numbers(const IndexList& list) {
  if (!list.file.empty()) return read_numbers(list.file);
  std::vector<PlacedNumber> numbers;
  for (const int number : list.numbers) {
    Location where = list.where;
    where.field += fmt::format("[{}]", numbers.size());
    numbers.push_back({number, where});
  }
  return numbers;
}

}  // namespace

IndexList read_index_list(const Value& value) {
  IndexList list;
  list.where = value.location();
  if (value.is_scalar()) {
    list.file = read_named_file(value, "a text file of numbers");
    return list;
  }
  for (const Value& item : value.items()) {
    list.numbers.push_back(item.integer(0, std::numeric_limits<int>::max()));
  }
  if (list.numbers.empty()) value.fail("is empty", "at least one number");
  return list;
}

std::vector<int> numbers_of(const IndexList& list, int count, const std::string& kind) {
  std::vector<int> numbers;
  for (const PlacedNumber& placed : placed_numbers(list)) {
    if (placed.number >= count) {
      throw InputError(placed.where, fmt::format("there is no {} {}", kind, placed.number),
                       fmt::format("a number below {}", count));
    }
    numbers.push_back(placed.number);
  }
  if (numbers.empty()) {
    throw InputError(list.where, quoted_value(list.file.string()) + " lists no " + kind,
                     "at least one number");
  }
  return numbers;
}

}  // namespace pliant
