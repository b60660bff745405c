#include "pliant/experiment/shear/shear_cycles_type.h"

#include <numbers>

#include <fmt/format.h>

#include "pliant/experiment/shear/shear_cycles.h"

namespace pliant {
namespace {

std::shared_ptr<const TestSpec> read(Fields& fields, const SpecimenDefaults&, ExperimentSpec&) {
  auto spec = std::make_shared<ShearCyclesSpec>();
  spec->transverse_tension =
      read_from_zero(fields, "transverse_tension", Dimension::force_per_length);
  spec->initial_friction = read_initial_friction(fields);
  return spec;
}

std::shared_ptr<VirtualTest> read_virtual(Fields& fields) {
  auto test = std::make_shared<VirtualShearCycles>();
  read_samples(fields, *test);
  read_duration(fields, *test);
  test->transverse_tension =
      read_from_zero(fields, "transverse_tension", Dimension::force_per_length);
  read_cycles(fields, Dimension::angle, *test);
  return test;
}

}  // namespace

const TestType& shear_cycles_type() {
  static const TestType type{
      .name = "shear-cycles",
      .facts = {.deformation = Deformation::shear,
                .follows_time = true,
                .unfitted = kUnfittedImposedStrain},
      .channels = {force_channel("force", Dimension::force_per_length), length_channel()},
      .template_files = template_files("shear"),
      .read = read,
      .make = make_experiment<ShearCycles>,
      .read_virtual = read_virtual,
      .is_table = [](const TableColumns& columns) {
        return columns.has("angle", Dimension::angle) &&
               columns.has("force", Dimension::force_per_length);
      }};
  return type;
}

WrittenFields ShearCyclesSpec::fields() const {
  return {{"transverse_tension", exact_quantity(transverse_tension, Dimension::force_per_length)},
          written(initial_friction)};
}

WrittenFields VirtualShearCycles::study_fields() const {
  WrittenFields fields;
  if (transverse_tension > 0) {
    fields.emplace_back("transverse_tension", fmt::format("{} N/m", transverse_tension));
  }
  fields.emplace_back("initial_friction", "rest");
  return fields;
}

ImposedTable VirtualShearCycles::table() const {
  return {"angle_deg", 180 / std::numbers::pi, "force_N_per_m"};
}

std::unique_ptr<ComponentExperiment> VirtualShearCycles::on(const SampledPath& path) const {
  return std::make_unique<ShearCycles>(path, transverse_tension);
}

WrittenFields VirtualShearCycles::own_description() const {
  return {{"peaks", sequence_text(peaks, Dimension::angle)}};
}

}  // namespace pliant
