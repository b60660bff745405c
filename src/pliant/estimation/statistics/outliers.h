#pragma once

#include <vector>

#include <Eigen/Core>

namespace pliant {

/// A row that the fit leaves by far.
struct Outlier {
  Eigen::Index row = 0;
  double in_sd = 0;  ///< signed, predicted - measured
};

/// Rows that the fit leaves by more than `limit` standard deviations, farthest first.
///
/// A row's residual has the variance sd^2 (1 - leverage). Where sd came from the residuals the row
/// is judged by the sd of the others (its deleted residual, [Cook1982]): one row of n can stand out
/// from a scatter that includes itself by no more than sqrt(n) of them. Rows whose prediction is
/// all their own (leverage 1) cannot stand out.
/// @param residual  of one experiment, in units of sd (not of sd sqrt(L))
/// @param leverage  of each row (`row_leverages`)
/// @param spare     rows - leverage from which sd was estimated; infinite where it is stated or
/// assumed
std::vector<Outlier> outliers(const Eigen::VectorXd& residual, const Eigen::VectorXd& leverage,
                              double spare, double limit = 5);

}  // namespace pliant
