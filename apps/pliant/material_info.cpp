#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/number_text.h"
#include "pliant/base/quantity.h"
#include "pliant/experiment/strain_words.h"
#include "pliant/material/material_file.h"

#include "apps/pliant/component_facts.h"
#include "apps/pliant/convexity_info.h"
#include "apps/pliant/file_info.h"
#include "apps/pliant/limits_info.h"
#include "apps/pliant/samples_info.h"
#include "apps/pliant/solid_info.h"
#include "apps/pliant/textile_info.h"

namespace pliant {
namespace {

/// Units of a component and its numbers as texts: bending and membrane differ in all of them, and a
/// contraction has none.
struct ComponentUnits {
  std::string component;
  MembraneMeasure measure;
  bool bending = is_bending(component);
  bool ratio = is_contraction(component);

  std::string stiffness_unit() const { return ratio ? "1" : bending ? "N m" : "N/m"; }
  std::string stress_unit() const { return ratio ? "1" : bending ? "N" : "N/m"; }
  std::string strain_unit() const { return bending ? "1/m" : "1"; }

  std::string stiffness(double value) const {
    if (ratio) return format_number(value, kInfoDigits);
    return format_quantity(
        value, bending ? Dimension::bending_stiffness : Dimension::force_per_length, kInfoDigits);
  }
  std::string stress(double value) const {
    if (ratio) return format_number(value, kInfoDigits);
    return format_quantity(value, bending ? Dimension::force : Dimension::force_per_length,
                           kInfoDigits);
  }
  std::string strain(double value) const { return strain_in_words(component, value, measure); }
  std::string strains(double low, double high) const {
    if (low == high) return "at " + strain(high);
    return low == 0 ? "up to " + strain(high)
                    : fmt::format("from {} to {}", strain(low), strain(high));
  }
};

std::string interval_text(const StrainInterval& interval, const ComponentUnits& units) {
  const bool open = std::isinf(interval.to);
  if (interval.from == 0) return open ? "at every strain" : "below " + units.strain(interval.to);
  if (open) return "above " + units.strain(interval.from);
  return units.strains(interval.from, interval.to);
}

std::string curve_text(const ScalarCurve& curve, const ComponentUnits& units) {
  const std::vector<double>& values = curve.values();
  switch (curve.kind()) {
    case CurveKind::none:
      return "none: the addends carry it";
    case CurveKind::constant:
      return "constant, k = " + units.stiffness(values[0]);
    case CurveKind::affine:
      return fmt::format("affine, k1 = {}, k2 = {} {}", units.stiffness(values[0]),
                         format_number(values[1], kInfoDigits),
                         units.bending ? "N m^2" : units.stiffness_unit());
    case CurveKind::hermite:
    case CurveKind::spline:
    case CurveKind::energy:
      return fmt::format("{}, {} control points {}{}", name_of(curve.kind()), values.size(),
                         units.strains(curve.knots().front(), curve.knots().back()),
                         curve.even() ? ", mirrored for negative strains" : "");
  }
  return "";
}

Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json stiffness_json(const StiffnessAt& at) {
  return {{"strain", at.strain},
          {"secant", at.secant},
          {"tangent", at.tangent},
          {"secant_loading", at.loading}};
}

std::string stiffness_text(const StiffnessAt& at, const ComponentUnits& units) {
  std::string text =
      fmt::format("secant {}, tangent {}", units.stiffness(at.secant), units.stiffness(at.tangent));
  if (at.loading != at.secant) {
    text += fmt::format(", secant with friction while loading {}", units.stiffness(at.loading));
  }
  return text;
}

Json friction_json(const FrictionFacts& facts) {
  Json json{{"a", facts.dahl.a},
            {"b", facts.dahl.b},
            {"tau", facts.dahl.tau},
            {"persistent_strain_linear", nullptr},
            {"saturation_strain", nullptr},
            {"persistent_strain", nullptr}};
  if (facts.appearance) {
    json["persistent_strain_linear"] = facts.appearance->persistent;
    json["saturation_strain"] = facts.appearance->saturation;
  }
  if (facts.persistent_strain) json["persistent_strain"] = *facts.persistent_strain;
  json["snaps_while_unloading"] = Json::array();
  for (const StrainInterval& interval : facts.snapping) {
    json["snaps_while_unloading"].push_back({interval.from, number_or_null(interval.to)});
  }
  return json;
}

std::string snapping_text(const FrictionFacts& facts, const ComponentUnits& units) {
  if (facts.snapping.empty()) return "never: the elastic tangent k + k' strain is b or more";
  std::vector<std::string> texts;
  for (const StrainInterval& interval : facts.snapping) {
    texts.push_back(interval_text(interval, units));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

void add_friction_lines(const std::string& label, const FrictionFacts& facts,
                        const ComponentUnits& units, std::vector<std::string>& lines) {
  lines.push_back(labelled(label,
                           fmt::format("a = {}, b = {}, tau = {}", units.stress(facts.dahl.a),
                                       units.stiffness(facts.dahl.b), units.strain(facts.dahl.tau)),
                           1));
  lines.push_back(labelled("persistent strain",
                           facts.persistent_strain ? units.strain(*facts.persistent_strain) +
                                                         ", after saturated unloading"
                                                   : "friction holds every strain of the range",
                           2));
  if (facts.appearance) {
    lines.push_back(
        labelled("  by a and k(0) alone", units.strain(facts.appearance->persistent), 2));
    lines.push_back(labelled("saturation strain", units.strain(facts.appearance->saturation), 2));
  }
  lines.push_back(labelled("snaps on unloading", snapping_text(facts, units), 2));
}

void warn_of_snapping(const std::string& name, const FrictionFacts& facts,
                      const ComponentUnits& units, FileInfo& info) {
  for (const StrainInterval& interval : facts.snapping) {
    info.warnings.push_back(fmt::format(
        "{} is not monotone on unloading {}: b outweighs the elastic tangent k + k' strain there; "
        "the material itself snaps, a released specimen jumps",
        name, interval_text(interval, units)));
  }
}

void add_addends(const MaterialComponent& component, const ComponentUnits& units,
                 std::vector<std::string>& lines, Json& json) {
  for (const Addend& addend : component.addends) {
    Json own{{"law", addend.kind().name}};
    std::vector<std::string> numbers;
    for (std::size_t i = 0; i < addend.kind().parameters.size(); ++i) {
      const AddendParameter& parameter = addend.kind().parameters[i];
      const double value = addend.values()(static_cast<Eigen::Index>(i));
      own[std::string(parameter.name)] = value;
      const std::string unit = unit_of(parameter, units_of(units.component));
      numbers.push_back(fmt::format("{} = {}{}", parameter.name, format_number(value, kInfoDigits),
                                    unit == "1" ? "" : " " + unit));
    }
    json["addends"].push_back(std::move(own));
    lines.push_back(
        labelled(std::string(addend.kind().name), fmt::format("{}", fmt::join(numbers, ", ")), 1));
  }
}

void add_measured(const std::string& name, const MaterialComponent& component,
                  const ComponentUnits& units, FileInfo& info, Json& json) {
  const ComponentFacts facts = facts_of(component);
  json["units"] = {{"stiffness", units.stiffness_unit()},
                   {"friction", units.stress_unit()},
                   {"strain", units.strain_unit()}};
  json["stiffness"] = {{"curve", name_of(component.stiffness->kind())},
                       {"at_zero", stiffness_json(facts.at_zero)},
                       {"at_end", facts.at_end ? stiffness_json(*facts.at_end) : Json(nullptr)}};
  auto& lines = info.lines;
  lines.push_back(labelled("stiffness", curve_text(*component.stiffness, units), 1));
  lines.push_back(labelled("at zero strain", units.stiffness(facts.at_zero.secant), 2));
  if (facts.at_end) {
    lines.push_back(labelled("at " + units.strain(facts.at_end->strain),
                             stiffness_text(*facts.at_end, units), 2));
  }
  if (!facts.friction) {
    json["friction"] = nullptr;
    lines.push_back(labelled("friction", "none", 1));
    return;
  }
  const bool sided = facts.negative_friction.has_value();
  json["friction"] = friction_json(*facts.friction);
  add_friction_lines(sided ? "friction, positive" : "friction", *facts.friction, units, lines);
  warn_of_snapping(name, *facts.friction, units, info);
  if (!sided) return;
  json["negative_friction"] = friction_json(*facts.negative_friction);
  add_friction_lines("friction, negative", *facts.negative_friction, units, lines);
  warn_of_snapping(name + " (negative strain)", *facts.negative_friction, units, info);
}

Json component_info(const Material& material, const std::string& name, FileInfo& info) {
  const MaterialComponent& component = material.components.at(name);
  const ComponentUnits units{name, material.membrane};
  Json json{{"status", name_of(component.status)}, {"range", nullptr}};
  std::string text(name_of(component.status));
  if (component.range) {
    json["range"] = {component.range->first, component.range->second};
    text += ", " + units.strains(component.range->first, component.range->second);
  } else if (component.stiffness) {
    text += ", no range of strains stated";
  }
  info.lines.push_back(labelled(name, text));
  if (component.stiffness) add_measured(name, component, units, info, json);
  add_addends(component, units, info.lines, json);
  if (component.stiffness) add_convexity(material, name, info, json);
  const bool read_by_instruments =
      units.bending ? material.bending_of == "sheet" : !solid_metric_of(name);
  if (component.stiffness && read_by_instruments) {
    json["textile"] = textile_info(material, name, info);
  }
  return json;
}

std::string status_counts(const Material& material) {
  std::map<ComponentStatus, int> counts;
  for (const auto& [name, component] : material.components) ++counts[component.status];
  std::vector<std::string> texts;
  for (const auto& [status, count] : counts) {
    texts.push_back(fmt::format("{} {}", count, name_of(status)));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

void add_texts(const Material& material, FileInfo& info) {
  if (material.damping_fraction) info.json["damping_fraction"] = *material.damping_fraction;
  for (const auto* texts : {&material.info, &material.provenance}) {
    for (const auto& [key, text] : *texts) info.lines.push_back(labelled(key, text));
  }
  info.json["info"] = material.info;
  info.json["provenance"] = material.provenance;
  info.json["warnings"] = info.warnings;
}

}  // namespace

FileInfo material_info(const std::filesystem::path& path) {
  const Material material = read_material(path);
  FileInfo info = begin_info(path, "material/1");
  info.json["name"] = material.name;
  info.json["kind"] = name_of(material.kind);
  info.json["density"] = material.density > 0 ? Json(material.density) : Json(nullptr);
  info.lines.push_back(labelled("name", material.name));
  if (material.kind == MaterialKind::solid) {
    add_solid(material, info);
    add_texts(material, info);
    return info;
  }
  info.json["membrane"] = name_of(material.membrane);
  info.json["bending"] = material.bending;
  info.json["bending_of"] = material.bending_of;
  if (!material.bending_mesh.empty()) info.json["bending_mesh"] = material.bending_mesh;
  info.lines.push_back(labelled(
      "density", material.density > 0
                     ? format_quantity(material.density, Dimension::area_density, kInfoDigits)
                     : "not stated"));
  info.lines.push_back(
      labelled("strain measures",
               fmt::format("membrane {}, bending {} of the {}", name_of(material.membrane),
                           material.bending, material.bending_of)));
  if (!material.bending_mesh.empty()) {
    info.lines.push_back(labelled("mesh of the hinges", material.bending_mesh));
  }
  info.lines.push_back(labelled("components", status_counts(material)));
  Json components = Json::object();
  for (const auto& [name, component] : material.components) {
    components[name] = component_info(material, name, info);
  }
  info.json["components"] = std::move(components);
  add_samples(material, info);
  add_limits(material, info);
  add_texts(material, info);
  return info;
}

}  // namespace pliant
