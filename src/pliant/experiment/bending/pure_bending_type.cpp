#include "pliant/experiment/bending/pure_bending_type.h"

#include "pliant/experiment/bending/pure_bending.h"

namespace pliant {
namespace {

std::shared_ptr<const TestSpec> read(Fields& fields, const SpecimenDefaults&,
                                     ExperimentSpec& experiment) {
  auto spec = std::make_shared<PureBendingSpec>();
  experiment.direction = read_direction(fields);
  if (auto v = fields.optional("length")) spec->length = v->positive_quantity(Dimension::length);
  if (auto v = fields.optional("width")) spec->width = v->positive_quantity(Dimension::length);
  spec->initial_friction = read_initial_friction(fields);
  return spec;
}

std::shared_ptr<VirtualTest> read_virtual(Fields& fields) {
  auto test = std::make_shared<VirtualPureBending>();
  test->direction = read_direction(fields);
  read_samples(fields, *test);
  read_duration(fields, *test);
  read_cycles(fields, Dimension::curvature, *test);
  return test;
}

}  // namespace

const TestType& pure_bending_type() {
  static const TestType type{.name = "pure-bending",
                             .facts = {.deformation = Deformation::bend,
                                       .follows_time = true,
                                       .unfitted = kUnfittedImposedStrain},
                             .channels = {force_channel("moment")},
                             .template_files = template_files("bending"),
                             .required = {"direction"},
                             .read = read,
                             .make = make_experiment<PureBending>,
                             .read_virtual = read_virtual,
                             .is_table = [](const TableColumns& columns) {
                               return columns.has("curvature", Dimension::curvature) &&
                                      columns.has("moment", Dimension::force);
                             }};
  return type;
}

WrittenFields PureBendingSpec::fields() const {
  WrittenFields fields = written_size(*this);
  fields.push_back(written(initial_friction));
  return fields;
}

WrittenFields VirtualPureBending::study_fields() const {
  return {{"direction", direction}, {"initial_friction", "rest"}};
}

std::unique_ptr<ComponentExperiment> VirtualPureBending::on(const SampledPath& path) const {
  return std::make_unique<PureBending>(path);
}

WrittenFields VirtualPureBending::own_description() const {
  return {{"peaks", sequence_text(peaks, Dimension::curvature)}};
}

}  // namespace pliant
