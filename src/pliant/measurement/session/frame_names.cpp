#include "pliant/measurement/session/frame_names.h"

#include <limits>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "pliant/base/number_text.h"

namespace pliant {
namespace {

namespace fs = std::filesystem;

/// `d` or `0Nd` at the start of a text: the digits that a number has at least, and what follows.
struct NumberFormat {
  int digits = 1;
  std::string_view rest;
};

std::optional<NumberFormat> number_format(std::string_view text) {
  if (text.starts_with('d')) return NumberFormat{1, text.substr(1)};
  const bool padded =
      text.size() >= 3 && text[0] == '0' && text[1] >= '1' && text[1] <= '9' && text[2] == 'd';
  if (!padded) return std::nullopt;
  return NumberFormat{text[1] - '0', text.substr(3)};
}

}  // namespace

FrameNames FrameNames::read(const Value& value) {
  const std::string pattern = value.text();
  const std::size_t percent = pattern.find('%');
  const auto format = percent == std::string::npos
                          ? std::nullopt
                          : number_format(std::string_view(pattern).substr(percent + 1));
  if (!format || format->rest.find_first_of("%/") != std::string_view::npos ||
      !format->rest.ends_with(".ply")) {
    value.fail(quoted_value(pattern) + " is no pattern of frames",
               "a PLY file with the frame's number in its name, e.g. frames/%04d.ply");
  }
  FrameNames names;
  names.where_ = value.location();
  names.folder_ = fs::path(names.where_.file).parent_path();
  names.before_ = pattern.substr(0, percent);
  names.after_ = format->rest;
  names.digits_ = format->digits;
  return names;
}

std::string FrameNames::name(int frame) const {
  return fmt::format("{}{:0{}}{}", before_, frame, digits_, after_);
}

int FrameNames::count() const {
  const fs::path parent = file(0).parent_path();
  const fs::path folder = parent.empty() ? fs::path(".") : parent;
  const std::string before = fs::path(before_ + "0").filename().string();
  const std::size_t begin = before.size() - 1;
  std::set<int> numbers;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string found = entry->path().filename().string();
    if (found.size() <= begin + after_.size()) continue;
    const auto number =
        parse_integer(std::string_view(found).substr(begin, found.size() - begin - after_.size()));
    if (!number || *number < 0 || *number > std::numeric_limits<int>::max()) continue;
    const int frame = static_cast<int>(*number);
    if (file(frame).filename() == found) numbers.insert(frame);
  }
  if (numbers.empty()) {
    throw InputError(where_, fmt::format("there is no file {}", quoted_value(file(0).string())),
                     "frames numbered from 0");
  }
  int expected = 0;
  for (const int number : numbers) {
    if (number != expected) {
      throw InputError({file(expected).string()},
                       fmt::format("frame {} is missing, frame {} is there", expected, number),
                       "frames numbered from 0 without gaps");
    }
    ++expected;
  }
  return expected;
}

}  // namespace pliant
