#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

namespace pliant {

/// The places where a strain measure is taken: each stencil's points, rest shape and rest measure.
template <class Measure>
struct Stencils {
  std::vector<std::array<int, Measure::kNodes>> points;
  std::vector<typename Measure::Rest> rests;
  std::vector<double> sizes;  ///< rest area (m^2), or volume (m^3); times a factor of the material
  /// Of the samples of a heterogeneous material, a column a stencil; empty: the material is one.
  Eigen::MatrixXd weights = {};

  void add(const std::array<int, Measure::kNodes>& nodes, const typename Measure::Rest& rest,
           double size) {
    points.push_back(nodes);
    rests.push_back(rest);
    sizes.push_back(size);
  }
};

}  // namespace pliant
