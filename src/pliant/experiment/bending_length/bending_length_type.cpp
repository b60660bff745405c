#include "pliant/experiment/bending_length/bending_length_type.h"

#include <fmt/format.h>

#include "pliant/experiment/bending_length/overhangs.h"
#include "pliant/experiment/bending_length/standard_bending_length.h"
#include "pliant/experiment/profile/profile_facts.h"
#include "pliant/experiment/specimen_fields.h"

namespace pliant {
namespace {

std::shared_ptr<const TestSpec> read(Fields& fields, const SpecimenDefaults& defaults,
                                     ExperimentSpec& experiment) {
  auto spec = std::make_shared<BendingLengthSpec>();
  experiment.direction = read_direction(fields);
  read_recorded_width(fields, defaults, *spec);
  spec->angle = read_overhang_angle(fields);
  return spec;
}

std::shared_ptr<VirtualTest> read_virtual(Fields& fields) {
  auto test = std::make_shared<VirtualBendingLength>();
  test->direction = read_direction(fields);
  if (auto v = fields.optional("width")) test->width = v->positive_quantity(Dimension::length);
  test->angle = read_overhang_angle(fields);
  read_repeats(fields, *test);
  read_instrument(fields, *test);
  return test;
}

StandardFigures standard_figures(const DataRows& data, const TestSpec* test, double weight) {
  const double angle = test ? dynamic_cast<const BendingLengthSpec&>(*test).angle : kOverhangAngle;
  return standard_bending_length(read_overhangs(data), angle, weight);
}

}  // namespace

const TestType& bending_length_type() {
  static const TestType type{
      .name = "bending-length",
      .facts = {.deformation = Deformation::bend,
                .overhangs = true,
                .bends_by_weight = true,
                .needs_density = true,
                .stiffness = CurveKind::constant,
                .is_sparse = true,
                .assumption = "the strip bends in a plane, lies level up to the edge, does not "
                              "stretch and is pushed out once; the noise is in the overhangs",
                .undetermined = "at other curvatures: a bending length determines one number"},
      .channels = {length_channel("overhang")},
      .template_files = template_files("bending_length"),
      .required = {"direction"},
      .read = read,
      .make = make_experiment<Overhangs>,
      .read_virtual = read_virtual,
      .is_table =
          [](const TableColumns& columns) {
            return columns.has("overhang", Dimension::length) && !has_profiles(columns);
          },
      .standard_figures = standard_figures};
  return type;
}

WrittenFields BendingLengthSpec::fields() const {
  WrittenFields fields = written_size(*this);
  fields.emplace_back("angle", exact_quantity(angle, Dimension::angle));
  return fields;
}

std::string VirtualBendingLength::rows(const ComponentLaw& law, const ClothFacts& cloth,
                                       RandomStream& random) const {
  constexpr int kElements = 24;  // a fit takes 6
  OverhangRows readings;
  std::vector<double> faces, numbers;
  for (const StripFace face : {StripFace::up, StripFace::down}) {
    for (int repeat = 1; repeat <= repeats; ++repeat) {
      readings.face.push_back(face);
      faces.push_back(face == StripFace::up ? 1 : 2);
      numbers.push_back(repeat);
    }
  }
  readings.overhang.assign(readings.face.size(), 0);
  const auto pushed =
      Overhangs(readings, angle, cloth.density, kElements).predict(law, {}, /*jacobian=*/false);
  if (!pushed) fail("no overhang below 10 m dips as far as the angle; its prediction");
  return table_text({{"overhang_mm", {pushed->value.begin(), pushed->value.end()}, 1e3, lengths()},
                     {"face", faces},
                     {"repeat", numbers}},
                    random);
}

WrittenFields VirtualBendingLength::study_fields() const {
  return {{"direction", direction},
          {"width", fmt::format("{} m", width)},
          {"angle", fmt::format("{} rad", angle)}};
}

WrittenFields VirtualBendingLength::own_description() const {
  constexpr int kDigits = 4;
  return {{"readings", fmt::format("{} of each face, at {}", repeats,
                                   format_quantity(angle, Dimension::angle, kDigits))}};
}

}  // namespace pliant
