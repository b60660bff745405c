#include "pliant/experiment/experiment.h"

namespace pliant {

void append_nuisance(const std::vector<NuisanceParameter>& own,
                     std::vector<std::string>& parameters, Eigen::VectorXd& values) {
  for (const NuisanceParameter& parameter : own) {
    parameters.push_back(parameter.name);
    values.conservativeResize(values.size() + 1);
    values(values.size() - 1) = parameter.start;
  }
}

Eigen::ArrayXd Experiment::weights() const {
  return Eigen::Map<const Eigen::Array<char, Eigen::Dynamic, 1>>(info_.used.data(),
                                                                 std::ssize(info_.used))
      .cast<double>();
}

}  // namespace pliant
