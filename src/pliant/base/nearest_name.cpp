#include "pliant/base/nearest_name.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace pliant {
namespace {

constexpr std::size_t kMaxWordSize = 200;  // longer words are no slips of a known name
constexpr std::size_t kMaxNamesShown = 24;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Insertions, deletions, replacements and exchanges of neighbours (optimal string alignment),
/// letters' case aside.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  const auto same = [&](std::size_t i, std::size_t j) { return lower(a[i]) == lower(b[j]); };
  std::vector<std::size_t> before, above, row(b.size() + 1);  // two rows above, one above, this
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    before = std::exchange(above, row);
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = above[j] + (same(i, j) ? 0 : 1);
      row[j + 1] = std::min({replaced, row[j] + 1, above[j + 1] + 1});
      const bool exchanged = i > 0 && j > 0 && same(i, j - 1) && same(i - 1, j);
      if (exchanged) row[j + 1] = std::min(row[j + 1], before[j - 1] + 1);
    }
  }
  return row.back();
}

template <typename Name>
std::string nearest(std::string_view word, std::span<const Name> candidates) {
  if (word.size() > kMaxWordSize) return {};
  std::string_view best;
  std::size_t best_distance = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string_view candidate : candidates) {
    if (candidate.size() > kMaxWordSize) continue;
    const std::size_t distance = edit_distance(word, candidate);
    if (distance >= best_distance) continue;
    best = candidate;
    best_distance = distance;
  }
  return std::string(best);
}

}  // namespace

std::string nearest_name(std::string_view word, std::span<const std::string> candidates) {
  return nearest(word, candidates);
}

std::string nearest_name(std::string_view word, std::span<const std::string_view> candidates) {
  return nearest(word, candidates);
}

std::string did_you_mean(std::string_view word, std::span<const std::string> candidates) {
  const std::string name = nearest_name(word, candidates);
  return name.empty() ? name : " (did you mean \"" + name + "\"?)";
}

std::string list_of_names(std::span<const std::string> names) {
  const std::size_t shown = std::min(names.size(), kMaxNamesShown);
  std::string list;
  for (std::size_t i = 0; i < shown; ++i) {
    const bool last = i + 1 == names.size();
    if (i > 0) list += last ? " or " : ", ";
    list += '"' + names[i] + '"';
  }
  if (shown < names.size()) list += ", ...";
  return list;
}

}  // namespace pliant
