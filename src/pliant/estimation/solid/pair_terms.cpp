#include "pliant/estimation/solid/pair_terms.h"

#include <algorithm>

#include "pliant/base/assert.h"
#include "pliant/base/number_text.h"
#include "pliant/estimation/solid/energy_growth.h"

namespace pliant {
namespace {

constexpr int kNameDigits = 4;  // of places and widths: names are read by people

double rounded(double value) { return *parse_number(format_number(value, kNameDigits)); }

}  // namespace

std::vector<PairMetric> gaussians_at(PairMetric pair,
                                     const std::array<std::vector<double>, 2>& places,
                                     const std::array<double, 2>& width) {
  std::vector<PairMetric> terms;
  for (const double x : places[0]) {
    for (const double y : places[1]) {
      pair.bump =
          PairMetric::Bump{{rounded(x), rounded(y)}, {rounded(width[0]), rounded(width[1])}};
      terms.push_back(pair);
    }
  }
  return terms;
}

std::vector<std::string> gaussian_terms(const std::string& pair, int count, SolidProblem& problem) {
  const std::optional<PairMetric> metric = find_pair_metric(pair);
  PLIANT_ASSERT(metric && !metric->bump, "a pair of strains");
  std::array<std::vector<double>, 2> places;
  std::array<double, 2> width{};
  for (std::size_t side = 0; side < 2; ++side) {
    const MetricData& data = problem.data_of(metric->of()[side]);
    if (!data.is_seen()) return {};
    places[side] = energy_places(data, /*even=*/false, count);
    width[side] = (std::max(data.high(), 0.0) - std::min(data.low(), 0.0)) / count;
  }
  std::vector<std::string> names;
  for (const PairMetric& term : gaussians_at(*metric, places, width)) names.push_back(term.name());
  return names;
}

}  // namespace pliant
