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

/// Of each picture, counted from the first by the smallest difference between two; none where
/// numbers do not count them.
std::vector<long long> steps_of(const std::vector<std::filesystem::path>& files) {
  std::vector<long long> numbers = numbers_of(files);
  if (numbers.size() < 2) return {};
  const long long first = numbers.front();
  long long step = numbers[1] - first;
  for (std::size_t i = 2; i < numbers.size(); ++i) {
    step = std::min(step, numbers[i] - numbers[i - 1]);
  }
  for (long long& number : numbers) {
    if ((number - first) % step != 0) return {};
    number = (number - first) / step;
  }
  return numbers;
}

/// Of pictures that were counted.
long long missing_of(const std::vector<long long>& steps) {
  return steps.back() + 1 - std::ssize(steps);
}

/// Whether as many are missing as a rig may lose.
bool are_lost(const std::vector<long long>& steps) {
  return missing_of(steps) <= std::max<long long>(1, std::ssize(steps) / 4);
}

}  // namespace

std::vector<int> moments_by_names(const std::vector<std::filesystem::path>& files) {
  const std::vector<long long> steps = steps_of(files);
  std::vector<int> moments(files.size());
  std::iota(moments.begin(), moments.end(), 0);
  if (steps.empty() || !are_lost(steps)) return moments;
  std::ranges::transform(steps, moments.begin(),
                         [](long long step) { return static_cast<int>(step); });
  return moments;
}

std::optional<std::size_t> other_moment(const std::vector<std::filesystem::path>& one,
                                        const std::vector<std::filesystem::path>& other) {
  const std::vector<int> moments = moments_by_names(one), others = moments_by_names(other);
  const auto differ = std::ranges::mismatch(moments, others).in1;
  if (differ == moments.end()) return std::nullopt;
  return static_cast<std::size_t>(differ - moments.begin());
}

void require_same_moments(const Value& value, const std::vector<std::filesystem::path>& one,
                          const std::vector<std::filesystem::path>& other, const char* expected) {
  const auto frame = other_moment(one, other);
  if (!frame) return;
  value.fail(fmt::format("has {} beside {}, of another moment by the numbers in their names",
                         one[*frame].filename().string(), other[*frame].filename().string()),
             expected);
}

std::string gap_doubt(const std::vector<std::filesystem::path>& files) {
  const std::vector<long long> steps = steps_of(files);
  if (steps.empty() || missing_of(steps) == 0) return {};
  if (!are_lost(steps)) {
    return fmt::format(
        "the numbers in the names of {} pictures lack {}: they are no count of frames, and frames "
        "are taken for one after the other (`rate`)",
        files.size(), missing_of(steps));
  }
  const auto gap = std::ranges::adjacent_find(
      steps, [](long long one, long long next) { return next != one + 1; });
  const auto before = files.begin() + (gap - steps.begin());
  return fmt::format(
      "{} comes after {}: by the numbers in their names {} of the frames are missing, and those "
      "after a gap count as taken so much later (`rate`); where none was lost, number them without "
      "a gap",
      (before + 1)->string(), before->filename().string(), missing_of(steps));
}

}  // namespace pliant
