#include "pliant/solver/elastica/strip_profile.h"

#include <algorithm>
#include <cmath>

namespace pliant {

StripProfile::StripProfile(const GaussLine& line, double clamp_angle,
                           const Eigen::VectorXd& curvature,
                           const Eigen::MatrixXd& curvature_by_parameter)
    : line_(line), clamp_angle_(clamp_angle), curvature_(curvature) {
  const Eigen::VectorXd turn = line.integrals(curvature);
  const Eigen::ArrayXd angle = turn.array() + clamp_angle;
  cosine_ = angle.cos();
  sine_ = angle.sin();
  if (curvature_by_parameter.size() > 0) {
    turn_by_parameter_ = line.integrals(curvature_by_parameter);
  }
}

StripPoint StripProfile::at(double place) const {
  const Eigen::RowVectorXd to_here = line_.integral_weights(place);
  const double angle = to_here * curvature_ + clamp_angle_;
  return {{to_here * cosine_, to_here * sine_},
          {std::cos(angle), std::sin(angle)},
          line_.value_weights(place) * curvature_};
}

Eigen::MatrixXd StripProfile::position_by_parameter(double place) const {
  const Eigen::RowVectorXd to_here = line_.integral_weights(place);
  Eigen::MatrixXd result(2, turn_by_parameter_.cols());
  result.row(0) = -to_here.cwiseProduct(sine_.transpose()) * turn_by_parameter_;
  result.row(1) = to_here.cwiseProduct(cosine_.transpose()) * turn_by_parameter_;
  return result;
}

// Newton's method on the squared distance, its curvature kept positive.
double StripProfile::nearest(const Eigen::Vector2d& target, double guess) const {
  constexpr int kMost = 30;
  constexpr double kTolerance = 1e-10;  // of the length
  double place = std::clamp(guess, 0.0, line_.length());
  for (int iteration = 0; iteration < kMost; ++iteration) {
    const StripPoint here = at(place);
    const Eigen::Vector2d beyond = here.position - target;
    const double growth = std::max(1 + here.curvature * here.normal().dot(beyond), 0.2);
    const double next = std::clamp(place - here.tangent.dot(beyond) / growth, 0.0, line_.length());
    const double moved = std::abs(next - place);
    place = next;
    if (moved < kTolerance * line_.length()) break;
  }
  return place;
}

}  // namespace pliant
