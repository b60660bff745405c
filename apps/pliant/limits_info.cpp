#include "apps/pliant/limits_info.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/number_text.h"
#include "pliant/material/solid/principal_metric.h"
#include "pliant/math/root.h"

namespace pliant {
namespace {

/// The first strain of some sign at which a law has an energy; nothing below the largest strains.
std::optional<double> strain_of_energy(const ComponentLaw& law, double energy, double sign) {
  constexpr double kFirst = 1e-6, kMore = 1.05, kLast = 1e4, kLeast = -1;
  double below = 0;
  for (double size = kFirst; size < kLast; size *= kMore) {
    const double strain = sign * size;
    if (strain <= kLeast) return std::nullopt;
    if (!(law.elastic_energy(strain) >= energy)) {
      below = strain;
      continue;
    }
    return root_in_bracket([&](double at) { return law.elastic_energy(at) - energy; },
                           std::min(below, strain), std::max(below, strain));
  }
  return std::nullopt;
}

std::vector<double> strains_of(const Material& material, const EnergyLimit& limit) {
  std::vector<double> strains;
  const std::string& component = limit.of.front();
  if (limit.of.size() > 1 || find_principal_metric(component)) return strains;
  for (const double sign : {-1.0, 1.0}) {
    const auto strain = strain_of_energy(*law_of(material, component), limit.energy, sign);
    if (strain) strains.push_back(*strain);
  }
  return strains;
}

}  // namespace

void add_limits(const Material& material, FileInfo& info) {
  if (material.limits.empty()) return;
  const bool solid = material.kind == MaterialKind::solid;
  Json list = Json::array();
  for (const EnergyLimit& limit : material.limits) {
    const std::vector<double> strains = strains_of(material, limit);
    std::string text =
        fmt::format("the energy of {} stays below {} {}", fmt::join(limit.of, " and "),
                    format_number(limit.energy, kInfoDigits), solid ? "J/m^3" : "J/m^2");
    std::vector<std::string> texts;
    for (const double strain : strains) texts.push_back(format_number(strain, kInfoDigits));
    if (!texts.empty()) {
      text += fmt::format(": strains up to {}", fmt::join(texts, " and "));
    }
    info.lines.push_back(labelled("limit", text));
    list.push_back({{"of", limit.of}, {"energy", limit.energy}, {"strains", strains}});
  }
  info.json["limits"] = std::move(list);
}

}  // namespace pliant
