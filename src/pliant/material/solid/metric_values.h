#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace pliant {

/// What a metric of a solid's components shows of a Green strain: one value, or of a metric of
/// principal stretches three.
/// @param component  "green.xx", "I1-bar", "stretch"
/// @param strain     (E11, E22, E33, 2 E23, 2 E13, 2 E12)
std::vector<double> metric_values(const std::string& component,
                                  const Eigen::Matrix<double, 6, 1>& strain);

}  // namespace pliant
