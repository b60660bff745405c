#include "pliant/mechanics/potential.h"

namespace pliant {

double energy_by_controls(const Potential& potential, const Configuration& at,
                          const Controls& before, const Controls& now) {
  const auto energy = [&](const Controls& controls) {
    Derivatives derivatives;
    potential.evaluate({.configuration = at, .controls = controls}, derivatives);
    return derivatives.energy.total();
  };
  return energy(now) - energy(before);
}

}  // namespace pliant
