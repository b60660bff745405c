#include "pliant/solver/elastica/strip_profile.h"

#include <algorithm>
#include <cmath>

namespace pliant {

StripProfile::StripProfile(const GaussLine& line, double clamp_angle,
                           const Eigen::VectorXd& curvature,
                           const Eigen::MatrixXd& curvature_by_parameter)
    : line_(line),
      clamp_angle_(clamp_angle),
      grown_(3, line.size()),
      before_(Eigen::Matrix3Xd::Zero(3, line.elements())) {
  const Eigen::VectorXd turn = line.integrals(curvature);
  const Eigen::ArrayXd angle = turn.array() + clamp_angle;
  cosine_ = angle.cos();
  sine_ = angle.sin();
  grown_ << curvature.transpose(), cosine_.transpose(), sine_.transpose();
  for (int e = 1; e < line.elements(); ++e) {
    before_.col(e) =
        before_.col(e - 1) +
        grown_.middleCols<GaussLine::kOrder>(GaussLine::kOrder * (e - 1)) * line.element_weights();
  }
  if (curvature_by_parameter.size() > 0) {
    turn_by_parameter_ = line.integrals(curvature_by_parameter);
  }
}

StripPoint StripProfile::at(double place) const {
  const GaussLine::Local here = line_.at(place);
  const auto own = grown_.middleCols<GaussLine::kOrder>(here.first);
  const Eigen::Vector3d turn_x_y =
      before_.col(here.first / GaussLine::kOrder) + own * here.integral.transpose();
  const double angle = turn_x_y(0) + clamp_angle_;
  return {turn_x_y.tail<2>(), {std::cos(angle), std::sin(angle)}, own.row(0).dot(here.value)};
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
