#include "pliant/solver/elastica/gauss_line.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

constexpr int kOrder = GaussLine::kOrder;

using Values = GaussLine::Values;
using Weights = Eigen::Matrix<double, 1, kOrder>;

// Legendre polynomials P_0 .. P_kOrder at x.
Eigen::Matrix<double, 1, kOrder + 1> legendre(double x) {
  Eigen::Matrix<double, 1, kOrder + 1> p;
  p(0) = 1;
  p(1) = x;
  for (int n = 1; n < kOrder; ++n) p(n + 1) = ((2 * n + 1) * x * p(n) - n * p(n - 1)) / (n + 1);
  return p;
}

// Their integrals from -1 to x, but for the last: (P_(n+1) - P_(n-1)) / (2 n + 1).
Weights legendre_integrals(double x) {
  const auto p = legendre(x);
  Weights result;
  result(0) = x + 1;
  for (int n = 1; n < kOrder; ++n) result(n) = (p(n + 1) - p(n - 1)) / (2 * n + 1);
  return result;
}

// The Gauss rule on -1 .. 1, and the Legendre coefficients of a polynomial by its values there.
struct Rule {
  Values points, weights;
  Eigen::Matrix<double, kOrder, kOrder> coefficients;

  Rule() {
    // Golub and Welsch 1969: eigenvalues of the three-term recurrence.
    Eigen::Matrix<double, kOrder, kOrder> recurrence;
    recurrence.setZero();
    for (int n = 1; n < kOrder; ++n) {
      recurrence(n, n - 1) = recurrence(n - 1, n) = n / std::sqrt(4.0 * n * n - 1);
    }
    const Eigen::SelfAdjointEigenSolver<decltype(recurrence)> eigen(recurrence);
    points = eigen.eigenvalues();
    weights = 2 * eigen.eigenvectors().row(0).transpose().cwiseAbs2();
    Eigen::Matrix<double, kOrder, kOrder> values;
    for (int i = 0; i < kOrder; ++i) values.row(i) = legendre(points(i)).head<kOrder>();
    coefficients = values.inverse();
  }
};

const Rule& rule() {
  static const Rule the_rule;
  return the_rule;
}

}  // namespace

GaussLine::GaussLine(double length, int elements)
    : length_(length),
      elements_(elements),
      places_(kOrder * elements),
      weights_(kOrder * elements) {
  PLIANT_ASSERT(length > 0 && elements > 0, "a line of some length");
  const double half = length / elements / 2;
  for (int e = 0; e < elements; ++e) {
    places_.segment<kOrder>(kOrder * e) = half * (rule().points.array() + 1 + 2 * e);
    weights_.segment<kOrder>(kOrder * e) = half * rule().weights;
  }
  for (int i = 0; i < kOrder; ++i) {
    element_integration_.row(i) = half * legendre_integrals(rule().points(i)) * rule().coefficients;
  }
}

int GaussLine::element_at(double place) const {
  return std::clamp(static_cast<int>(place / length_ * elements_), 0, elements_ - 1);
}

double GaussLine::local(int element, double place) const {
  return 2 * (place / length_ * elements_ - element) - 1;
}

Eigen::MatrixXd GaussLine::integrals(const Eigen::MatrixXd& values) const {
  Eigen::MatrixXd result(values.rows(), values.cols());
  Eigen::RowVectorXd before = Eigen::RowVectorXd::Zero(values.cols());
  for (int e = 0; e < elements_; ++e) {
    const auto here = values.middleRows<kOrder>(kOrder * e);
    result.middleRows<kOrder>(kOrder * e) = element_integration_ * here;
    result.middleRows<kOrder>(kOrder * e).rowwise() += before;
    before += element_weights().transpose() * here;
  }
  return result;
}

Eigen::VectorXd GaussLine::transposed_integrals(const Eigen::VectorXd& values) const {
  Eigen::VectorXd result(values.size());
  double beyond = 0;
  for (int e = elements_ - 1; e >= 0; --e) {
    const auto here = values.segment<kOrder>(kOrder * e);
    result.segment<kOrder>(kOrder * e) =
        element_integration_.transpose() * here + beyond * element_weights();
    beyond += here.sum();
  }
  return result;
}

// Beyond its element, an integral grows no more with a point's value: column i of the integration
// is there weight i. Entry (i, j) for j in a later element than i is therefore weight i times what
// column j gives with ones.
Eigen::MatrixXd GaussLine::integration_gram(const Eigen::VectorXd& factors) const {
  Eigen::MatrixXd gram(size(), size());
  double beyond = 0;  // sum of the factors behind the element
  for (int e = elements_ - 1; e >= 0; --e) {
    const int first = kOrder * e;
    const Values factor = factors.segment<kOrder>(first), weight = element_weights();
    const Block turned = element_integration_.transpose() * factor.asDiagonal();
    gram.block<kOrder, kOrder>(first, first) =
        turned * element_integration_ + beyond * weight * weight.transpose();
    const Values with_ones = turned.rowwise().sum() + beyond * weight;
    gram.block(0, first, first, kOrder) = weights_.head(first) * with_ones.transpose();
    gram.block(first, 0, kOrder, first) = gram.block(0, first, first, kOrder).transpose();
    beyond += factor.sum();
  }
  return gram;
}

GaussLine::Local GaussLine::at(double place) const {
  const int element = element_at(place);
  const double x = local(element, place);
  return {kOrder * element, length_ / elements_ / 2 * legendre_integrals(x) * rule().coefficients,
          legendre(x).head<kOrder>() * rule().coefficients};
}

Eigen::RowVectorXd GaussLine::integral_weights(double place) const {
  const Local here = at(place);
  Eigen::RowVectorXd result = Eigen::RowVectorXd::Zero(size());
  result.head(here.first) = weights_.head(here.first).transpose();
  result.segment<kOrder>(here.first) = here.integral;
  return result;
}

Eigen::RowVectorXd GaussLine::value_weights(double place) const {
  const Local here = at(place);
  Eigen::RowVectorXd result = Eigen::RowVectorXd::Zero(size());
  result.segment<kOrder>(here.first) = here.value;
  return result;
}

}  // namespace pliant
