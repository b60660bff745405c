#include "pliant/experiment/contraction/lateral_contraction.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "pliant/experiment/clamp_column.h"
#include "pliant/experiment/contraction/lateral_contraction_type.h"
#include "pliant/experiment/experiment_data.h"

namespace pliant {
namespace {

StrainRecord record_of(std::vector<double> lengths, const UniaxialGeometry& geometry) {
  StrainRecord record;
  record.driven = std::move(lengths);
  record.strain_of = [geometry](double length) { return strain_at(geometry, length); };
  record.quantity = {"contraction_mm", "length", "mm", 1e3};
  record.offset = "width_change";
  record.offset_unit = "m";
  record.apparatus.assign(record.driven.size(), 0);
  record.factor.assign(record.driven.size(), geometry.width);
  return record;
}

UniaxialGeometry geometry_of(const ExperimentSpec& spec, const ClothFacts& cloth) {
  return {spec.test->length, spec.test->width, cloth.membrane};
}

/// Extensometers across write a strain, which is negative where the strip narrows.
std::vector<double> widths_of(const DataRows& data, double at_rest) {
  std::optional<std::vector<double>> strains =
      data.is_stated("width") ? std::nullopt
                              : data.optional_quantity("lateral_strain", Dimension::fraction);
  if (!strains) return data.quantity("width", Dimension::length);
  for (double& strain : *strains) strain = at_rest * (1 + strain);
  return std::move(*strains);
}

StrainRecord read_record(const DataRows& data, const UniaxialGeometry& geometry) {
  const ClampColumn way = clamp_column(data);
  StrainRecord record = record_of(way.lengths(geometry.gauge_length), geometry);
  const std::vector<double> widths = widths_of(data, geometry.width);
  require_positive(record.driven, data, way.name);
  require_positive(widths, data, "width");
  require_change(record.driven, data, way.name);
  require_change(widths, data, "width");
  for (const double width : widths) record.measured.push_back(geometry.width - width);
  return record;
}

/// A strip begins about at rest: whether it has the stated sizes there.
/// @param width, length  in the first row (m)
std::optional<std::string> size_question(double width, double length,
                                         const UniaxialGeometry& geometry) {
  constexpr double kFar = 0.25;
  const auto asked = [](const char* key, double share) {
    return fmt::format(
        "the first row has {:.0f} % of the stated `{}`: is that the distance of the marks at rest?",
        100 * share, key);
  };
  const double of_width = width / geometry.width, of_length = length / geometry.gauge_length;
  if (std::abs(of_width - 1) > kFar) return asked("width", of_width);
  if (std::abs(of_length - 1) > kFar) return asked("length", of_length);
  return std::nullopt;
}

}  // namespace

LateralContraction::LateralContraction(const UniaxialGeometry& geometry, const SampledPath& path)
    : ImposedStrain(record_of(path.value, geometry), path) {}

LateralContraction::LateralContraction(const ExperimentSpec& spec, const DataRows& data,
                                       const ClothFacts& cloth)
    : ImposedStrain(spec, spec_of<LateralContractionSpec>(spec).initial_friction, data,
                    read_record(data, geometry_of(spec, cloth))) {
  const UniaxialGeometry geometry = geometry_of(spec, cloth);
  info_.handled.push_back(
      "the length drives the path; compared is how much narrower the strip is than at rest");
  info_.questions =
      first_asked({size_question(geometry.width - measured_(0),
                                 length_at(geometry, path_.strain.front()), geometry),
                   secant() > 0 ? std::nullopt
                                : std::optional<std::string>(
                                      "the strip is wider where it is longer: is `width` "
                                      "another length?")});
}

}  // namespace pliant
