#include "pliant/io/ply_header.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/number_text.h"

namespace pliant {
namespace {

constexpr std::size_t kMaxHeaderSize = std::size_t{1} << 20;
constexpr std::size_t kMaxCount = std::numeric_limits<int>::max();

struct TypeName {
  PlyType type;
  std::string_view name;        // of the first description of the format
  std::string_view sized_name;  // of later ones
};

constexpr std::array<TypeName, 8> kTypes{{{PlyType::int8, "char", "int8"},
                                          {PlyType::uint8, "uchar", "uint8"},
                                          {PlyType::int16, "short", "int16"},
                                          {PlyType::uint16, "ushort", "uint16"},
                                          {PlyType::int32, "int", "int32"},
                                          {PlyType::uint32, "uint", "uint32"},
                                          {PlyType::float32, "float", "float32"},
                                          {PlyType::float64, "double", "float64"}}};

std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view kBlanks = " \t\r";
  std::vector<std::string_view> words;
  std::size_t at = 0;
  while ((at = line.find_first_not_of(kBlanks, at)) != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

class HeaderParser {
 public:
  HeaderParser(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  PlyHeader parse() && {
    if (next_line() != "ply") fail("the file is not a PLY file", "a first line \"ply\"");
    read_format();
    for (std::string_view line = next_line(); line != "end_header"; line = next_line()) {
      statement(line);
    }
    header_.size = at_;
    header_.lines = line_;
    check_sizes();
    return std::move(header_);
  }

 private:
  /// The next line without its end and blanks around it.
  std::string_view next_line() {
    ++line_;
    const std::string_view rest = bytes_.substr(at_, kMaxHeaderSize);
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos || at_ > kMaxHeaderSize) {
      if (line_ == 1) return {};
      fail("the header does not end", "a line \"end_header\"");
    }
    at_ += end + 1;
    return trimmed(rest.substr(0, end));
  }

  void read_format() {
    const std::string_view line = next_line();
    if (line == "format ascii 1.0") {
      header_.format = PlyFormat::ascii;
    } else if (line == "format binary_little_endian 1.0") {
      header_.format = PlyFormat::binary_little_endian;
    } else if (line == "format binary_big_endian 1.0") {
      header_.format = PlyFormat::binary_big_endian;
    } else {
      fail("unknown format " + quoted_value(line),
           "\"format\", then ascii, binary_little_endian or binary_big_endian, then 1.0");
    }
  }

  void statement(std::string_view line) {
    const std::vector<std::string_view> words = words_of(line);
    const std::string_view first = words.empty() ? std::string_view() : words[0];
    if (first == "comment" || first == "obj_info") {
      if (first == "comment") header_.comments.emplace_back(trimmed(line.substr(first.size())));
    } else if (first == "element" && words.size() == 3) {
      add_element(words[1], words[2]);
    } else if (first == "property" && words.size() == 3) {
      add_property({std::string(words[2]), type_of(words[1]), {}});
    } else if (first == "property" && words.size() == 5 && words[1] == "list") {
      add_property({std::string(words[4]), type_of(words[3]), count_type_of(words[2])});
    } else {
      fail("unknown header line " + quoted_value(line),
           "\"element NAME COUNT\", \"property TYPE NAME\", \"property list TYPE TYPE NAME\", "
           "\"comment\" or \"end_header\"");
    }
  }

  void add_element(std::string_view name, std::string_view count_text) {
    for (const PlyElement& element : header_.elements) {
      if (element.name == name) fail("a second element " + quoted_value(name), "each name once");
    }
    std::size_t count = 0;
    const char* end = count_text.data() + count_text.size();
    const auto parsed = std::from_chars(count_text.data(), end, count);
    if (parsed.ptr != end || parsed.ec != std::errc() || count > kMaxCount) {
      fail("the count " + quoted_value(count_text) + " cannot be read",
           fmt::format("a whole number up to {}", kMaxCount));
    }
    header_.elements.push_back({std::string(name), count, line_, {}});
  }

  void add_property(PlyProperty property) {
    if (header_.elements.empty()) fail("a property before the first element");
    auto& properties = header_.elements.back().properties;
    const bool known = std::any_of(properties.begin(), properties.end(),
                                   [&](const auto& other) { return other.name == property.name; });
    if (known) fail("a second property " + quoted_value(property.name), "each name once");
    properties.push_back(std::move(property));
  }

  PlyType type_of(std::string_view name) const {
    for (const TypeName& type : kTypes) {
      if (name == type.name || name == type.sized_name) return type.type;
    }
    fail("unknown type " + quoted_value(name),
         "char, uchar, short, ushort, int, uint, float or double");
  }

  PlyType count_type_of(std::string_view name) const {
    const PlyType type = type_of(name);
    if (!is_integer(type)) fail("a list's length is no whole number", "uchar, int or the like");
    return type;
  }

  /// Refuses what cannot be in the file before room is made for it.
  void check_sizes() const {
    std::size_t left = bytes_.size() - at_;
    const bool ascii = header_.format == PlyFormat::ascii;
    if (ascii) ++left;  // the last line need not end
    for (const PlyElement& element : header_.elements) {
      std::size_t row = 0;
      for (const PlyProperty& property : element.properties) {
        row += ascii ? 2 : size_of(property.count_type.value_or(property.type));
      }
      if (element.count > 0 && (row == 0 || element.count > left / row)) {
        throw InputError({file_, element.line, "element " + element.name},
                         fmt::format("the file is too small for the {} it claims", element.count),
                         row == 0 ? "properties" : fmt::format("at most {}", left / row));
      }
      left -= element.count * row;
    }
  }

  [[noreturn]] void fail(const std::string& problem, const std::string& expected = {}) const {
    throw InputError({file_, line_}, problem, expected);
  }

  std::string_view bytes_;
  const std::string& file_;
  std::size_t at_ = 0;
  int line_ = 0;
  PlyHeader header_;
};

}  // namespace

std::size_t size_of(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8:
      return 1;
    case PlyType::int16:
    case PlyType::uint16:
      return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32:
      return 4;
    case PlyType::float64:
      break;
  }
  return 8;
}

bool is_integer(PlyType type) { return type != PlyType::float32 && type != PlyType::float64; }

std::string_view name_of(PlyType type) { return kTypes[static_cast<std::size_t>(type)].name; }

PlyHeader parse_ply_header(std::string_view bytes, const std::string& file) {
  return HeaderParser(bytes, file).parse();
}

}  // namespace pliant
