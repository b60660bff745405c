#include "pliant/report/labels.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "pliant/experiment/uniaxial_geometry.h"
#include "pliant/material/addend/addend_registry.h"
#include "pliant/material/bending_strain.h"
#include "pliant/report/number_format.h"

namespace pliant::report {
namespace {

std::string capitalised(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

/// A kind of addends and the number of it that a parameter is: "stretch.warp.dahl2.tau".
struct AddendNumber {
  const AddendKind* kind = nullptr;
  const AddendParameter* parameter = nullptr;
};

AddendNumber addend_number(std::string_view parameter) {
  for (const AddendKind* kind : addend_kinds()) {
    for (const AddendParameter& own : kind->parameters) {
      if (!parameter.ends_with(fmt::format(".{}", own.name))) continue;
      std::string_view law = parameter.substr(0, parameter.size() - own.name.size() - 1);
      law.remove_suffix(law.size() - law.find_last_not_of("0123456789") - 1);
      if (law.ends_with(fmt::format(".{}", kind->name))) return {kind, &own};
    }
  }
  return {};
}

}  // namespace

QuantityLabel quantity_label(std::string_view column) {
  if (column == "force_N_per_m") return {"Shear force", "N/m"};
  if (column == "angle_deg") return {"Shear angle", "°"};
  if (column == "moment_N") return {"Moment per width", "N"};
  // Longest first: `_N_per_m` ends in `_m` too.
  constexpr std::array<std::pair<std::string_view, std::string_view>, 11> kUnits = {
      {{"_N_per_m", "N/m"},
       {"_1_per_m", "1/m"},
       {"_deg", "°"},
       {"_mm2", "mm²"},
       {"_mm", "mm"},
       {"_mN", "mN"},
       {"_Pa", "Pa"},
       {"_N", "N"},
       {"_g", "g"},
       {"_m", "m"},
       {"_s", "s"}}};
  for (const auto& [suffix, unit] : kUnits) {
    if (column.size() <= suffix.size() || !column.ends_with(suffix)) continue;
    std::string name(column.substr(0, column.size() - suffix.size()));
    for (char& c : name) c = c == '_' ? ' ' : c;
    return {capitalised(name), std::string(unit)};
  }
  return {std::string(column), ""};
}

ShownStrain::ShownStrain(std::string_view component, std::optional<MembraneMeasure> measure)
    : label_{"Strain", "%"} {
  if (is_bending(component)) {
    label_ = {"Curvature", "1/m"};
    factor_ = 1 / kStrainPerCurvature;
  } else if (component.starts_with("shear")) {
    label_ = {"Shear strain", "%"};
  } else if (const SheetMetric* metric = find_sheet_metric(component)) {
    label_ = {capitalised(std::string(metric->meaning)), "%"};
  } else if (is_sheet_pair(component)) {
    label_ = {std::string(component), ""};
    factor_ = 1;
  } else if (component.empty() || units_of(component) == LawUnits::solid) {
    label_ = component.empty() ? QuantityLabel{"Strain", "%"}
                               : QuantityLabel{std::string(component), ""};
    if (!component.empty()) factor_ = 1;
  } else if (measure) {
    label_ = {"Extension", "%"};
    green_ = *measure == MembraneMeasure::stvk;
  }
}

double ShownStrain::operator()(double strain) const {
  return factor_ * (green_ ? extension_at(MembraneMeasure::stvk, strain) : strain);
}

std::vector<double> ShownStrain::operator()(std::span<const double> strains) const {
  std::vector<double> shown;
  for (const double strain : strains) shown.push_back((*this)(strain));
  return shown;
}

std::string strain_name(std::string_view component, std::optional<MembraneMeasure> measure) {
  std::string name = ShownStrain(component, measure).label().name;
  name[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(name[0])));
  return name;
}

StrainRangeTexts strain_range_texts(std::string_view component,
                                    std::optional<MembraneMeasure> measure, double low,
                                    double high) {
  constexpr double kNothing = 1e-5;  // of the larger end: what rounding left of zero
  const double nothing = kNothing * std::max(std::abs(low), std::abs(high));
  const auto text = [&](const auto& shown, const std::string& unit) {
    const auto number = [&](double strain) {
      return format_significant(std::abs(strain) < nothing ? 0 : shown(strain), 2);
    };
    return fmt::format("{} to {} {}", number(low), number(high), unit);
  };
  const ShownStrain shown(component, measure);
  const auto percent = [](double strain) { return 100 * strain; };
  return {text(shown, shown.label().unit),
          shown.is_of_green_strain() ? text(percent, "%") : std::string()};
}

std::string strain_range_text(std::string_view component, std::optional<MembraneMeasure> measure,
                              double low, double high) {
  const auto [shown, green] = strain_range_texts(component, measure, low, high);
  const std::string text = strain_name(component, measure) + " " + shown;
  return green.empty() ? text : fmt::format("{} (Green strain {})", text, green);
}

QuantityLabel stress_label(std::string_view component) {
  if (is_bending(component)) return {"Moment per width", "N"};
  if (units_of(component) == LawUnits::solid) return {"Energy per strain", "Pa"};
  if (is_contraction(component)) return {"Contraction", "1"};
  return {component.starts_with("shear") ? "Shear stress" : "Stress", "N/m"};
}

std::string component_title(std::string_view component) {
  const std::size_t dot = component.find('.');
  if (is_sheet_pair(component)) return std::string(component);
  if (dot == std::string_view::npos) return capitalised(std::string(component));
  const std::string_view kind = component.substr(0, dot);
  const std::string direction = capitalised(std::string(component.substr(dot + 1)));
  if (kind == "stretch") return direction + " stretch";
  if (kind == "bend") return direction + " bending";
  if (kind == "contraction") return "Contraction across " + std::string(component.substr(dot + 1));
  return std::string(component);
}

std::string parameter_meaning(std::string_view parameter) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 7> kMeanings = {
      {{".cord_friction", "force between pulling and giving way of this cord"},
       {".friction.a", "friction at zero strain"},
       {".friction.b", "growth of friction with strain"},
       {".friction.tau", "strain over which friction builds up"},
       {".k1", "stiffness at zero strain"},
       {".k2", "growth of stiffness with strain"},
       {".k", "stiffness"}}};
  if (const AddendNumber own = addend_number(parameter); own.kind) {
    return std::string(own.parameter->meaning);
  }
  for (const auto& [suffix, meaning] : kMeanings) {
    if (parameter.ends_with(suffix)) return std::string(meaning);
  }
  if (parameter.ends_with("]") && parameter.find(".k[") != std::string_view::npos) {
    return "stiffness at a control point";
  }
  if (parameter.ends_with("]") && parameter.find(".psi[") != std::string_view::npos) {
    return "energy at a control point";
  }
  return {};
}

