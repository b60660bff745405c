#include "pliant/estimation/lab_figures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "pliant/base/assert.h"
#include "pliant/experiment/overhang/bending_length.h"
#include "pliant/experiment/uniaxial_geometry.h"
#include "pliant/material/bending_strain.h"
#include "pliant/material/kes_bending.h"
#include "pliant/material/law_path.h"

namespace pliant {
namespace {

constexpr double kStep = 1e-4;  // of a parameter, for differences: far above rounding, far below it

/// A number that is read off a component.
using Reading = std::function<std::optional<double>(const MaterialComponent&)>;

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

Reading secant_modulus(const Chart& chart, double at) {
  return [=](const MaterialComponent& component) {
    const double strain = chart.strain(at);
    return chart.force(stress_while_loading(law_of(component), strain), strain) / chart.base(at);
  };
}

Reading loop_width(const Chart& chart, double at, double turn) {
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

/// Collects the figures of a component with their errors.
class Figures {
 public:
  Figures(const Material& material, std::string name, const ErrorOfLaw& error_of)
      : name_(std::move(name)), component_(material.components.at(name_)), error_of_(error_of) {}

  const MaterialComponent& component() const { return component_; }
  double end() const { return component_.range ? component_.range->second : 0; }

  /// @param from, to  strains between which the law is read
  void add(const char* name, const char* unit, const Reading& read, double from, double to,
           std::optional<double> at = std::nullopt) {
    const std::optional<double> value = read(component_);
    if (!value || !std::isfinite(*value)) return;
    all_.push_back({name_, name, unit, *value, at, error(read), is_beyond(from, to)});
  }

  std::vector<LabFigure> take() { return std::move(all_); }

 private:
  /// Of what the data cover; their ends count as met by a hundredth.
  bool is_beyond(double from, double to) const {
    if (!component_.range) return true;
    const auto [low, high] = *component_.range;
    const double slack = 0.01 * high;
    return from < low - slack || to > high + slack;
  }

  std::optional<CurveError> error(const Reading& read) const {
    // Of friction that differs between the sides the parameters are twice as many.
    if (!error_of_ || (component_.friction && component_.friction->negative)) return std::nullopt;
    const ComponentLaw law = law_of(component_);
    const Eigen::VectorXd steps = steps_of(law);
    Eigen::VectorXd gradient(law.parameter_count());
    for (Eigen::Index i = 0; i < gradient.size(); ++i) {
      const auto up = read_with(law, i, steps(i), read), down = read_with(law, i, -steps(i), read);
      if (!up || !down) return std::nullopt;
      gradient(i) = (*up - *down) / (2 * steps(i));
    }
    return gradient.allFinite() ? error_of_(gradient) : std::nullopt;
  }

  std::optional<double> read_with(const ComponentLaw& law, Eigen::Index parameter, double step,
                                  const Reading& read) const {
    Eigen::VectorXd parameters = law.parameters();
    parameters(parameter) += step;
    MaterialComponent moved = component_;
    set_law(moved, law.with_parameters(parameters));
    return read(moved);
  }

  /// A parameter that is zero moves by a share of the largest one of its unit.
  Eigen::VectorXd steps_of(const ComponentLaw& law) const {
    const std::vector<std::string> units = parameter_units(law, units_of(name_));
    const Eigen::VectorXd parameters = law.parameters();
    Eigen::VectorXd steps = kStep * parameters.cwiseAbs();
    for (Eigen::Index i = 0; i < steps.size(); ++i) {
      for (Eigen::Index j = 0; j < steps.size() && parameters(i) == 0; ++j) {
        const bool alike = units[static_cast<std::size_t>(i)] == units[static_cast<std::size_t>(j)];
        if (alike) steps(i) = std::max(steps(i), kStep * std::abs(parameters(j)));
      }
      if (steps(i) == 0) steps(i) = kStep;
    }
    return steps;
  }

  std::string name_;
  MaterialComponent component_;
  const ErrorOfLaw& error_of_;
  std::vector<LabFigure> all_;
};

/// @param component  that instruments read: of a metric of triangles there is no chart
void add_membrane(const Material& material, const std::string& component, Figures& figures) {
  constexpr double kLeast = 1e-4;  // of strain: below, there is no chart to read
  Chart chart;
  chart.strip.measure = material.membrane;
  chart.shear = component == "shear";
  figures.add("stiffness_at_rest", "N/m", tangent_at_rest, 0, 0);
  if (solid_metric_of(component)) return;
  if (!(figures.end() > kLeast) || (chart.shear && figures.end() >= 1)) return;
  const double end = chart.at(figures.end());
  for (const double at : {chart.rounded(end / 2), end}) {
    const double strain = chart.strain(at);
    figures.add("secant_modulus", "N/m", secant_modulus(chart, at), strain, strain, at);
  }
  if (law_of(figures.component()).remembers()) {
    const double half = end / 2;
    figures.add("loop_width", "N/m", loop_width(chart, half, end), chart.strain(half),
                figures.end(), half);
  }
}

/// Numbers of the sheet, whose moment per width is the stress at three times its curvature.
void add_bending(const Material& material, Figures& figures) {
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
}

}  // namespace

std::vector<LabFigure> lab_figures(const Material& material, const std::string& component,
                                   const ErrorOfLaw& error_of) {
  PLIANT_ASSERT(material.components.at(component).stiffness.has_value(),
                "a component with numbers");
  if (is_sheet_pair(component)) return {};
  Figures figures(material, component, error_of);
  if (!is_bending(component)) {
    add_membrane(material, component, figures);
  } else if (material.bending == "discrete-shells" && material.bending_of == "sheet") {
    add_bending(material, figures);
  }
  return figures.take();
}

}  // namespace pliant
