#include "pliant/experiment/shear/shear_cycles.h"

#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "pliant/experiment/experiment_data.h"
#include "pliant/experiment/shear/shear_cycles_type.h"
#include "pliant/experiment/strip_figures.h"

namespace pliant {
namespace {

void require_acute(const std::vector<double>& angles, const DataRows& data) {
  for (size_t i = 0; i < angles.size(); ++i) {
    if (std::abs(angles[i]) < std::numbers::pi / 2) continue;
    throw InputError(data.location(static_cast<int>(i), "angle"), "is 90 degrees or more",
                     "a shear angle below 90 degrees");
  }
}

StrainRecord record_of(std::vector<double> angles, double transverse_tension) {
  StrainRecord record;
  record.driven = std::move(angles);
  record.strain_of = [](double angle) { return std::sin(angle); };
  record.quantity = {"force_N_per_m", "force per width", "N/m", 1};
  record.offset = "force_offset";
  for (const double angle : record.driven) {
    record.apparatus.push_back(transverse_tension * std::tan(angle));
  }
  return record;
}

StrainRecord read_record(const DataRows& data, double transverse_tension) {
  StrainRecord record = record_of(data.quantity("angle", Dimension::angle), transverse_tension);
  record.measured = data.quantity("force", Dimension::force_per_length);
  require_change(record.measured, data, "force");
  require_change(record.driven, data, "angle");
  require_acute(record.driven, data);
  return record;
}

}  // namespace

ShearCycles::ShearCycles(const SampledPath& path, double transverse_tension)
    : ImposedStrain(record_of(path.value, transverse_tension), path) {}

ShearCycles::ShearCycles(const ExperimentSpec& spec, const DataRows& data, const ClothFacts& cloth)
    : ImposedStrain(spec, spec_of<ShearCyclesSpec>(spec).initial_friction, data,
                    read_record(data, spec_of<ShearCyclesSpec>(spec).transverse_tension)) {
  const double tension = spec_of<ShearCyclesSpec>(spec).transverse_tension;
  info_.handled.push_back(
      "the angle drives the path; strain is sin(angle): yarns keep their length");
  info_.handled.push_back(
      tension > 0
          ? fmt::format("the transverse tension, {:.4g} N/m, adds T tan(angle)", tension)
          : "no transverse tension is stated: its share of the force is part of the stiffness");
  StripFigures strip(*spec.test, cloth.density);
  const auto angle = strip.column("angle", Dimension::angle, data.quantity_unit("angle"));
  const auto force =
      strip.column("force", Dimension::force_per_length, data.quantity_unit("force"));
  strip.add(figures::kShearAngle, std::asin(largest_strain()), {{angle}});
  if (secant() > 0) strip.add_shear_stiffness(secant(), {{force}, {angle, -1}});
  info_.questions = first_asked(
      {swap_question(*this, "angle", "force"), sign_question("force", "angle"), strip.question()});
}

}  // namespace pliant
