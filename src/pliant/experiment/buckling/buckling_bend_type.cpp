#include "pliant/experiment/buckling/buckling_bend_type.h"

#include <fmt/format.h>

#include "pliant/experiment/buckling/buckling_bend.h"

namespace pliant {
namespace {

// Of a virtual test, shares of the length: where the clamps start, and how far they may come.
constexpr double kSlack = 0.02;
constexpr double kNearest = 0.9;

BucklingSide read_side(Fields& fields) {
  const bool up = fields.require("side").choice({"down", "up"}) == "up";
  return up ? BucklingSide::up : BucklingSide::down;
}

std::shared_ptr<const TestSpec> read(Fields& fields, const SpecimenDefaults& defaults,
                                     ExperimentSpec& experiment) {
  auto spec = std::make_shared<BucklingBendSpec>();
  experiment.direction = read_direction(fields);
  read_strip(fields, defaults, *spec);
  spec->side = read_side(fields);
  spec->rest_length = read_rest_length(fields, 0);
  return spec;
}

void read_strip_length(Fields& fields, VirtualBucklingBend& test) {
  test.strip_length = test.length;
  const auto v = fields.optional("strip_length");
  if (!v) return;
  test.strip_length = v->positive_quantity(Dimension::length);
  if (test.strip_length > test.length - test.slack) return;
  v->fail("is not above the distance at which the clamps start", "a strip that buckles there");
}

void require_approaches(const std::vector<Value>& peaks, const VirtualBucklingBend& test) {
  for (size_t i = 0; i < peaks.size(); ++i) {
    const double share = test.peaks[i];
    if (share < kNearest && share * test.length > test.slack) continue;
    peaks[i].fail("is no approach of the clamps from where they start",
                  "a share of the length above `slack` and below 90 %");
  }
}

std::shared_ptr<VirtualTest> read_virtual(Fields& fields) {
  auto test = std::make_shared<VirtualBucklingBend>();
  test->direction = read_direction(fields);
  test->length = fields.require("length").positive_quantity(Dimension::length);
  if (auto v = fields.optional("width")) test->width = v->positive_quantity(Dimension::length);
  read_samples(fields, *test);
  test->side = read_side(fields);
  test->slack = kSlack * test->length;
  if (auto v = fields.optional("slack")) test->slack = v->positive_quantity(Dimension::length);
  read_strip_length(fields, *test);
  if (auto v = fields.optional("force_offset")) test->force_offset = v->quantity(Dimension::force);
  if (auto v = fields.optional("force_drift")) test->force_drift = v->quantity(Dimension::force);
  read_cycles(fields, Dimension::fraction, *test);
  require_approaches(fields.require("peaks").items(), *test);
  return test;
}

}  // namespace

const TestType& buckling_bend_type() {
  static const TestType type{
      .name = "buckling-bend",
      .facts = {.deformation = Deformation::bend,
                .needs_density = true,
                .has_unknown_zero = true,
                .stiffness = CurveKind::constant,
                .assumption = "the strip bends in a plane, is clamped level and flat and does not "
                              "stretch or touch itself; it starts straight and free of friction; "
                              "the zero of the force drifts evenly from row to row",
                .unfitted = "the strip is as long as stated, but offset and drift of the force are "
                            "those that fit its record best"},
      .channels = {force_channel(), length_channel()},
      .template_files = template_files("buckling"),
      .required = {"direction", "side", "length", "width"},
      .read = read,
      .make = make_experiment<BucklingBend>,
      .read_virtual = read_virtual,
      .is_table = [](const TableColumns& columns) {
        return columns.has("force", Dimension::force) && columns.has("distance", Dimension::length);
      }};
  return type;
}

WrittenFields BucklingBendSpec::fields() const {
  WrittenFields fields = written_size(*this);
  fields.emplace_back("side", name_of(side));
  fields.push_back(written(rest_length));
  return fields;
}

std::string VirtualBucklingBend::rows(const ComponentLaw& law, const ClothFacts& cloth,
                                      RandomStream& random) const {
  constexpr int kElements = 6;  // a fit takes 2
  const SampledPath path = clamp_path(-1);
  const BucklingBend buckled({strip_length, width, cloth.density, side, kElements}, path);
  const auto prediction =
      buckled.predict(law, Eigen::Vector2d(force_offset, force_drift), /*with_jacobian=*/false);
  if (!prediction) fail("between its clamps the strip finds no equilibrium; its force");

  const Eigen::VectorXd& pulled = prediction->value;
  return table_text({{"force_N", {pulled.begin(), pulled.end()}, 1, force()},
                     {"distance_mm", path.value, 1e3, lengths()},
                     {"cycle", {path.cycle.begin(), path.cycle.end()}}},
                    random);
}

WrittenFields VirtualBucklingBend::study_fields() const {
  WrittenFields fields = VirtualTable::study_fields();
  fields.emplace_back("side", name_of(side));
  if (strip_length != length) fields.emplace_back("rest_length", "unknown");
  return fields;
}

WrittenFields VirtualBucklingBend::own_description() const {
  constexpr int kDigits = 4;
  return {{"strip", size_text()},
          {"buckles", fmt::format("{}; {} long in truth, force offset {}, drift {}", name_of(side),
                                  format_quantity(strip_length, Dimension::length, kDigits),
                                  format_quantity(force_offset, Dimension::force, kDigits),
                                  format_quantity(force_drift, Dimension::force, kDigits))},
          {"peaks", sequence_text(peaks, Dimension::fraction)}};
}

}  // namespace pliant