bool is_of_friction(std::string_view parameter) {
  if (parameter.find(".friction.") != std::string_view::npos) return true;
  const AddendNumber own = addend_number(parameter);
  return own.kind && remembers(*own.kind);
}

std::string parameter_in_words(std::string_view text) {
  const std::string_view name = text.substr(0, std::min(text.find(' '), text.find(": ")));
  const std::string_view rest = text.substr(name.size());
  if (const std::size_t k = name.find(".k["); k != std::string_view::npos) {
    const std::string_view component = name.substr(0, k), point = name.substr(k + 2);
    return point == "[0]"
               ? fmt::format("stiffness of {} at zero strain{}", component, rest)
               : fmt::format("stiffness of {} at control point {}{}", component, point, rest);
  }
  if (const std::size_t psi = name.find(".psi["); psi != std::string_view::npos) {
    return fmt::format("energy of {} at control point {}{}", name.substr(0, psi),
                       name.substr(psi + 4), rest);
  }
  const std::size_t friction = name.find(".friction.");
  if (friction == std::string_view::npos) return std::string(text);
  const std::string_view component = name.substr(0, friction);
  if (name.ends_with(".a")) return fmt::format("friction of {} at zero strain{}", component, rest);
  if (name.ends_with(".b")) return fmt::format("growth of friction of {}{}", component, rest);
  return fmt::format("strain over which friction of {} builds up{}", component, rest);
}

std::string shown_unit(std::string_view unit) {
  return unit == "1" || unit == "-" ? std::string() : std::string(unit);
}

}  // namespace pliant::report
