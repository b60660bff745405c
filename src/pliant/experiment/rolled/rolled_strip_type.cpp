#include "pliant/experiment/rolled/rolled_strip_type.h"

#include <fmt/format.h>

#include "pliant/experiment/profile/profile_facts.h"
#include "pliant/experiment/rolled/rolled_strip.h"

namespace pliant {
namespace {

// [P] 4.3.
const std::vector<double>& published_radii() {
  static const std::vector<double> radii{0.003, 0.004, 0.005, 0.006,  0.007,  0.0075,
                                         0.010, 0.016, 0.023, 0.0275, 0.0315, 0.050};
  return radii;
}

TestFacts facts() {
  TestFacts facts = profile_facts();
  facts.is_released = true;
  facts.stiffness = CurveKind::affine;
  return facts;
}

std::shared_ptr<const TestSpec> read(Fields& fields, const SpecimenDefaults& defaults,
                                     ExperimentSpec& experiment) {
  auto spec = std::make_shared<RolledStripSpec>();
  experiment.direction = read_direction(fields);
  read_length(fields, defaults, *spec);
  read_recorded_width(fields, defaults, *spec);
  return spec;
}

void read_radii(Fields& fields, VirtualRolledStrip& test) {
  test.settings = published_radii();
  const auto list = fields.optional("radii");
  if (!list) return;
  test.settings.clear();
  for (const Value& radius : list->items()) {
    test.settings.push_back(radius.quantity(Dimension::length));
    if (test.settings.back() == 0) radius.fail("is zero", "the radius of a cylinder");
  }
  if (test.settings.empty()) list->fail("is empty", "at least one radius");
}

std::shared_ptr<VirtualTest> read_virtual(Fields& fields) {
  auto test = std::make_shared<VirtualRolledStrip>();
  test->direction = read_direction(fields);
  test->repeats = 3;
  read_virtual_size(fields, *test);
  read_radii(fields, *test);
  if (auto rest = fields.optional("rest")) test->any_rest = rest->choice({"quiet", "any"}) == "any";
  read_photographs(fields, *test);
  return test;
}

}  // namespace

const TestType& rolled_strip_type() {
  static const TestType type{.name = "rolled-strip",
                             .facts = facts(),
                             .channels = {length_channel("position")},
                             .template_files = template_files("rolled"),
                             .required = {"direction", "length"},
                             .read = read,
                             .make = make_experiment<RolledStrip>,
                             .read_virtual = read_virtual,
                             .is_table = [](const TableColumns& columns) {
                               return has_profiles(columns) &&
                                      columns.has("radius", Dimension::length);
                             }};
  return type;
}

WrittenFields VirtualRolledStrip::study_fields() const {
  WrittenFields fields = VirtualProfiles::study_fields();
  fields.emplace_back("length", fmt::format("{} m", length));
  return fields;
}

WrittenFields VirtualRolledStrip::own_description() const {
  constexpr int kDigits = 4;
  return {{"strip", format_quantity(length, Dimension::length, kDigits) + " long"},
          {"radii", profiles_text()},
          {"rest", any_rest ? "any shape that a strip stays in" : "where a quiet release ends"}};
}

}  // namespace pliant
