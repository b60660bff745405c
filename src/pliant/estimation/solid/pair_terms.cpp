#include "pliant/estimation/solid/pair_terms.h"

#include <algorithm>

#include "pliant/base/assert.h"
#include "pliant/base/number_text.h"
#include "pliant/estimation/solid/energy_growth.h"
#include "pliant/material/solid/pair_metric.h"

namespace pliant {
namespace {

constexpr int kNameDigits = 4;  // of places and widths: names are read by people

double rounded(double value) { return *parse_number(format_number(value, kNameDigits)); }

}  // namespace

std::vector<std::string> gaussian_terms(const std::string& pair, int count, SolidProblem& problem) {
  std::optional<PairMetric> metric = find_pair_metric(pair);
  PLIANT_ASSERT(metric && !metric->bump, "a pair of strains");
  std::array<std::vector<double>, 2> places;
  metric->bump = PairMetric::Bump{};
  for (std::size_t side = 0; side < 2; ++side) {
    const MetricData& data = problem.data_of(metric->of()[side]);
    if (!data.is_seen()) return {};
    places[side] = energy_places(data, /*even=*/false, count);
    const double span = std::max(data.high(), 0.0) - std::min(data.low(), 0.0);
    metric->bump->width[side] = rounded(span / count);
  }
  std::vector<std::string> names;
  for (const double x : places[0]) {
    for (const double y : places[1]) {
      metric->bump->place = {rounded(x), rounded(y)};
      names.push_back(metric->name());
    }
  }
  return names;
}

}  // namespace pliant
