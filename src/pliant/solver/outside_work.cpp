#include "pliant/solver/outside_work.h"

namespace pliant {

// Of points that move freely the forces balance, but for what the search leaves: it belongs to the
// forces that hold what is led.
double outside_work(const Objective& objective, const Configuration& to,
                    const Eigen::Matrix3Xd& gradient, const Controls& before) {
  const Conditions& under = objective.conditions();
  const Eigen::Matrix3Xd way = to.positions - under.from.configuration.positions;
  return gradient.cwiseProduct(way).sum() + objective.system().outside_work(to, under, before);
}

}  // namespace pliant
