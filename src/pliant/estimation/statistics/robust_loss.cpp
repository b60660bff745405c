#include "pliant/estimation/statistics/robust_loss.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pliant {

double loss_scale(RobustLoss loss) {
  if (loss == RobustLoss::huber) return 1.345;
  if (loss == RobustLoss::cauchy) return 2.385;
  return std::numeric_limits<double>::infinity();
}

double rho(RobustLoss loss, double squared) {
  const double scale = loss_scale(loss), scale2 = scale * scale;
  if (loss == RobustLoss::cauchy) return scale2 * std::log1p(squared / scale2);
  if (loss == RobustLoss::none || squared <= scale2) return squared;
  return 2 * scale * std::sqrt(squared) - scale2;
}

double robust_weight(RobustLoss loss, double squared) {
  const double scale = loss_scale(loss), scale2 = scale * scale;
  if (loss == RobustLoss::cauchy) return 1 / (1 + squared / scale2);
  if (loss == RobustLoss::none || squared <= scale2) return 1;
  return scale / std::sqrt(squared);
}

double robust_sd(const Eigen::VectorXd& residual) {
  constexpr double kPerMedian = 1.4826;
  if (residual.size() == 0) return 0;
  std::vector<double> sizes(residual.begin(), residual.end());
  for (double& size : sizes) size = std::abs(size);
  const auto middle = sizes.begin() + std::ssize(sizes) / 2;
  std::ranges::nth_element(sizes, middle);
  return kPerMedian * *middle;
}

Eigen::VectorXd tamed(const Eigen::VectorXd& residual) {
  const double most = 3 * robust_sd(residual);
  return most > 0 ? Eigen::VectorXd(residual.cwiseMax(-most).cwiseMin(most)) : residual;
}

std::string_view name_of(RobustLoss loss) {
  switch (loss) {
    case RobustLoss::none:
      return "none";
    case RobustLoss::huber:
      return "huber";
    case RobustLoss::cauchy:
      return "cauchy";
  }
  return "";
}

std::optional<RobustLoss> robust_loss_named(std::string_view name) {
  for (const RobustLoss loss : {RobustLoss::none, RobustLoss::huber, RobustLoss::cauchy}) {
    if (name == name_of(loss)) return loss;
  }
  return std::nullopt;
}

}  // namespace pliant
