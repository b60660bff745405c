#include "pliant/experiment/friction_path.h"

#include <utility>

namespace pliant {

FrictionPath::FrictionPath(const ComponentLaw& law, PathPoint start)
    : law_(law), start_(std::move(start)) {}

double FrictionPath::stress_at(double strain) const {
  const FrictionStress friction = law_.friction_stress(strain, {start_.strain, start_.friction});
  return law_.elastic_stress(strain) + friction.stress;
}

PathStress FrictionPath::at(double strain) const {
  const FrictionStress friction = law_.friction_stress(strain, {start_.strain, start_.friction});
  PathStress result;
  result.friction = friction.stress;
  result.friction_slope = friction.slope;
  result.stress = law_.elastic_stress(strain) + friction.stress;
  result.slope = law_.elastic_tangent(strain) + friction.slope;
  if (!with_gradients()) return result;

  result.friction_gradient = friction.from_strain * start_.strain_gradient +
                             friction.from_stress * start_.friction_gradient;
  const int stiffness = law_.stiffness.size();
  for (int i = 0; i < law_.friction_count(); ++i) {
    result.friction_gradient(stiffness + i) += friction.parameters[static_cast<size_t>(i)];
  }
  result.gradient = result.friction_gradient;
  result.gradient.head(stiffness) += strain * law_.stiffness.weights(strain);
  return result;
}

void FrictionPath::turn_at(double strain, const Eigen::VectorXd& strain_gradient) {
  const PathStress here = at(strain);
  if (with_gradients()) {
    start_.friction_gradient = here.friction_gradient + here.friction_slope * strain_gradient;
    start_.strain_gradient = strain_gradient;
  }
  start_.strain = strain;
  start_.friction = here.friction;
}

}  // namespace pliant
