#include "pliant/material/density/limited_density.h"

#include <cmath>
#include <limits>
#include <utility>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

/// Near enough to the limit, where multipliers are as large as 1 over it, every barrier is a
/// parabola: no step is lost in a curvature without bounds.
constexpr double kMended = 5e-3;  // of m
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The barrier of an energy, and its derivatives by that energy.
struct Barrier {
  double value = 0;
  double multiplier = 0;
  double slope = 0;  ///< of the multiplier

  /// @param left  share of the limit
  Barrier(double left, double largest, const LimitBarrier& limits) {
    const double m = limits.share;
    const bool beyond = limits.mended > 0;  // finite there
    const double mended = beyond ? limits.mended : kMended * m;
    if (left > mended) {
      value = -m * largest * std::log(left);
      multiplier = m / left;
      slope = m / (largest * left * left);
    } else if (beyond || left > 0) {
      const double way = (left - mended) / mended;
      value = m * largest * (-std::log(mended) - way + way * way / 2);
      multiplier = m / mended * (1 - way);
      slope = m / (largest * mended * mended);
    } else {
      value = kInfinity;
    }
  }
};

}  // namespace

LimitedDensity::LimitedDensity(std::shared_ptr<const ParametricDensity> law, double largest)
    : law_(std::move(law)), largest_(largest) {
  PLIANT_ASSERT(law_->history_size() == 0, "what remembers has no limit");
}

void LimitedDensity::add(const Samples& samples, const StepTime& time, Response& response) const {
  const Eigen::Index strains = samples.strain.cols();
  Response own(static_cast<int>(strains));
  law_->add(samples, time, own);
  Lane more, slope;  // factor of the stress, and its derivative by the energy
  for (int lane = 0; lane < kLanes; ++lane) {
    const Barrier barrier(1 - own.stored(lane) / largest_, largest_, time.limits);
    response.stored(lane) += own.stored(lane) + barrier.value;
    more(lane) = 1 + barrier.multiplier;
    slope(lane) = barrier.slope;
  }
  response.stress += own.stress.colwise() * more;
  for (Eigen::Index i = 0; i < strains; ++i) {
    for (Eigen::Index j = 0; j < strains; ++j) {
      response.tangent.col(strains * i + j) +=
          more * own.tangent.col(strains * i + j) + slope * (own.stress.col(i) * own.stress.col(j));
    }
  }
}

void LimitedDensity::lower_to_share_left(const Samples& samples, Lane& left) const {
  Lane stored = Lane::Zero();
  law_->add_stored(samples, stored);
  left = left.min(1 - stored / largest_);
}

Eigen::VectorXd LimitedDensity::parameters() const {
  const Eigen::VectorXd own = law_->parameters();
  Eigen::VectorXd all(own.size() + 1);
  all << own, largest_;
  return all;
}

std::unique_ptr<ParametricDensity> LimitedDensity::with_parameters(
    const Eigen::VectorXd& values) const {
  const Eigen::Index own = values.size() - 1;
  return std::make_unique<LimitedDensity>(law_->with_parameters(values.head(own)), values(own));
}

void LimitedDensity::differentiate(const Samples& samples, const StepTime& time, int lane, int,
                                   int first_parameter, SampleDerivatives& derivatives) const {
  const auto strains = static_cast<int>(samples.strain.cols());
  const Eigen::Index count = law_->parameters().size(), last = first_parameter + count;
  SampleDerivatives own(strains, 0, static_cast<int>(count));
  law_->differentiate(samples, time, lane, 0, 0, own);
  Response at(strains);
  law_->add(samples, {}, at);
  const double energy = at.stored(lane);
  const Eigen::VectorXd stress = at.stress.row(lane).transpose().matrix();
  const Barrier barrier(1 - energy / largest_, largest_, {});
  derivatives.stored_by_parameter.segment(first_parameter, count) +=
      (1 + barrier.multiplier) * own.stored_by_parameter;
  derivatives.stress_by_parameter.middleCols(first_parameter, count) +=
      (1 + barrier.multiplier) * own.stress_by_parameter +
      barrier.slope * stress * own.stored_by_parameter.transpose();
  // A barrier is psi_max times a function of psi / psi_max.
  derivatives.stored_by_parameter(last) += (barrier.value - barrier.multiplier * energy) / largest_;
  derivatives.stress_by_parameter.col(last) -= barrier.slope * energy / largest_ * stress;
}

}  // namespace pliant
