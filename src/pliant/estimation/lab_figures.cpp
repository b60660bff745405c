#include "pliant/estimation/lab_figures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pliant/base/assert.h"
#include "pliant/estimation/figure_reader.h"
#include "pliant/experiment/bending_length/bending_length.h"
#include "pliant/experiment/pulled_figures.h"
#include "pliant/experiment/uniaxial_geometry.h"
#include "pliant/material/bending_strain.h"
#include "pliant/material/kes_bending.h"
#include "pliant/material/kes_shear.h"
#include "pliant/material/law_path.h"

namespace pliant {
namespace {

double stress_while_loading(const ComponentLaw& law, double strain) {
  return LawPath(law, {}).stress_at(strain);
}

double stress_after_turning(const ComponentLaw& law, double turn, double strain) {
  LawPath path(law, {});
  path.turn_at(turn, {});
  return path.stress_at(strain);
}

/// The next number below among 1, 2, 5, 10, 20, ...
double round_down(double value) {
  constexpr double kRounding = 1e-9;  // 0.19999... is 0.2
  value *= 1 + kRounding;
  const double decade = std::pow(10, std::floor(std::log10(value)));
  for (const double digit : {5.0, 2.0}) {
    if (value >= digit * decade) return digit * decade;
  }
  return decade;
}

/// What a tester draws over what: force per width over extension, or shear stress over the shear
/// angle.
struct Chart {
  UniaxialGeometry strip{.gauge_length = 1, .width = 1};
  bool shear = false;

