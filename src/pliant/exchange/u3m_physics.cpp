#include "pliant/exchange/u3m_physics.h"

#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/assert.h"
#include "pliant/base/errors.h"
#include "pliant/base/number_text.h"
#include "pliant/base/quantity.h"
#include "pliant/experiment/buckling/buckling_bend_type.h"
#include "pliant/experiment/tensile/tensile_cycles_type.h"

namespace pliant {
namespace {

constexpr double kCentimetre = 1e-2;
constexpr double kGramForce = 1e-3 * kStandardGravity;
constexpr double kGramPerSquareMetre = 1e-3;

// Beyond what the instrument or any fabric can reach: the value is no measurement.
constexpr double kMaxCentimetres = 1e3;
constexpr double kMaxGramForce = 1e6;
constexpr double kMaxDensity = 1e5;             // g/m^2
constexpr double kMaxFrequency = 1e6;           // Hz
constexpr double kMaxTime = 253'402'300'799.0;  // 9999-12-31, in s since 1970

constexpr std::size_t kFewestSamples = 3;  // fewer show no curve

struct TestLabel {
  const char* label;
  const char* name;
  U3mTestKind kind;
  double nominal_length;  // cm
};

constexpr TestLabel kTests[] = {{"S2", "stretch-8cm", U3mTestKind::stretch, 8},
                                {"S1", "stretch-2cm", U3mTestKind::stretch, 2},
                                {"D2", "bend-down-8cm", U3mTestKind::bend_down, 8},
                                {"D1", "bend-down-2cm", U3mTestKind::bend_down, 2},
                                {"U1", "bend-up-2cm", U3mTestKind::bend_up, 2}};

struct DirectionLabel {
  const char* label;
  const char* name;
};

// "Length" and "width" grain line: along the warp (wale) and the weft (course).
constexpr DirectionLabel kDirections[] = {{"L", "warp"}, {"W", "weft"}, {"B", "bias"}};

[[noreturn]] void fail_out_of_range(const Value& value, const std::string& expected) {
  value.fail(quoted_value(value.text()) + " is out of range", expected);
}

[[noreturn]] void fail_without_measurements(const Location& where) {
  throw InputError(where, "has no raw measurements",
                   "raw_data with at least one of L, W, B and samples in it");
}

double positive_number(const Value& value, double high, std::string_view what) {
  const double number = value.number();
  if (number <= 0 || number > high) {
    fail_out_of_range(value, fmt::format("{} above 0 and at most {}", what, format_number(high)));
  }
  return number;
}

double positive_length(const Value& value, std::string_view what) {
  return positive_number(value, kMaxCentimetres, fmt::format("{} in cm,", what)) * kCentimetre;
}

std::optional<Value> first_of(Fields& fields, Fields& fallback, std::string_view key) {
  if (auto value = fields.optional(key)) return value;
  return fallback.optional(key);
}

/// A flat list x0, F0, x1, F1, ... of distances (cm) and forces (gram-force).
/// @param apart  clamps that stand apart; those that press meet, give or take the resolution
U3mSegment read_segment(const Value& list, bool apart) {
  const std::vector<double> values = list.numbers();
  if (values.size() % 2 != 0) {
    list.fail(fmt::format("has {} values", values.size()), "pairs of distance and force");
  }
  U3mSegment segment;
  for (std::size_t i = 0; i < values.size(); i += 2) {
    const double distance = values[i], force = values[i + 1];
    if ((apart && distance <= 0) || std::abs(distance) > kMaxCentimetres) {
      fail_out_of_range(list.items()[i], "a distance in cm, above 0 and at most 1000");
    }
    if (std::abs(force) > kMaxGramForce) {
      fail_out_of_range(list.items()[i + 1], "a force in gram-force, at most 1e6");
    }
    segment.distance.push_back(distance * kCentimetre);
    segment.force.push_back(force * kGramForce);
  }
  return segment;
}

std::vector<U3mSegment> read_segments(const Value& tree) {
  std::vector<U3mSegment> segments;
  for (const Value& list : tree.items()) segments.push_back(read_segment(list, true));
  return segments;
}

std::size_t sample_count(const std::vector<U3mSegment>& segments) {
  std::size_t count = 0;
  for (const U3mSegment& segment : segments) count += segment.distance.size();
  return count;
}

std::optional<std::int64_t> read_time(const std::optional<Value>& value) {
  if (!value) return std::nullopt;
  const double seconds = value->number();
  if (seconds < 0 || seconds > kMaxTime) {
    fail_out_of_range(*value, "seconds since 1970-01-01 (time_t), up to the year 9999");
  }
  if (seconds == 0) return std::nullopt;  // a clock that was never set
  return static_cast<std::int64_t>(seconds);
}

std::optional<U3mTest> read_test(const Value& value, const TestLabel& label, Fields& direction,
                                 const std::string& full_name, std::vector<std::string>& warnings) {
  Fields fields = value.fields();
  U3mTest test;
  test.kind = label.kind;
  test.name = label.name;
  if (const auto tree = fields.optional("samplesTree")) test.segments = read_segments(*tree);
  const std::size_t samples = sample_count(test.segments);
  if (samples < kFewestSamples) {
    warnings.push_back(fmt::format("{} is left out: {} samples show no curve", full_name, samples));
    return std::nullopt;
  }
  if (const auto length = fields.optional("length")) {
    test.length = positive_length(*length, "the clamp distance");
  } else {
    test.length = label.nominal_length * kCentimetre;
    warnings.push_back(fmt::format("{}: the file has no clamp distance; the nominal {} cm is taken",
                                   full_name, format_number(label.nominal_length)));
  }
  if (const auto width = first_of(fields, direction, "width")) {
    test.width = positive_length(*width, "the strip's width");
  }
  if (const auto frequency = fields.optional("freq")) {
    test.frequency = positive_number(*frequency, kMaxFrequency, "a sampling rate in Hz,");
  }
  test.time = read_time(fields.optional("time"));
  return test;
}

std::vector<U3mDirection> read_directions(Fields& raw, std::vector<std::string>& warnings) {
  std::vector<U3mDirection> directions;
  for (const DirectionLabel& label : kDirections) {
    const std::optional<Value> value = raw.optional(label.label);
    if (!value) {
      warnings.push_back(fmt::format("nothing was measured along the {}: the file has no {}",
                                     label.name, label.label));
      continue;
    }
    Fields fields = value->fields();
    U3mDirection direction{label.name, {}};
    for (const TestLabel& test : kTests) {
      const std::string full_name = fmt::format("{}-{}", label.name, test.name);
      const std::optional<Value> measured = fields.optional(test.label);
      if (!measured) {
        warnings.push_back(fmt::format("{} is missing: {} of the file has no {}", full_name,
                                       label.label, test.label));
        continue;
      }
      if (auto read = read_test(*measured, test, fields, full_name, warnings)) {
        direction.tests.push_back(std::move(*read));
      }
    }
    if (!direction.tests.empty()) directions.push_back(std::move(direction));
  }
  return directions;
}

/// The first sample of the first compression: the lightest touch before the fabric is compacted.
std::optional<U3mThickness> read_thickness(const std::optional<Value>& segments) {
  if (!segments || segments->items().empty()) return std::nullopt;
  const U3mSegment first = read_segment(segments->items().front(), false);
  if (first.distance.empty() || first.distance.front() <= 0) return std::nullopt;
  return U3mThickness{first.distance.front(), std::abs(first.force.front())};
}

/// @param material_weight  the material description repeats the mass per area, in the same unit
double read_density(Fields& raw, const std::optional<Value>& material_weight,
                    std::vector<std::string>& warnings) {
  std::optional<Value> mass = raw.optional("M");
  if (!mass) mass = material_weight;
  if (!mass) {
    warnings.push_back("the file has no mass per area (M): the density is left out");
    return 0;
  }
  return positive_number(*mass, kMaxDensity, "a mass in g/m^2,") * kGramPerSquareMetre;
}

Fields require_raw_data(Fields& physics) {
  const std::optional<Value> raw = physics.optional("raw_data");
  if (!raw) {
    Location where = physics.location();
    where.field = where.field.empty() ? "raw_data" : where.field + ".raw_data";
    fail_without_measurements(where);
  }
  return raw->fields();
}

/// The samples mean the same in every minor version so far.
void check_version(const std::optional<Value>& schema, std::vector<std::string>& warnings) {
  if (!schema) {
    warnings.push_back("the file does not say its version (schema): read as U3M 1.1");
    return;
  }
  const std::string version = schema->text();
  if (!version.starts_with("1.")) schema->fail(quoted_value(version), "\"1.1\"");
  if (version != "1.1") {
    warnings.push_back(fmt::format("version {} of U3M is read as 1.1", quoted_value(version)));
  }
}

}  // namespace

const TestType& test_type_of(const U3mTest& test) {
  return test.kind == U3mTestKind::stretch ? tensile_cycles_type() : buckling_bend_type();
}

U3mPhysics read_u3m_physics(const U3mFile& file) {
  const std::optional<Value> found = find_physics(file.physics);
  PLIANT_ASSERT(found.has_value(), "the file has a physics record");
  Fields fields = found->fields();
  U3mPhysics physics;
  check_version(fields.optional("schema"), physics.warnings);

  Fields raw = require_raw_data(fields);
  physics.density =
      read_density(raw, find_value(find_material(file), {"physics", "weight"}), physics.warnings);
  physics.directions = read_directions(raw, physics.warnings);
  if (physics.directions.empty()) fail_without_measurements(raw.location());
  physics.thickness = read_thickness(find_value(found, {"raw_data", "T", "samplesTree"}));
  return physics;
}

}  // namespace pliant
