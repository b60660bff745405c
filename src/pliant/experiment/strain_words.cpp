#include "pliant/experiment/strain_words.h"

#include <fmt/format.h>

#include "pliant/base/number_text.h"
#include "pliant/experiment/uniaxial_geometry.h"
#include "pliant/material/bending_strain.h"

namespace pliant {

std::string strain_in_words(std::string_view component, double strain, MembraneMeasure measure) {
  constexpr int kDigits = 3;
  const auto percent = [](double value) { return format_number(100 * value, kDigits) + " %"; };
  if (is_bending(component)) {
    return fmt::format("curvature {} 1/m", format_number(strain / kStrainPerCurvature, kDigits));
  }
  if (component == "shear") return "shear strain " + percent(strain);
  if (const SheetMetric* metric = find_sheet_metric(component)) {
    return fmt::format("{} {}", metric->meaning, percent(strain));
  }
  if (is_sheet_pair(component))
    return fmt::format("{} {}", component, format_number(strain, kDigits));
  const std::string extension = percent(extension_at(measure, strain)) + " extension";
  if (measure != MembraneMeasure::stvk) return extension;
  return fmt::format("{} (Green strain {})", extension, percent(strain));
}

}  // namespace pliant
