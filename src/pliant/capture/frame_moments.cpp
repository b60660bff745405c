#include "pliant/capture/frame_moments.h"

#include <algorithm>
#include <charconv>
#include <numeric>
#include <optional>

#include <fmt/format.h>

namespace pliant {
namespace {

/// The last number in a file's name, and what stands around it.
struct NumberedName {
  std::string around;
  long long number = 0;
};

std::optional<NumberedName> numbered_name(const std::filesystem::path& file) {
  constexpr const char* kDigits = "0123456789";
  std::string stem = file.stem().string();
  const auto last = stem.find_last_of(kDigits);
  if (last == std::string::npos) return std::nullopt;
  const auto before = stem.find_last_not_of(kDigits, last);
  const auto first = before == std::string::npos ? 0 : before + 1;
  NumberedName name;
  const auto read = std::from_chars(stem.data() + first, stem.data() + last + 1, name.number);
  if (read.ec != std::errc()) return std::nullopt;
  name.around = stem.erase(first, last + 1 - first);
  return name;
}

/// Of names that differ in them alone, and in which they increase.
std::vector<long long> numbers_of(const std::vector<std::filesystem::path>& files) {
  std::vector<long long> numbers;
  std::string around;
  for (const auto& file : files) {
    const auto name = numbered_name(file);
    if (!name) return {};
    if (numbers.empty()) around = name->around;
    const bool follows = numbers.empty() || name->number > numbers.back();
    if (name->around != around || !follows) return {};
    numbers.push_back(name->number);
  }
  return numbers;
}

}  // namespace

std::vector<int> moments_by_names(const std::vector<std::filesystem::path>& files) {
  std::vector<int> one_by_one(files.size());
  std::iota(one_by_one.begin(), one_by_one.end(), 0);
  const std::vector<long long> numbers = numbers_of(files);
  if (numbers.size() < 2) return one_by_one;
  long long step = numbers[1] - numbers[0];
  for (std::size_t i = 2; i < numbers.size(); ++i) {
    step = std::min(step, numbers[i] - numbers[i - 1]);
  }
  const auto count = static_cast<long long>(numbers.size());
  const long long missing = (numbers.back() - numbers.front()) / step - (count - 1);
  if (missing > std::max(1LL, count / 4)) return one_by_one;
  std::vector<int> moments;
  for (const long long number : numbers) {
    const long long from_first = number - numbers.front();
    if (from_first % step != 0) return one_by_one;
    moments.push_back(static_cast<int>(from_first / step));
  }
  return moments;
}

std::string gap_doubt(const std::vector<std::filesystem::path>& files) {
  const std::vector<int> moments = moments_by_names(files);
  const auto gap =
      std::ranges::adjacent_find(moments, [](int one, int next) { return next != one + 1; });
  if (gap == moments.end()) return {};
  const auto before = files.begin() + (gap - moments.begin());
  return fmt::format(
      "{} comes after {}: by the numbers in their names {} of the frames are missing, and those "
      "after a gap count as taken so much later (`rate`); where none was lost, number them without "
      "a gap",
      (before + 1)->string(), before->filename().string(),
      moments.back() + 1 - std::ssize(moments));
}

}  // namespace pliant
