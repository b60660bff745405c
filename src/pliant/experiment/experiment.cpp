#include "pliant/experiment/experiment.h"

#include <algorithm>
#include <cmath>

namespace pliant {

double Experiment::reference() const {
  if (info_.quantity.kind == "length") return measured_.maxCoeff() - measured_.minCoeff();
  return measured_.cwiseAbs().maxCoeff();
}

double Experiment::peak_force() const {
  double peak = 0;
  for (const double force : path_.force) peak = std::max(peak, std::abs(force));
  return peak;
}

}  // namespace pliant
