#include "pliant/experiment/cantilever/cantilever_type.h"

#include "pliant/experiment/cantilever/cantilever.h"
#include "pliant/experiment/profile/profile_facts.h"
#include "pliant/experiment/specimen_fields.h"

namespace pliant {
namespace {

TestFacts facts() {
  TestFacts facts = profile_facts();
  facts.overhangs = true;
  return facts;
}

std::shared_ptr<const TestSpec> read(Fields& fields, const SpecimenDefaults& defaults,
                                     ExperimentSpec& experiment) {
  auto spec = std::make_shared<CantileverSpec>();
  experiment.direction = read_direction(fields);
  read_recorded_width(fields, defaults, *spec);
  if (auto v = fields.optional("density")) {
    spec->density_is_known = v->choice({"known", "unknown"}) == "known";
  }
  return spec;
}

std::shared_ptr<VirtualTest> read_virtual(Fields& fields) {
  auto test = std::make_shared<VirtualCantilever>();
  test->direction = read_direction(fields);
  if (auto v = fields.optional("width")) test->width = v->positive_quantity(Dimension::length);
  test->settings = read_quantities(fields.require("overhangs"), Dimension::length, "overhang");
  read_photographs(fields, *test);
  return test;
}

}  // namespace

const TestType& cantilever_type() {
  static const TestType type{.name = "cantilever",
                             .facts = facts(),
                             .channels = {length_channel("position")},
                             .template_files = template_files("cantilever"),
                             .required = {"direction"},
                             .read = read,
                             .make = make_experiment<Cantilever>,
                             .read_virtual = read_virtual,
                             .is_table = [](const TableColumns& columns) {
                               return has_profiles(columns) &&
                                      columns.has("overhang", Dimension::length);
                             }};
  return type;
}

WrittenFields CantileverSpec::fields() const {
  WrittenFields fields = written_size(*this);
  if (!density_is_known) fields.emplace_back("density", "unknown");
  return fields;
}

}  // namespace pliant
