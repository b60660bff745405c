#include "pliant/material/bounded_factors.h"

#include <limits>

#include <Eigen/QR>

namespace pliant {
namespace {

constexpr double kLeastFactor = 0.01, kGreatestFactor = 10;

}  // namespace

// With three unknowns every choice of those that stand on a limit can be tried; the solution is the
// best candidate within the limits.
Eigen::Vector3d bounded_factors(const Eigen::Matrix<double, 4, 3>& a, const Eigen::Vector4d& b) {
  constexpr int kChoices = 3;  // of each unknown: at its lower limit, at its upper limit, free
  Eigen::Vector3d best = Eigen::Vector3d::Ones();
  double least = std::numeric_limits<double>::infinity();
  for (int choice = 0; choice < kChoices * kChoices * kChoices; ++choice) {
    const int choices[3] = {choice % kChoices, choice / kChoices % kChoices,
                            choice / (kChoices * kChoices)};
    Eigen::Matrix<double, 4, 3> free_columns = Eigen::Matrix<double, 4, 3>::Zero();
    Eigen::Vector3d x;
    for (int j = 0; j < 3; ++j) {
      x(j) = choices[j] == 1 ? kGreatestFactor : kLeastFactor;
      if (choices[j] == 2) free_columns.col(j) = a.col(j);
    }
    // Least change: none of the unknowns whose columns are zero.
    x += free_columns.completeOrthogonalDecomposition().solve(b - a * x).eval();
    const bool is_within = x.minCoeff() >= kLeastFactor && x.maxCoeff() <= kGreatestFactor;
    const double error = (a * x - b).squaredNorm();
    if (is_within && error < least) {
      least = error;
      best = x;
    }
  }
  return best;
}

}  // namespace pliant
