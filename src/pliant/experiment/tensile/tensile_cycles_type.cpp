#include "pliant/experiment/tensile/tensile_cycles_type.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "pliant/experiment/clamp_column.h"
#include "pliant/experiment/tensile/tensile_cycles.h"

namespace pliant {
namespace {

constexpr double kSameAngle = 1e-6;  // rad, of the direction in which a strip is cut

// A strip may be cut at any angle; those of weft, bias and warp are these directions.
void read_cut(const Value& value, std::string& direction, TensileCyclesSpec& spec) {
  const std::string text = value.text();
  if (text.find_first_of("0123456789") == std::string::npos) {
    direction = value.choice({"warp", "weft", "bias"});
    return;
  }
  const double angle = value.quantity_from_zero(Dimension::angle);
  if (angle >= std::numbers::pi - kSameAngle) {
    value.fail(quoted_value(text) + " is no angle of a strip", "0 deg to less than 180 deg");
  }
  for (const auto& [name, eighths] : {std::pair{"weft", 0}, {"bias", 2}, {"warp", 4}}) {
    if (std::abs(angle - eighths * std::numbers::pi / 8) < kSameAngle) direction = name;
  }
  if (!direction.empty()) return;
  direction = text;
  spec.oblique_angle = angle;
}

void read_after(Fields& fields, ExperimentSpec& experiment, TensileCyclesSpec& spec) {
  const auto after = fields.optional("after");
  const auto start = fields.optional("initial_friction");
  spec.initial_friction = read_initial_friction(fields);
  if (!after) return;
  experiment.after = after->text();
  if (start && spec.initial_friction == InitialFriction::unknown) {
    start->fail("is unknown, and the strip starts as the test before has left it",
                "`after` without `initial_friction`");
  }
  spec.initial_friction = InitialFriction::rest;
}

std::shared_ptr<const TestSpec> read(Fields& fields, const SpecimenDefaults& defaults,
                                     ExperimentSpec& experiment) {
  auto spec = std::make_shared<TensileCyclesSpec>();
  read_cut(fields.require("direction"), experiment.direction, *spec);
  read_strip(fields, defaults, *spec);
  spec->pretension = read_from_zero(fields, "pretension", Dimension::force);
  spec->apparatus_friction = read_from_zero(fields, "apparatus_friction", Dimension::force);
  if (auto v = fields.optional("precondition_cycles")) {
    spec->precondition_cycles = v->integer(0, 1000);
  }
  read_after(fields, experiment, *spec);
  spec->rest_length = read_rest_length(fields, spec->pretension);
  spec->clamps = read_clamps(fields, defaults.clamps);
  return spec;
}

std::shared_ptr<VirtualTest> read_virtual(Fields& fields) {
  auto test = std::make_shared<VirtualTensileCycles>();
  test->direction = read_direction(fields);
  read_virtual_size(fields, *test);
  read_samples(fields, *test);
  read_duration(fields, *test);
  test->slack = read_from_zero(fields, "slack", Dimension::length);
  test->clamps.slip = read_from_zero(fields, "slip", Dimension::compliance);
  test->clamps.compliance = read_from_zero(fields, "compliance", Dimension::compliance);
  if (const auto v = fields.optional("after")) test->after = v->text();
  read_cycles(fields, Dimension::fraction, *test);
  return test;
}

}  // namespace

const TestType& tensile_cycles_type() {
  static const TestType type{.name = "tensile-cycles",
                             .facts = {.deformation = Deformation::stretch,
                                       .may_be_sheet = true,
                                       .follows_time = true,
                                       .unfitted = kUnfittedStrip},
                             .channels = {force_channel(), length_channel()},
                             .template_files = template_files("tensile"),
                             .required = {"direction", "length", "width"},
                             .read = read,
                             .make = make_experiment<TensileCycles>,
                             .read_virtual = read_virtual,
                             .is_table = [](const TableColumns& columns) {
                               return (columns.has("force", Dimension::force) ||
                                       columns.has("force", Dimension::force_per_length)) &&
                                      has_clamp_column(columns);
                             }};
  return type;
}

WrittenFields TensileCyclesSpec::fields() const {
  WrittenFields fields = written_size(*this);
  fields.emplace_back("pretension", exact_quantity(pretension, Dimension::force));
  fields.emplace_back("apparatus_friction", exact_quantity(apparatus_friction, Dimension::force));
  fields.emplace_back("precondition_cycles", std::to_string(precondition_cycles));
  fields.push_back(written(rest_length));
  fields.push_back(written(initial_friction));
  std::ranges::move(written(clamps), std::back_inserter(fields));
  return fields;
}

TensileCycles VirtualTensileCycles::pulled(const SampledPath& path, const ClothFacts& cloth) const {
  TensileCycles pull({length, width, cloth.membrane}, path, clamps);
  if (before) {
    const auto& earlier = dynamic_cast<const VirtualTensileCycles&>(*before);
    pull.follow(earlier.pulled(earlier.timed(earlier.clamp_path(1)), cloth), where);
  }
  return pull;
}

std::string VirtualTensileCycles::rows(const ComponentLaw& law, const ClothFacts& cloth,
                                       RandomStream& random) const {
  const SampledPath path = timed(clamp_path(1));
  const Prediction pulled = predicted(this->pulled(path, cloth), law);
  return table_text(with_times({{"force_N", {pulled.value.begin(), pulled.value.end()}, 1, force()},
                                {"length_mm", path.value, 1e3, lengths()},
                                {"cycle", {path.cycle.begin(), path.cycle.end()}}},
                               path),
                    random);
}

WrittenFields VirtualTensileCycles::study_fields() const {
  WrittenFields fields = VirtualTable::study_fields();
  fields.emplace_back("initial_friction", "rest");
  if (before) fields.emplace_back("after", before->name);
  return fields;
}

WrittenFields VirtualTensileCycles::own_description() const {
  WrittenFields description{{"strip", size_text()},
                            {"peaks", sequence_text(peaks, Dimension::fraction)}};
  if (clamps.slip > 0 || clamps.compliance > 0) {
    std::ranges::move(written(clamps), std::back_inserter(description));
  }
  if (before) description.emplace_back("after", before->name);
  return description;
}

}  // namespace pliant
