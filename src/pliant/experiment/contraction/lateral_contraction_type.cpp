#include "pliant/experiment/contraction/lateral_contraction_type.h"

#include "pliant/experiment/clamp_column.h"
#include "pliant/experiment/contraction/lateral_contraction.h"

namespace pliant {
namespace {

std::shared_ptr<const TestSpec> read(Fields& fields, const SpecimenDefaults& defaults,
                                     ExperimentSpec& experiment) {
  auto spec = std::make_shared<LateralContractionSpec>();
  experiment.direction = read_direction(fields);
  read_strip(fields, defaults, *spec);
  spec->initial_friction = read_initial_friction(fields);
  return spec;
}

std::shared_ptr<VirtualTest> read_virtual(Fields& fields) {
  auto test = std::make_shared<VirtualLateralContraction>();
  test->direction = read_direction(fields);
  read_virtual_size(fields, *test);
  read_samples(fields, *test);
  read_duration(fields, *test);
  read_cycles(fields, Dimension::fraction, *test);
  return test;
}

}  // namespace

const TestType& lateral_contraction_type() {
  static const TestType type{
      .name = "lateral-contraction",
      .facts = {.deformation = Deformation::contraction,
                .follows_time = true,
                .unfitted = "width at rest as stated, friction at rest"},
      .channels = {length_channel()},
      .template_files = template_files("contraction"),
      .required = {"direction", "length", "width"},
      .read = read,
      .make = make_experiment<LateralContraction>,
      .read_virtual = read_virtual,
      .own_quantities = {{"width", Dimension::length}, {"lateral_strain", Dimension::fraction}},
      .is_table = [](const TableColumns& columns) {
        return (columns.has("width", Dimension::length) ||
                columns.has("lateral_strain", Dimension::fraction)) &&
               !columns.has("force", Dimension::force) && has_clamp_column(columns);
      }};
  return type;
}

WrittenFields LateralContractionSpec::fields() const {
  WrittenFields fields = written_size(*this);
  fields.push_back(written(initial_friction));
  return fields;
}

std::string VirtualLateralContraction::rows(const ComponentLaw& law, const ClothFacts& cloth,
                                            RandomStream& random) const {
  const SampledPath path = timed(clamp_path(1));
  const Prediction narrower =
      predicted(LateralContraction({length, width, cloth.membrane}, path), law);
  std::vector<double> widths;
  for (const double contraction : narrower.value) widths.push_back(width - contraction);
  return table_text(with_times({{"length_mm", path.value, 1e3, lengths()},
                                {"width_mm", std::move(widths), 1e3, lengths()},
                                {"cycle", {path.cycle.begin(), path.cycle.end()}}},
                               path),
                    random);
}

WrittenFields VirtualLateralContraction::study_fields() const {
  WrittenFields fields = VirtualTable::study_fields();
  fields.emplace_back("initial_friction", "rest");
  return fields;
}

WrittenFields VirtualLateralContraction::own_description() const {
  return {{"strip", size_text()}, {"peaks", sequence_text(peaks, Dimension::fraction)}};
}

}  // namespace pliant
