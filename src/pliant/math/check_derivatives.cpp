#include "pliant/math/check_derivatives.h"

#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

constexpr double kFirstStep = 0.1;  // of an argument's scale
constexpr double kContraction = 2;
constexpr int kSteps = 8;

Eigen::VectorXd central_difference(const VectorFunction& function, Eigen::VectorXd at,
                                   Eigen::Index argument, double step) {
  const double middle = at(argument);
  at(argument) = middle + step;
  const Eigen::VectorXd above = function(at);
  at(argument) = middle - step;
  return (above - function(at)) / (2 * step);
}

// Neville's table of differences for smaller and smaller steps; each value keeps the entry whose
// neighbours agree best with it.
Eigen::VectorXd ridders_derivative(const VectorFunction& function, const Eigen::VectorXd& at,
                                   Eigen::Index argument, double first_step) {
  std::array<Eigen::VectorXd, kSteps> row;  // the newest row of the table
  std::array<Eigen::VectorXd, kSteps> previous;
  Eigen::VectorXd best, best_error;
  double step = first_step;
  for (int i = 0; i < kSteps; ++i, step /= kContraction) {
    row[0] = central_difference(function, at, argument, step);
    if (i == 0) {
      best = row[0];
      best_error = Eigen::VectorXd::Constant(best.size(), std::numeric_limits<double>::infinity());
    }
    double weight = 1;
    for (int k = 1; k <= i; ++k) {
      weight *= kContraction * kContraction;
      row[k] = (weight * row[k - 1] - previous[k - 1]) / (weight - 1);
      const Eigen::VectorXd error =
          (row[k] - row[k - 1]).cwiseAbs().cwiseMax((row[k] - previous[k - 1]).cwiseAbs());
      best = (error.array() <= best_error.array()).select(row[k], best);
      best_error = best_error.cwiseMin(error);
    }
    std::swap(row, previous);
  }
  return best;
}

}  // namespace

std::string DerivativeCheck::describe() const {
  return fmt::format(
      "d value[{}] / d argument[{}] is {:.10g}, differences say {:.10g} (error {:.2g})", value,
      argument, stated, estimated, error);
}

Eigen::MatrixXd estimate_jacobian(const VectorFunction& function, const Eigen::VectorXd& at,
                                  const Eigen::VectorXd& scale) {
  PLIANT_ASSERT(scale.size() == at.size() && (scale.array() > 0).all(),
                "each argument has a positive scale");
  Eigen::MatrixXd jacobian(function(at).size(), at.size());
  for (Eigen::Index i = 0; i < at.size(); ++i) {
    jacobian.col(i) = ridders_derivative(function, at, i, kFirstStep * scale(i));
  }
  return jacobian;
}

DerivativeCheck check_derivatives(const VectorFunction& function, const Eigen::MatrixXd& stated,
                                  const Eigen::VectorXd& at, const Eigen::VectorXd& scale) {
  const Eigen::MatrixXd estimated = estimate_jacobian(function, at, scale);
  PLIANT_ASSERT(stated.rows() == estimated.rows() && stated.cols() == estimated.cols(),
                "the stated Jacobian has a row for each value and a column for each argument");
  DerivativeCheck worst;
  for (Eigen::Index i = 0; i < stated.rows(); ++i) {
    const double change = estimated.row(i).cwiseAbs().dot(scale);
    for (Eigen::Index k = 0; k < stated.cols(); ++k) {
      const double difference = std::abs(stated(i, k) - estimated(i, k)) * scale(k);
      double error = change > 0 ? difference / change : difference;
      if (std::isnan(error)) error = std::numeric_limits<double>::infinity();
      if (error <= worst.error) continue;
      worst = {error, i, k, stated(i, k), estimated(i, k)};
    }
  }
  return worst;
}

}  // namespace pliant
