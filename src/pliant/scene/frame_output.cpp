#include "pliant/scene/frame_output.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace pliant {
namespace {

// Where nothing is said, dynamics write about 25 frames a second.
constexpr double kUsualPeriod = 40e-3;

// Frames may miss a step by so much of it: 41.667 ms are 8 steps of 5.2083 ms.
constexpr double kOnStep = 1e-3;

double default_period(const Stepping& stepping) {
  if (stepping.kind == SimulationKind::quasi_static) return stepping.step;
  const double steps = std::ceil(kUsualPeriod / stepping.step * (1 - kOnStep));
  return std::min(steps, static_cast<double>(stepping.step_count())) * stepping.step;
}

double read_period(const Value& value, const Stepping& stepping) {
  const double period = value.positive_quantity(Dimension::time);
  const double steps = period / stepping.step;
  const bool on_step = std::abs(steps - std::round(steps)) <= kOnStep && std::round(steps) >= 1;
  if (!on_step && !stepping.adaptive) {
    value.fail(
        fmt::format("{} is no multiple of the step", format_quantity(period, Dimension::time)),
        "a multiple of " + format_quantity(stepping.step, Dimension::time));
  }
  if (period > stepping.step_count() * stepping.step * (1 + kOnStep)) {
    value.fail(
        fmt::format("{} is longer than the simulation", format_quantity(period, Dimension::time)),
        "at most " + format_quantity(stepping.duration, Dimension::time));
  }
  return period;
}

/// The elements of a list of choices, each of which stands there once.
template <class Read>
auto read_choices(const Value& list, Read read) {
  std::vector<decltype(read(list))> choices;
  for (const Value& item : list.items()) {
    const auto choice = read(item);
    if (std::find(choices.begin(), choices.end(), choice) != choices.end()) {
      item.fail(quoted_value(item.text()) + " is listed twice", "each once");
    }
    choices.push_back(choice);
  }
  return choices;
}

FrameFormat read_format(const Value& value) {
  const std::string name = value.choice({"ply", "vtu", "pc2"});
  if (name == "ply") return FrameFormat::ply;
  return name == "vtu" ? FrameFormat::vtu : FrameFormat::pc2;
}

FrameField read_field(const Value& value) {
  return value.choice({"strain", "friction"}) == "strain" ? FrameField::strain
                                                          : FrameField::friction;
}

}  // namespace

FrameOutput read_frame_output(const std::optional<Value>& value, const Stepping& stepping) {
  FrameOutput output;
  output.every = default_period(stepping);
  if (!value) return output;
  Fields fields = value->fields();
  if (auto v = fields.optional("every")) output.every = read_period(*v, stepping);
  if (auto v = fields.optional("formats")) {
    output.formats = read_choices(*v, read_format);
    if (output.formats.empty()) v->fail("is empty", "at least one format");
  }
  if (auto v = fields.optional("fields")) output.fields = read_choices(*v, read_field);
  fields.finish();
  return output;
}

int steps_per_frame(const FrameOutput& output, const Stepping& stepping) {
  return std::max(1, static_cast<int>(std::lround(output.every / stepping.step)));
}

}  // namespace pliant
