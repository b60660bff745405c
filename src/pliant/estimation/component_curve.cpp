#include "pliant/estimation/component_curve.h"

#include <limits>

#include "pliant/material/law_path.h"

namespace pliant {
namespace {

constexpr int kPoints = 100;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

}  // namespace

ComponentCurve component_curve(const std::string& component, const ComponentLaw& law,
                               double largest_strain, const ErrorOfLaw& error_of) {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(law.parameter_count());
  LawPath loading(law, {0, 0, zero, zero});
  LawPath unloading = loading;
  unloading.turn_at(largest_strain, zero);

  ComponentCurve curve;
  curve.component = component;
  for (int i = 0; i <= kPoints; ++i) {
    const double strain = largest_strain * i / kPoints;
    const PathStress load = loading.at(strain);
    const auto error = error_of ? error_of(load.gradient) : std::nullopt;
    const double half = error ? error->half_width : kNone;
    curve.strain.push_back(strain);
    curve.load.push_back(load.stress);
    curve.unload.push_back(unloading.at(strain).stress);
    curve.low.push_back(load.stress - half);
    curve.high.push_back(load.stress + half);
    curve.elastic.push_back(law.elastic_stress(strain));
    curve.max_friction.push_back(law.max_friction(strain));
  }
  return curve;
}

ErrorOfLaw errors_of_law(const Uncertainty& uncertainty, Eigen::Index first) {
  return [&uncertainty, first](const Eigen::VectorXd& by_law) {
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(uncertainty.std_error.size());
    gradient.segment(first, by_law.size()) = by_law;
    return uncertainty.error_of(gradient);
  };
}

}  // namespace pliant