  double strain(double at) const { return shear ? std::sin(at) : strain_at(strip, 1 + at); }
  /// Extension or angle of a strain.
  double at(double strain) const {
    return shear ? std::asin(strain) : extension_at(strip.measure, strain);
  }
  /// What a modulus is taken over.
  double base(double at) const { return shear ? std::sin(at) : at; }
  double force(double stress, double strain) const {
    return shear ? stress : stress * force_factor(strip, strain);
  }
  double rounded(double at) const {
    constexpr double kDegree = std::numbers::pi / 180;
    return shear ? kDegree * round_down(at / kDegree) : round_down(at);
  }
};

FigureReading secant_modulus(const Chart& chart, double at) {
  return [=](const MaterialComponent& component) {
    const double strain = chart.strain(at);
    return chart.force(stress_while_loading(law_of(component), strain), strain) / chart.base(at);
  };
}

FigureReading loop_width(const Chart& chart, double at, double turn) {
  return [=](const MaterialComponent& component) {
    const double strain = chart.strain(at);
    const ComponentLaw law = law_of(component);
    return chart.force(
        stress_while_loading(law, strain) - stress_after_turning(law, chart.strain(turn), strain),
        strain);
  };
}

double tangent_at_rest(const MaterialComponent& component) {
  return law_of(component).stiffness_at_rest();
}

/// What instruments print of a pull, where the law comes to their loads within one and a half times
/// the range of the data.
void add_pull(const Material& material, const std::string& component, FigureReader& figures) {
  constexpr double kFurthest = 1.5;
  const UniaxialGeometry strip{1, 1, material.membrane};
  const auto cycle_to = [membrane = material.membrane](const MaterialComponent& pulled,
                                                       double load) {
    return pulled_to(law_of(pulled), membrane, load);
  };
  const auto end_of = [&](double load) {
    const auto cycle = cycle_to(figures.component(), load);
    return cycle ? strain_at(strip, 1 + cycle->out.extension.back()) : INFINITY;
  };
  const auto reaches = [&](double strain) {
    const bool ranged = figures.component().range.has_value();
    return std::isfinite(strain) && (!ranged || strain <= kFurthest * figures.end());
  };
  if (const double end = end_of(kKesTensileLoad); reaches(end)) {
    const auto kes = [&](auto number) {
      return [=](const MaterialComponent& pulled) -> std::optional<double> {
        const auto cycle = cycle_to(pulled, kKesTensileLoad);
        const auto figure = cycle ? kes_tensile(*cycle) : std::nullopt;
        return figure ? number(*figure) : std::nullopt;
      };
    };
    using Number = std::optional<double>;
    figures.add("kes_EMT", "1", kes([](const KesTensile& k) { return Number(k.extension); }), 0,
                end);
    figures.add("kes_LT", "1", kes([](const KesTensile& k) { return Number(k.linearity); }), 0,
                end);
    figures.add("kes_WT", "N/m", kes([](const KesTensile& k) { return Number(k.work); }), 0, end);
    figures.add("kes_RT", "1", kes([](const KesTensile& k) { return k.resilience; }), 0, end);
  }
  const auto extension_at = [&](double load) {
    return [=](const MaterialComponent& pulled) -> std::optional<double> {
      const auto cycle = cycle_to(pulled, load);
      return cycle ? std::optional(cycle->out.extension.back()) : std::nullopt;
    };
  };
  constexpr const char* kNames[] = {"fast_E5", "fast_E20", "fast_E100"};
  for (int i = 0; i < 3; ++i) {
    const double end = end_of(kFastLoads[i]);
    if (reaches(end)) figures.add(kNames[i], "1", extension_at(kFastLoads[i]), 0, end);
  }
  if (component != "stretch.bias") return;
  const double end = end_of(kFastLoads[0]);
  if (!reaches(end)) return;
  figures.add(
      "fast_G", "N/m",
      [e5 = extension_at(kFastLoads[0])](const MaterialComponent& pulled) {
        const auto extension = e5(pulled);
        return extension ? std::optional(fast_shear_rigidity(*extension)) : std::nullopt;
      },
      0, end);
}

void add_kes_shear(FigureReader& figures) {
  const auto kes = [](double KesShear::*number) {
    return [number](const MaterialComponent& sheared) {
      return std::optional(kes_shear(sheared).*number);
    };
  };
  const double turn = std::sin(kKesLargestAngle);
  figures.add("kes_G", "N/m", kes(&KesShear::rigidity), 0, turn);
  if (!law_of(figures.component()).remembers()) return;
  figures.add("kes_2HG", "N/m", kes(&KesShear::hysteresis), 0, turn);
  figures.add("kes_2HG5", "N/m", kes(&KesShear::hysteresis_at_five), 0, turn);
}

/// Moduli and the width of the loop within the range of the data.
void add_chart(const Chart& chart, FigureReader& figures) {
  constexpr double kLeast = 1e-4;  // of strain: below, there is no chart to read
  if (!(figures.end() > kLeast) || (chart.shear && figures.end() >= 1)) return;
  const double end = chart.at(figures.end());
  for (const double at : {chart.rounded(end / 2), end}) {
    const double strain = chart.strain(at);
    figures.add("secant_modulus", "N/m", secant_modulus(chart, at), strain, strain, at);
  }
  if (!law_of(figures.component()).remembers()) return;
  const double half = end / 2;
  figures.add("loop_width", "N/m", loop_width(chart, half, end), chart.strain(half), figures.end(),
              half);
}

/// Poisson's ratio, of engineering strains, half way and at the end of the range of the data.
void add_contraction(const Material& material, FigureReader& figures) {
  constexpr double kLeast = 1e-4;  // of strain
  if (!(figures.end() > kLeast)) return;
  const UniaxialGeometry strip{1, 1, material.membrane};
  const double end = length_at(strip, figures.end()) - 1;
  for (const double extension : {end / 2, end}) {
    const double strain = strain_at(strip, 1 + extension);
    figures.add(
        "poisson_ratio", "1",
        [=](const MaterialComponent& component) {
          return stress_while_loading(law_of(component), strain) / extension;
        },
        strain, strain, extension);
  }
}

/// @param component  that instruments read: of a metric of triangles there is no chart
void add_membrane(const Material& material, const std::string& component, FigureReader& figures) {
  figures.add("stiffness_at_rest", "N/m", tangent_at_rest, 0, 0);
  if (solid_metric_of(component)) return;
  Chart chart;
  chart.strip.measure = material.membrane;
  chart.shear = component == "shear";
  add_chart(chart, figures);
  if (chart.shear) {
    add_kes_shear(figures);
  } else {
    add_pull(material, component, figures);
  }
}

std::optional<double> flexural_rigidity(const MaterialComponent& component, double density) {
  const auto length = bending_length(law_of(component), density);
  return length ? std::optional(length->flexural_rigidity) : std::nullopt;
}

/// Numbers of the sheet, whose moment per width is the stress at three times its curvature.
void add_bending(const Material& material, FigureReader& figures) {
  const double end = figures.end();
  figures.add(
      "rigidity_at_rest", "N m",
      [](const MaterialComponent& component) {
        return kStrainPerCurvature * tangent_at_rest(component);
      },
      0, 0);
  if (end > 0) {
    figures.add(
        "secant_rigidity", "N m",
        [end](const MaterialComponent& component) {
          return stress_while_loading(law_of(component), end) / (end / kStrainPerCurvature);
        },
        end, end, end / kStrainPerCurvature);
  }
  figures.add(
      "kes_B", "N m",
      [](const MaterialComponent& component) { return kes_bending(component).rigidity; },
      kStrainPerCurvature * kKesSlopeCurvature[0], kStrainPerCurvature * kKesSlopeCurvature[1]);
  if (law_of(figures.component()).remembers()) {
    figures.add(
        "kes_2HB", "N",
        [](const MaterialComponent& component) { return kes_bending(component).hysteresis; }, 0,
        kStrainPerCurvature * kKesHysteresisCurvature);
  }
  if (!(material.density > 0)) return;
  figures.add(
      "bending_length", "m",
      [density = material.density](const MaterialComponent& component) {
        const auto length = bending_length(law_of(component), density);
        return length ? std::optional(length->length) : std::nullopt;
      },
      0, 0);
  figures.add(
      "flexural_rigidity", "N m",
      [density = material.density](const MaterialComponent& component) {
        return flexural_rigidity(component, density);
      },
      0, 0);
}

bool is_of_sheet(const Material& material) {
  return material.bending == "discrete-shells" && material.bending_of == "sheet";
}

std::optional<double> flexural_rigidity(const Material& material, const std::string& component) {
  const auto found = material.components.find(component);
  if (found == material.components.end() || !found->second.stiffness) return std::nullopt;
  if (!(material.density > 0) || !is_of_sheet(material)) return std::nullopt;
  return flexural_rigidity(found->second, material.density);
}

const LabFigure* find_figure(const std::vector<LabFigure>& figures, std::string_view name) {
  const auto found = std::ranges::find(figures, name, &LabFigure::name);
  return found == figures.end() ? nullptr : &*found;
}

/// The coupling c of a sheet whose strips have the secants s, as both free edges have it: along a
/// pull (s_along + c r) E, across it c E = (c / r) r E with r the narrowing per strain, so that
///
///     c = r s_along s_across / (s_along - r^2 s_across)
///
/// Read half way; nothing where no elastic sheet narrows by so much.
std::optional<double> coupling_of(const Material& material, const std::string& component,
                                  const LabFigure& ratio) {
  const bool warp = component == "contraction.warp";
  const auto secant = [&](const char* name, double strain) -> std::optional<double> {
    const auto found = material.components.find(name);
    if (found == material.components.end() || !found->second.stiffness) return std::nullopt;
    return law_of(found->second).elastic_secant(strain);
  };
  const UniaxialGeometry strip{1, 1, material.membrane};
  const double strain = strain_at(strip, 1 + *ratio.at);
  const double narrowing = -strain_at(strip, 1 - ratio.value * *ratio.at);
  const double r = narrowing / strain;
  const auto along = secant(warp ? "stretch.warp" : "stretch.weft", strain),
             across = secant(warp ? "stretch.weft" : "stretch.warp", narrowing);
  if (!along || !across || !(*along > r * r * *across)) return std::nullopt;
  return r * *along * *across / (*along - r * r * *across);
}

void add_coupling(const Material& material, const std::string& component,
                  std::vector<LabFigure>& figures) {
  const LabFigure* ratio = find_figure(figures, "poisson_ratio");
  if (!ratio || !ratio->at) return;
  const auto coupling = coupling_of(material, component, *ratio);
  if (!coupling) return;
  const bool beyond = ratio->beyond_range;
  figures.push_back({component, "coupling", "N/m", *coupling, {}, {}, beyond});
}

/// Figures that two components make together; what their errors make is not known.
void add_of_two(const Material& material, const std::string& component,
                std::vector<LabFigure>& figures) {
  if (component == "stretch.weft" || component == "stretch.warp") {
    const auto rigidity = flexural_rigidity(material, "bend" + component.substr(7));
    const LabFigure* e5 = find_figure(figures, "fast_E5");
    const LabFigure* e20 = find_figure(figures, "fast_E20");
    if (!rigidity || !e5 || !e20) return;
    const bool beyond = e5->beyond_range || e20->beyond_range;
    figures.push_back({component,
                       "fast_formability",
                       "m^2",
                       fast_formability(e5->value, e20->value, *rigidity),
                       {},
                       {},
                       beyond});
  }
  if (component == "contraction.weft" || component == "contraction.warp") {
    add_coupling(material, component, figures);
  }
  if (component == "bend.weft") {
    const auto weft = flexural_rigidity(material, component),
               warp = flexural_rigidity(material, "bend.warp");
    if (!weft || !warp) return;
    figures.push_back(
        {component, "overall_flexural_rigidity", "N m", std::sqrt(*weft * *warp), {}, {}, false});
  }
}

}  // namespace

std::vector<LabFigure> lab_figures(const Material& material, const std::string& component,
                                   const ErrorOfLaw& error_of) {
  PLIANT_ASSERT(material.components.at(component).stiffness.has_value(),
                "a component with numbers");
  if (is_sheet_pair(component)) return {};
  FigureReader figures(material, component, error_of);
  if (is_contraction(component)) {
    add_contraction(material, figures);
  } else if (!is_bending(component)) {
    add_membrane(material, component, figures);
  } else if (is_of_sheet(material)) {
    add_bending(material, figures);
  }
  std::vector<LabFigure> all = figures.take();
  add_of_two(material, component, all);
  return all;
}

}  // namespace pliant
