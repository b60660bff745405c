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

// One factor and its first two derivatives: the strain itself, or g(x - x0) - g(x0).
struct PairFactor {
  Lane value, first, second;

  PairFactor(const Lane& strain, const std::optional<PairMetric::Bump>& bump, std::size_t side)
      : value(strain), first(Lane::Ones()), second(Lane::Zero()) {
    if (!bump) return;
    const double place = bump->place[side], square = bump->width[side] * bump->width[side];
    const Lane way = strain - place;
    const Lane gauss = (-way.square() / (2 * square)).exp();
    value = gauss - std::exp(-place * place / (2 * square));
    first = -way / square * gauss;
    second = (way.square() / square - 1) / square * gauss;
  }
};

}  // namespace

MetricJet PairMetric::jet(const LaneView& strain) const {
  const auto [x, y] = strains;
  const PairFactor f(strain.col(x), bump, 0), g(strain.col(y), bump, 1);
  MetricJet jet;
  jet.value = f.value * g.value;
  jet.gradient.col(x) = f.first * g.value;
  jet.gradient.col(y) = f.value * g.first;
  jet.set_hessian(x, x, f.second * g.value);
  jet.set_hessian(y, y, f.value * g.second);
  jet.set_hessian(x, y, f.first * g.first);
  return jet;
}

std::array<std::string, 2> PairMetric::of() const {
  return {std::string(kGreenNames[static_cast<std::size_t>(strains[0])]),
          std::string(kGreenNames[static_cast<std::size_t>(strains[1])])};
}

std::string PairMetric::name() const {
  std::string name = fmt::format("{}", fmt::join(of(), "*"));
  if (bump) {
    name +=
        fmt::format("@{}/{}~{}/{}", format_number(bump->place[0]), format_number(bump->place[1]),
                    format_number(bump->width[0]), format_number(bump->width[1]));
  }
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
