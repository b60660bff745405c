#include "pliant/study/told_sizes.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "pliant/measurement/tester_preamble.h"

namespace pliant {
namespace {

/// What the files tell of a field; none where one of them does not, or tells something else.
std::optional<TesterFact> told_by_all(const DataSource& data, std::string_view field) {
  std::optional<TesterFact> told;
  for (const std::filesystem::path& file : data.files) {
    const std::vector<TesterFact> facts = tester_facts(read_csv(file, data.csv).preamble());
    const TesterFact* fact = find_fact(facts, field);
    if (!fact || (told && told->value != fact->value)) return std::nullopt;
    if (!told) told = *fact;
  }
  return told;
}

/// A size above zero with where it is told.
struct ToldSize {
  double value;       // m
  std::string where;  // "200 mm from line 2 of pull.csv (Length;200;mm)"
};

std::optional<ToldSize> told_size(const ExperimentSpec& experiment, std::string_view field) {
  std::optional<TesterFact> told;
  try {
    told = told_by_all(experiment.data, field);
  } catch (const InputError&) {
    return std::nullopt;  // whoever reads the rows says what is wrong
  }
  const double value = told ? parse_quantity(told->value, Dimension::length) : 0;
  if (value <= 0) return std::nullopt;
  return ToldSize{value, fmt::format("{} from line {} of {} ({})", told->value, told->line,
                                     experiment.data.files.front().filename().string(),
                                     one_line(told->written, 80))};
}

void add_told(std::string_view field, double& size, ExperimentSpec& experiment) {
  const std::optional<ToldSize> told = told_size(experiment, field);
  if (!told) return;
  size = told->value;
  experiment.told.push_back(fmt::format("the study states no {}: {}", field, told->where));
}

void add_doubt(std::string_view field, double stated, ExperimentSpec& experiment) {
  constexpr double kAgreement = 0.05;  // a pretension moves the clamps by less
  if (stated <= 0) return;
  const std::optional<ToldSize> told = told_size(experiment, field);
  if (!told || std::abs(told->value - stated) <= kAgreement * stated) return;
  experiment.doubts.push_back(
      fmt::format("the study states a {} of {}, the data {}: which is right?", field,
                  format_quantity(stated, Dimension::length), told->where));
}

}  // namespace

SpecimenDefaults with_told_sizes(SpecimenDefaults defaults, const Fields& fields,
                                 const TestType& type, ExperimentSpec& experiment) {
  const std::vector<std::string> given = fields.keys();
  const auto is_missing = [&](std::string_view field, double size) {
    return size == 0 && std::ranges::find(type.required, field) != type.required.end() &&
           std::ranges::find(given, field) == given.end();
  };
  if (is_missing("length", defaults.length)) add_told("length", defaults.length, experiment);
  if (is_missing("width", defaults.width)) add_told("width", defaults.width, experiment);
  return defaults;
}

void doubt_stated_sizes(ExperimentSpec& experiment) {
  add_doubt("length", experiment.test->length, experiment);
  add_doubt("width", experiment.test->width, experiment);
}

}  // namespace pliant
