#include "pliant/estimation/parameter_limits.h"

#include "pliant/estimation/monotone_stress.h"
#include "pliant/estimation/parameter_option.h"

namespace pliant {
namespace {

constexpr double kUnbounded = 1e12;

void law_limits(const ComponentLaw& shape, const DataScale& data, ParameterLimits& limits) {
  const double stiffness = data.stress / data.strain;
  for (int i = 0; i < shape.stiffness.size(); ++i) {
    limits.lower(i) = 0;
    limits.upper(i) = kUnbounded;
    limits.scale(i) = stiffness;
  }
  // k2 of an affine stiffness multiplies the strain once more.
  if (shape.stiffness.kind() == CurveKind::affine) limits.scale(1) = stiffness / data.strain;
  if (shape.friction_law == FrictionLaw::none) return;

  const int first = shape.stiffness.size();
  const bool has_tau = shape.friction_law == FrictionLaw::dahl;
  limits.lower.segment(first, 3) << (has_tau ? 0 : 1e-9 * data.stress), 0,
      (has_tau ? 1e-3 * data.strain : 1e-3 * stiffness);
  limits.upper.segment(first, 3) << kUnbounded, kUnbounded,
      (has_tau ? 3 * data.strain : 1e4 * stiffness);
  limits.scale.segment(first, 3) << 0.2 * data.stress, 0.2 * stiffness,
      (has_tau ? 0.1 * data.strain : stiffness);
}

// Without friction the state of friction means nothing.
void hold_friction_nuisance(const ComponentLaw& shape,
                            const std::vector<NuisanceParameter>& nuisance,
                            ParameterLimits& limits) {
  for (size_t i = 0; i < nuisance.size(); ++i) {
    if (!nuisance[i].of_friction) continue;
    const size_t index = static_cast<size_t>(shape.parameter_count()) + i;
    limits.lower(static_cast<Eigen::Index>(index)) = 0;
    limits.upper(static_cast<Eigen::Index>(index)) = 0;
    limits.fixed[index] = 1;
  }
}

}  // namespace

ParameterLimits parameter_limits(const ComponentLaw& shape, const std::string& component,
                                 const std::vector<NuisanceParameter>& nuisance,
                                 const DataScale& data, const FitOptions& options) {
  ParameterLimits limits;
  limits.names = parameter_names(shape, component);
  limits.units = parameter_units(shape, is_bending(component));
  const auto count = static_cast<Eigen::Index>(limits.names.size() + nuisance.size());
  limits.lower.resize(count);
  limits.upper.resize(count);
  limits.scale.resize(count);
  law_limits(shape, data, limits);

  auto at = static_cast<Eigen::Index>(limits.names.size());
  for (const NuisanceParameter& parameter : nuisance) {
    limits.names.push_back(parameter.name);
    limits.units.push_back(parameter.unit);
    limits.lower(at) = parameter.lower;
    limits.upper(at) = parameter.upper;
    limits.scale(at++) = parameter.scale;
  }

  limits.fixed.assign(limits.names.size(), 0);
  limits.priors.resize(limits.names.size());
  for (size_t i = 0; i < limits.names.size(); ++i) {
    const auto index = static_cast<Eigen::Index>(i);
    if (const auto bounds = option_for(limits.names[i], options.bounds)) {
      limits.lower(index) = bounds->first;
      limits.upper(index) = bounds->second;
    }
    if (const auto value = option_for(limits.names[i], options.fix)) {
      limits.lower(index) = limits.upper(index) = *value;
      limits.fixed[i] = 1;
    }
    limits.priors[i] = option_for(limits.names[i], options.priors);
  }
  if (shape.friction_law == FrictionLaw::none) hold_friction_nuisance(shape, nuisance, limits);
  if (options.monotone_stress) {
    const Eigen::MatrixXd tangents = elastic_tangents(shape.stiffness, data.strain);
    limits.not_negative.setZero(tangents.rows(), count);
    limits.not_negative.leftCols(tangents.cols()) = tangents;
  }
  return limits;
}

}  // namespace pliant
