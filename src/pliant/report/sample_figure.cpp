#include "pliant/report/sample_figure.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "pliant/report/plot_style.h"
#include "pliant/report/readable_unit.h"

namespace pliant::report {
namespace {

using nlohmann::json;

constexpr SeriesStyle kKnown = {"known", "sample", "#00538a", nullptr, "circle-open", 6.0};
constexpr SeriesStyle kUnknown = {"unknown", "not determined", "#8a94a0",
                                  nullptr,   "x-thin-open",    6.0};

/// `samples[2].J.k` -> `J.k`; nothing for a number that is the same everywhere.
std::optional<std::string> name_of_all(const std::string& name) {
  const std::size_t end = name.find("].");
  if (!name.starts_with(kOfSample) || end == std::string::npos) return std::nullopt;
  return name.substr(end + 2);
}

/// The samples of one kind, with bars where intervals are known.
json series(const SampledNumber& number, const SeriesStyle& style, bool known) {
  std::vector<double> x, y, above, below;
  for (std::size_t i = 0; i < number.at.size(); ++i) {
    const ResultParameter& p = number.at[i];
    if (!p.value || (p.fixed || p.identified) != known) continue;
    x.push_back(static_cast<double>(i));
    y.push_back(*p.value);
    above.push_back(p.upper.value_or(*p.value) - *p.value);
    below.push_back(*p.value - p.lower.value_or(*p.value));
  }
  json drawn = trace(style, x, y);
  if (known) {
    drawn["error_y"] = {
        {"type", "data"},   {"symmetric", false},           {"color", style.color},
        {"thickness", 1.2}, {"array", plot_numbers(above)}, {"arrayminus", plot_numbers(below)}};
  }
  return drawn;
}

SampledNumber in_readable_unit(SampledNumber number) {
  double largest = 0;
  for (const ResultParameter& p : number.at) {
    largest = std::max(largest, std::abs(p.value.value_or(0)));
  }
  for (ResultParameter& p : number.at) {
    const ReadableUnit unit = readable_unit(p.unit, largest);
    for (auto* shown : {&p.value, &p.lower, &p.upper}) {
      if (*shown) **shown *= unit.factor;
    }
    p.unit = unit.name;
  }
  return number;
}

}  // namespace

std::vector<SampledNumber> sampled_numbers(const std::vector<ResultParameter>& parameters) {
  std::vector<SampledNumber> numbers;
  for (const ResultParameter& p : parameters) {
    const std::optional<std::string> name = name_of_all(p.name);
    if (!name) continue;
    auto known = std::ranges::find(numbers, *name, &SampledNumber::name);
    if (known == numbers.end()) known = numbers.insert(numbers.end(), {*name, {}});
    known->at.push_back(p);
  }
  return numbers;
}

Figure sample_figure(const SampledNumber& stated) {
  const SampledNumber number = in_readable_unit(stated);
  Figure figure;
  figure.layout = base_layout();
  figure.layout["xaxis"] = axis({"Sample", ""});
  figure.layout["xaxis"]["range"] = {-0.5, static_cast<double>(number.at.size()) - 0.5};
  figure.layout["xaxis"]["zeroline"] = false;
  if (number.at.size() < 12) figure.layout["xaxis"]["dtick"] = 1;
  figure.layout["yaxis"] = axis({number.name, shown_unit(number.at.front().unit)});
  figure.traces.push_back(series(number, kKnown, true));
  figure.traces.push_back(series(number, kUnknown, false));
  figure.description = number.name + " at each sample";
  figure.data_file = "fit.json (parameters)";
  return figure;
}

}  // namespace pliant::report
