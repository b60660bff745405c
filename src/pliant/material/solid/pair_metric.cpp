#include "pliant/material/solid/pair_metric.h"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/number_text.h"

namespace pliant {
namespace {

constexpr std::array<std::string_view, kSolidStrains> kGreenNames{
    "green.xx", "green.yy", "green.zz", "green.yz", "green.xz", "green.xy"};

std::optional<int> green_column(std::string_view name) {
  for (int i = 0; i < kSolidStrains; ++i) {
    if (kGreenNames[static_cast<std::size_t>(i)] == name) return i;
  }
  return std::nullopt;
}

// The text before a separator; `rest` becomes what follows it.
std::optional<std::string_view> cut_before(std::string_view& rest, char separator) {
  const std::size_t at = rest.find(separator);
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view before = rest.substr(0, at);
  rest.remove_prefix(at + 1);
  return before;
}

std::optional<PairMetric::Bump> bump_of(std::string_view text) {
  const auto first = cut_before(text, '/'), second = cut_before(text, '~'),
             third = cut_before(text, '/');
  if (!first || !second || !third) return std::nullopt;
  const auto x = parse_number(*first), y = parse_number(*second);
  const auto v = parse_number(*third), w = parse_number(text);
  if (!x || !y || !v || !w || *v <= 0 || *w <= 0) return std::nullopt;
  return PairMetric::Bump{{*x, *y}, {*v, *w}};
}

// One factor: the strain itself, or g(x - x0) - g(x0).
MetricJet pair_factor(const LaneView& strain, int column, const std::optional<PairMetric::Bump>& bump,
                 std::size_t side) {
  MetricJet jet;
  jet.value = strain.col(column);
  jet.gradient.col(column) = 1;
  if (!bump) return jet;
  const double place = bump->place[side], square = bump->width[side] * bump->width[side];
  const Lane way = jet.value - place;
  const Lane gauss = (-way.square() / (2 * square)).exp();
  const double at_rest = std::exp(-place * place / (2 * square));
  return composed(jet, gauss - at_rest, -way / square * gauss,
                  (way.square() / square - 1) / square * gauss);
}

}  // namespace

MetricJet PairMetric::jet(const LaneView& strain) const {
  return product(pair_factor(strain, strains[0], bump, 0), pair_factor(strain, strains[1], bump, 1));
}

std::array<std::string, 2> PairMetric::of() const {
  return {std::string(kGreenNames[static_cast<std::size_t>(strains[0])]),
          std::string(kGreenNames[static_cast<std::size_t>(strains[1])])};
}

std::string PairMetric::name() const {
  std::string name = fmt::format("{}", fmt::join(of(), "*"));
  if (bump) name += fmt::format("@{}/{}~{}/{}", format_number(bump->place[0]),
                               format_number(bump->place[1]), format_number(bump->width[0]), format_number(bump->width[1]));
  return name;
}

std::optional<PairMetric> find_pair_metric(std::string_view name) {
  PairMetric metric;
  const auto first = cut_before(name, '*');
  if (!first) return std::nullopt;
  const std::size_t at = name.find('@');
  const auto x = green_column(*first), y = green_column(name.substr(0, at));
  if (!x || !y || *x >= *y) return std::nullopt;
  metric.strains = {*x, *y};
  if (at == std::string_view::npos) return metric;
  metric.bump = bump_of(name.substr(at + 1));
  return metric.bump ? std::optional(metric) : std::nullopt;
}

}  // namespace pliant
