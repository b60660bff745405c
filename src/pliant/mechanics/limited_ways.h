#pragma once

#include <Eigen/Core>

namespace pliant {

/// What shares of their ways some energies may go at once, so that none passes its limit and each
/// keeps a share of what is left to it: the first of falling shares that do. Those that have passed
/// it where they begin go as they like.
/// @param left   share of its limit that is left to each at the start
/// @param after  left to each after a share of the ways
template <class After>
Eigen::ArrayXd shares_within_limits(const Eigen::ArrayXd& left, double kept, const After& after) {
  constexpr double kLess = 0.7, kShortest = 1e-9;
  Eigen::ArrayXd shares = Eigen::ArrayXd::Zero(left.size());
  for (double share = 1; share > kShortest; share *= kLess) {
    const Eigen::ArrayXd now = after(share);
    const Eigen::Array<bool, Eigen::Dynamic, 1> may = left <= 0 || now >= kept * left;
    shares = (shares == 0 && may).select(share, shares);
    if ((shares > 0).all()) break;
  }
  return shares;
}

}  // namespace pliant
