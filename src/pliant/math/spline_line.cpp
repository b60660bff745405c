#include "pliant/math/spline_line.h"

#include <cmath>

#include <Eigen/QR>
#include <unsupported/Eigen/Splines>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

constexpr int kDegree = 3;

using Line = Eigen::Spline<double, 2>;

}  // namespace

SplineLine::SplineLine(const std::vector<Eigen::Vector2d>& points,
                       const std::vector<double>& shares, int spans) {
  PLIANT_ASSERT(spans >= 1 && points.size() == shares.size(), "a share for each point");
  const auto count = static_cast<Eigen::Index>(points.size());
  knots_.resize(spans + 2 * kDegree + 1);
  knots_ << Eigen::RowVectorXd::Zero(kDegree), Eigen::RowVectorXd::LinSpaced(spans + 1, 0, 1),
      Eigen::RowVectorXd::Ones(kDegree);
  Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(count, spans + kDegree), target(count, 2);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double u = shares[static_cast<size_t>(i)];
    const Eigen::Index span = Line::Span(u, kDegree, knots_);
    basis.row(i).segment(span - kDegree, kDegree + 1) = Line::BasisFunctions(u, kDegree, knots_);
    target.row(i) = points[static_cast<size_t>(i)].transpose();
  }
  controls_ = basis.colPivHouseholderQr().solve(target).transpose();
}

Eigen::Matrix<double, 2, Eigen::Dynamic> SplineLine::derivatives(double share, int order) const {
  const Line line(knots_, Line::ControlPointVectorType(controls_));
  return line.derivatives(share, order).matrix();
}

Eigen::Vector2d SplineLine::position(double share) const { return derivatives(share, 0).col(0); }

Eigen::Vector2d SplineLine::direction(double share) const { return derivatives(share, 1).col(1); }

double SplineLine::curvature(double share) const {
  const auto d = derivatives(share, 2);
  const double turn = d(0, 1) * d(1, 2) - d(1, 1) * d(0, 2);
  return turn / std::pow(std::hypot(d(0, 1), d(1, 1)), 3);
}

std::vector<double> length_shares(const std::vector<Eigen::Vector2d>& points) {
  std::vector<double> shares{0};
  for (size_t i = 1; i < points.size(); ++i) {
    shares.push_back(shares.back() + (points[i] - points[i - 1]).norm());
  }
  for (double& share : shares) share /= shares.back();
  return shares;
}

}  // namespace pliant
