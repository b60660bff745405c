#include "pliant/experiment/homogeneous/homogeneous_rows.h"

#include <array>

#include <fmt/format.h>

#include "pliant/experiment/experiment_data.h"
#include "pliant/experiment/homogeneous/homogeneous_type.h"

namespace pliant {
namespace {

constexpr std::array kModes{HomogeneousMode::uniaxial, HomogeneousMode::equibiaxial,
                            HomogeneousMode::planar, HomogeneousMode::biaxial};

std::optional<HomogeneousMode> mode_named(std::string_view name) {
  for (const HomogeneousMode mode : kModes) {
    if (name == name_of(mode)) return mode;
  }
  return std::nullopt;
}

Location field_of(const Location& where, std::string_view field) {
  return {where.file, where.line, where.field + "." + std::string(field)};
}

std::vector<double> plus_one(std::vector<double> strains) {
  for (double& strain : strains) strain += 1;
  return strains;
}

std::vector<double> divided(std::vector<double> values, double by) {
  for (double& value : values) value /= by;
  return values;
}

double required(double size, const Location& where, std::string_view field, const char* column,
                const char* expected) {
  if (size > 0) return size;
  throw InputError(field_of(where, field),
                   fmt::format("is not stated, and the table has a column `{}`", column), expected);
}

std::vector<double> stretches(const HomogeneousSpec& spec, const Location& where,
                              const DataRows& data, std::vector<std::string>& handled) {
  if (auto given = data.optional_quantity("stretch", Dimension::number)) return std::move(*given);
  const char* gauge = "the gauge length, e.g. 33 mm";
  if (auto given = data.optional_quantity("strain", Dimension::fraction)) {
    handled.emplace_back("stretch is one more than the strain");
    return plus_one(std::move(*given));
  }
  if (auto given = data.optional_quantity("extension", Dimension::length)) {
    handled.emplace_back("stretch is extension over gauge length, and one");
    return plus_one(
        divided(std::move(*given), required(spec.length, where, "length", "extension", gauge)));
  }
  if (auto given = data.optional_quantity("length", Dimension::length)) {
    handled.emplace_back("stretch is length over gauge length");
    return divided(std::move(*given), required(spec.length, where, "length", "length", gauge));
  }
  return data.quantity("stretch", Dimension::number);  // which names what is missing
}

std::vector<double> stresses(const HomogeneousSpec& spec, const Location& where,
                             const DataRows& data, std::vector<std::string>& handled) {
  if (auto given = data.optional_quantity("nominal_stress", Dimension::stress)) {
    return std::move(*given);
  }
  if (auto given = data.optional_quantity("force", Dimension::force)) {
    handled.emplace_back("nominal stress is force over the rest area");
    const double area = required(spec.area, where, "area", "force",
                                 "the area of the cross-section at rest, e.g. 18 mm^2");
    return divided(std::move(*given), area);
  }
  return data.quantity("nominal_stress", Dimension::stress);
}

void require_above_zero(const std::vector<double>& stretches, const DataRows& data,
                        std::string_view column) {
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    if (stretches[i] > 0) continue;
    throw InputError(data.location(static_cast<int>(i), column),
                     fmt::format("the stretch {:.4g} is not above 0", stretches[i]),
                     "length over rest length; is it a strain (a column `strain`)?");
  }
}

std::vector<HomogeneousMode> modes(const HomogeneousSpec& spec, const Location& where,
                                   const DataRows& data, bool biaxial) {
  const auto rows = static_cast<std::size_t>(data.rows());
  const auto texts = data.optional_texts("mode");
  if (spec.mode || (biaxial && !texts)) {
    return std::vector(rows, spec.mode.value_or(HomogeneousMode::biaxial));
  }
  if (!texts) {
    throw InputError(field_of(where, "mode"), "is missing, and the table has no column `mode`",
                     "uniaxial, equibiaxial, planar or biaxial");
  }
  std::vector<HomogeneousMode> result;
  for (std::size_t i = 0; i < rows; ++i) {
    const auto mode = mode_named((*texts)[i]);
    if (!mode) {
      throw InputError(data.location(static_cast<int>(i), "mode"),
                       quoted_value((*texts)[i]) + " is no mode",
                       "uniaxial, equibiaxial, planar or biaxial");
    }
    result.push_back(*mode);
  }
  return result;
}

}  // namespace

std::string_view name_of(HomogeneousMode mode) {
  switch (mode) {
    case HomogeneousMode::uniaxial:
      return "uniaxial";
    case HomogeneousMode::equibiaxial:
      return "equibiaxial";
    case HomogeneousMode::planar:
      return "planar";
    case HomogeneousMode::biaxial:
      return "biaxial";
  }
  return "";
}

HomogeneousMode read_mode(const Value& value) {
  return *mode_named(value.choice({"uniaxial", "equibiaxial", "planar", "biaxial"}));
}

HomogeneousRows read_rows(const HomogeneousSpec& spec, const Location& where,
                          const DataRows& data) {
  HomogeneousRows result;
  const std::vector<double> first = stretches(spec, where, data, result.handled);
  require_above_zero(first, data, "stretch");
  require_change(first, data, "stretch");
  const auto second = data.optional_quantity("stretch_2", Dimension::number);
  if (second) require_above_zero(*second, data, "stretch_2");
  result.nominal_stress = stresses(spec, where, data, result.handled);
  require_change(result.nominal_stress, data, "nominal_stress");
  const std::vector<HomogeneousMode> mode = modes(spec, where, data, second.has_value());
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (mode[i] == HomogeneousMode::biaxial && !second) {
      throw InputError(data.location(static_cast<int>(i), "stretch_2"),
                       "is missing, and the row is biaxial", "the stretch along 2");
    }
    result.rows.push_back({mode[i], first[i], second ? (*second)[i] : 1});
  }
  return result;
}

}  // namespace pliant
