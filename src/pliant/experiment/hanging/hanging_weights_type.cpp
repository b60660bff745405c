#include "pliant/experiment/hanging/hanging_weights_type.h"

#include <cmath>

#include <fmt/format.h>

#include "pliant/experiment/hanging/hanging_weights.h"

namespace pliant {
namespace {

std::shared_ptr<const TestSpec> read(Fields& fields, const SpecimenDefaults& defaults,
                                     ExperimentSpec& experiment) {
  auto spec = std::make_shared<HangingWeightsSpec>();
  experiment.direction = read_direction(fields);
  read_strip(fields, defaults, *spec);
  spec->clip_mass = read_from_zero(fields, "clip_mass", Dimension::mass);
  if (auto v = fields.optional("rested")) spec->rested = v->flag();
  spec->rest_length = read_rest_length(fields, /*pretension=*/0);
  return spec;
}

std::shared_ptr<VirtualTest> read_virtual(Fields& fields) {
  auto test = std::make_shared<VirtualHangingWeights>();
  test->direction = read_direction(fields);
  read_virtual_size(fields, *test);
  test->clip_mass = read_from_zero(fields, "clip_mass", Dimension::mass);
  if (auto v = fields.optional("step")) test->step = v->positive_quantity(Dimension::force);
  read_cycles(fields, Dimension::force, *test);
  return test;
}

}  // namespace

const TestType& hanging_weights_type() {
  static const TestType type{
      .name = "hanging-weights",
      .facts = {.deformation = Deformation::stretch,
                .stiffness = CurveKind::affine,
                .is_sparse = true,
                .assumption = "the noise is in the lengths, the weights are exact",
                .unfitted = kUnfittedStrip},
      .channels = {force_channel(), length_channel()},
      .template_files = template_files("hanging"),
      .required = {"direction", "length", "width"},
      .read = read,
      .make = make_experiment<HangingWeights>,
      .read_virtual = read_virtual,
      .is_table = [](const TableColumns& columns) {
        return columns.has("length", Dimension::length) &&
               (columns.has("weight", Dimension::force) || columns.has("weight", Dimension::mass));
      }};
  return type;
}

WrittenFields HangingWeightsSpec::fields() const {
  WrittenFields fields = written_size(*this);
  fields.emplace_back("clip_mass", exact_quantity(clip_mass, Dimension::mass));
  fields.emplace_back("rested", rested ? "true" : "false");
  fields.push_back(written(rest_length));
  return fields;
}

std::string VirtualHangingWeights::rows(const ComponentLaw& law, const ClothFacts& cloth,
                                        RandomStream& random) const {
  std::vector<double> repeat, largest, number, weights;
  for (int r = 1; r <= repeats; ++r) {
    for (const double peak : peaks) {
      const int steps = static_cast<int>(std::lround(peak / step));
      for (int k = 0; k <= 2 * steps; ++k) {
        repeat.push_back(r);
        largest.push_back(peak);
        number.push_back(k);
        weights.push_back(step * (steps - std::abs(k - steps)));
      }
    }
  }
  HangingWeightsSpec strip;
  strip.length = length;
  strip.width = width;
  strip.clip_mass = clip_mass;
  const Prediction hung = predicted(HangingWeights(strip, weights, cloth), law);
  return table_text({{"repeat", repeat},
                     {"peak_N", largest},
                     {"step", number},
                     {"weight_N", weights},
                     {"length_mm", {hung.value.begin(), hung.value.end()}, 1e3, lengths()}},
                    random);
}

WrittenFields VirtualHangingWeights::study_fields() const {
  WrittenFields fields = VirtualTable::study_fields();
  if (clip_mass > 0) fields.emplace_back("clip_mass", fmt::format("{} kg", clip_mass));
  return fields;
}

WrittenFields VirtualHangingWeights::own_description() const {
  return {{"strip", size_text()}, {"peaks", sequence_text(peaks, Dimension::force)}};
}

}  // namespace pliant
