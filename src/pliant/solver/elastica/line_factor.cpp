#include "pliant/solver/elastica/line_factor.h"

#include "pliant/base/assert.h"

namespace pliant {

LineFactor::LineFactor(const GaussLine& line, const Eigen::VectorXd& bending,
                       const Eigen::VectorXd& turning)
    : weights_(line.element_weights()), elements_(static_cast<size_t>(line.elements())) {
  const GaussLine::Block& local = line.element_integration();
  double beyond = 0;  // stiffness against turning of all that lies behind the element
  for (int e = line.elements() - 1; e >= 0 && positive_; --e) {
    Element& element = elements_[static_cast<size_t>(e)];
    const auto factor = turning.segment<GaussLine::kOrder>(GaussLine::kOrder * e);
    const GaussLine::Block turned = local.transpose() * factor.asDiagonal();
    GaussLine::Block own = turned * local + beyond * weights_ * weights_.transpose();
    own.diagonal() += bending.segment<GaussLine::kOrder>(GaussLine::kOrder * e);
    element.own.compute(own);
    positive_ = element.own.info() == Eigen::Success;
    element.by_angle = turned.rowwise().sum() + beyond * weights_;
    element.response = -element.own.solve(element.by_angle);
    beyond += factor.sum() + element.by_angle.dot(element.response);
  }
}

Eigen::MatrixXd LineFactor::solve(const Eigen::MatrixXd& right) const {
  PLIANT_ASSERT(positive_, "the matrix is positive");
  Eigen::MatrixXd result(right.rows(), right.cols());
  const auto count = static_cast<int>(elements_.size());
  Eigen::RowVectorXd behind = Eigen::RowVectorXd::Zero(right.cols());  // moment on the end's angle
  for (int e = count - 1; e >= 0; --e) {
    const Element& element = elements_[static_cast<size_t>(e)];
    auto own = result.middleRows<GaussLine::kOrder>(GaussLine::kOrder * e);
    own = right.middleRows<GaussLine::kOrder>(GaussLine::kOrder * e) + weights_ * behind;
    behind += element.response.transpose() * own;
    for (auto column : own.colwise()) {
      column = element.own.solve(GaussLine::Values(column));
    }
  }
  Eigen::RowVectorXd angle = Eigen::RowVectorXd::Zero(right.cols());
  for (int e = 0; e < count; ++e) {
    auto own = result.middleRows<GaussLine::kOrder>(GaussLine::kOrder * e);
    own += elements_[static_cast<size_t>(e)].response * angle;
    angle += weights_.transpose() * own;
  }
  return result;
}

}  // namespace pliant
