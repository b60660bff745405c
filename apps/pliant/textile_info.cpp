#include "apps/pliant/textile_info.h"

#include <numbers>

#include <fmt/format.h>

#include "pliant/base/number_text.h"
#include "pliant/base/quantity.h"
#include "pliant/estimation/lab_figures.h"
#include "pliant/experiment/bending_length/bending_length.h"
#include "pliant/experiment/textile_figure.h"
#include "pliant/material/bending_strain.h"
#include "pliant/material/kes_bending.h"

namespace pliant {
namespace {

// "0.19 gf cm^2/cm (18.6 uN m)"
std::string in_both(double si, const char* unit, Dimension dimension) {
  return fmt::format("{} {} ({})", format_number(si / *unit_scale(unit, dimension), kInfoDigits),
                     unit, format_quantity(si, dimension, kInfoDigits));
}

bool reaches_beyond(const MaterialComponent& component) {
  return component.range && component.range->second < kStrainPerCurvature * kKesSlopeCurvature[1];
}

void add_kes(const MaterialComponent& component, std::vector<std::string>& lines, Json& json) {
  const KesBending kes = kes_bending(component);
  const char* rigidity_unit = "gf cm^2/cm";
  const char* moment_unit = "gf cm/cm";
  json["kes_B_N_m"] = kes.rigidity;
  json["kes_B_gf_cm2_per_cm"] =
      kes.rigidity / *unit_scale(rigidity_unit, Dimension::bending_stiffness);
  json["kes_2HB_N"] = kes.hysteresis;
  json["kes_2HB_gf_cm_per_cm"] = kes.hysteresis / *unit_scale(moment_unit, Dimension::force);
  json["residual_curvature_1_per_m"] =
      kes.residual_curvature ? Json(*kes.residual_curvature) : Json(nullptr);
  json["kes_beyond_range"] = reaches_beyond(component);
  lines.push_back(labelled("KES bending B",
                           in_both(kes.rigidity, rigidity_unit, Dimension::bending_stiffness), 1));
  lines.push_back(
      labelled("KES bending 2HB", in_both(kes.hysteresis, moment_unit, Dimension::force), 1));
  if (kes.residual_curvature) {
    lines.push_back(labelled("residual curvature",
                             fmt::format("{} 1/m, unloaded from 250 1/m",
                                         format_number(*kes.residual_curvature, kInfoDigits)),
                             1));
  }
  if (reaches_beyond(component)) {
    lines.push_back(labelled("", "B, 2HB: by the law beyond the curvatures that were measured", 1));
  }
}

void add_bending_length(const Material& material, const std::string& name,
                        std::vector<std::string>& lines, Json& json) {
  for (const char* key : {"overhang_m", "bending_length_m", "flexural_rigidity_N_m"}) {
    json[key] = nullptr;
  }
  if (!(material.density > 0)) {
    lines.push_back(labelled("bending length", "not known without the density", 1));
    return;
  }
  const auto length = bending_length(*law_of(material, name), material.density);
  if (!length) {
    lines.push_back(labelled("bending length", "no overhang below 10 m dips by 41.5 degrees", 1));
    return;
  }
  json["overhang_m"] = length->overhang;
  json["bending_length_m"] = length->length;
  json["flexural_rigidity_N_m"] = length->flexural_rigidity;
  lines.push_back(
      labelled("bending length",
               fmt::format("{}, overhang {} at 41.5 degrees (ASTM D1388, ISO 9073-7)",
                           format_quantity(length->length, Dimension::length, kInfoDigits),
                           format_quantity(length->overhang, Dimension::length, kInfoDigits)),
               1));
  lines.push_back(labelled(
      "flexural rigidity",
      format_quantity(length->flexural_rigidity, Dimension::bending_stiffness, kInfoDigits), 1));
}

std::string place_in_words(const std::string& component, double at) {
  if (component != "shear") return format_number(100 * at, 2) + " % extension";
  return format_number(at * 180 / std::numbers::pi, 2) + " degrees";
}

/// A figure of a standard: "3.2 % (KES-FB1: extension at 500 gf/cm; usual 1 to 40)".
std::string with_meaning(const TextileFigure& kind, double si) {
  const std::string usual =
      kind.usual_most > 0 ? fmt::format("; usual {} to {}", kind.usual_least, kind.usual_most) : "";
  return fmt::format("{} ({}: {}{})", in_lab_unit(kind, si), kind.standard, kind.meaning, usual);
}

void add_standard(const LabFigure& figure, const TextileFigure& kind, FileInfo& info, Json& json) {
  json["standards"].push_back({{"name", figure.name},
                               {"standard", kind.standard},
                               {"value", kind.per_si * figure.value},
                               {"unit", kind.lab_unit},
                               {"beyond_range", figure.beyond_range}});
  info.lines.push_back(labelled(
      std::string(kind.symbol),
      with_meaning(kind, figure.value) + (figure.beyond_range ? ", beyond what was measured" : ""),
      1));
}

std::string charted(const std::string& figure) {
  if (figure == "loop_width") return "width of the loop";
  return figure == "poisson_ratio" ? "Poisson's ratio" : "secant modulus";
}

/// What a chart of a tester shows of stretch, shear and contraction.
Json chart_info(const Material& material, const std::string& name, FileInfo& info) {
  Json json{{"figures", Json::array()}, {"standards", Json::array()}};
  for (const LabFigure& figure : lab_figures(material, name, {})) {
    if (const TextileFigure* kind = find_textile_figure(figure.name)) {
      add_standard(figure, *kind, info, json);
    }
    if (figure.name == "coupling") {
      json["figures"].push_back({{"name", figure.name}, {"value", figure.value}, {"at", nullptr}});
      info.lines.push_back(
          labelled("coupling",
                   format_quantity(figure.value, Dimension::force_per_length, kInfoDigits) +
                       ", of an elastic sheet that narrows so",
                   1));
    }
    if (!figure.at) continue;  // the stiffness at rest stands above
    json["figures"].push_back({{"name", figure.name}, {"value", figure.value}, {"at", *figure.at}});
    const std::string value =
        figure.unit == "1"
            ? format_number(figure.value, kInfoDigits)
            : format_quantity(figure.value, Dimension::force_per_length, kInfoDigits);
    info.lines.push_back(labelled(
        charted(figure.name), fmt::format("{} at {}", value, place_in_words(name, *figure.at)), 1));
  }
  return json;
}

}  // namespace

Json textile_info(const Material& material, const std::string& name, FileInfo& info) {
  if (!is_bending(name)) return chart_info(material, name, info);
  Json json;
  add_kes(material.components.at(name), info.lines, json);
  add_bending_length(material, name, info.lines, json);
  return json;
}

}  // namespace pliant
