#include "pliant/mechanics/point_forces.h"

namespace pliant {

void PointForces::evaluate(const Evaluation& at, Derivatives& derivatives) const {
  derivatives.energy.stored -= forces_.cwiseProduct(at.configuration.positions).sum();
  if (derivatives.gradient) *derivatives.gradient -= forces_;
}

}  // namespace pliant
