#include "pliant/material/solid/principal_density.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "pliant/base/assert.h"
#include "pliant/material/solid/principal_stretches.h"

namespace pliant {
namespace {

SolidVector strain_of(const Samples& samples, int lane) {
  return samples.strain.row(lane).transpose().matrix();
}

/// Whether a point is as the one before it: single points come as eight alike.
bool is_as_before(const Samples& samples, int lane) {
  return lane > 0 && (samples.strain.row(lane) == samples.strain.row(lane - 1)).all() &&
         (samples.weights.row(lane) == samples.weights.row(lane - 1)).all();
}

/// Principal stretches of eight points and their metrics, and the law's answers on them.
class PrincipalPoints {
 public:
  PrincipalPoints(const PrincipalMetric& metric, const Samples& samples)
      : isochoric_(metric.isochoric), weights_(samples.weights) {
    for (int lane = 0; lane < kLanes; ++lane) {
      if (is_as_before(samples, lane)) {
        points_.push_back(points_.back());
        value_.row(lane) = value_.row(lane - 1);
        first_.row(lane) = first_.row(lane - 1);
        second_.row(lane) = second_.row(lane - 1);
        continue;
      }
      const PrincipalStretches& point = points_.emplace_back(strain_of(samples, lane));
      const double volume = isochoric_ ? point.logs().mean() : 0;
      for (int a = 0; a < 3; ++a) {
        const ScalarJet jet = metric.of_log(point.logs()(a) - volume);
        value_(lane, a) = jet.value;
        first_(lane, a) = jet.first;
        second_(lane, a) = jet.second;
      }
    }
  }

  const PrincipalStretches& point(int lane) const {
    return points_[static_cast<std::size_t>(lane)];
  }

  /// What a law of one strain sees of the stretches a.
  Samples samples(int a) const {
    const LaneView strain(value_.col(a).data(), kLanes, 1);
    return {strain, strain, strain, LaneView(value_.data(), kLanes, 0), weights_};
  }

  Eigen::Vector3d by_log(int lane, const Eigen::Vector3d& stress) const {
    return projected(stress.cwiseProduct(first_.row(lane).transpose().matrix()));
  }

  Eigen::Matrix3d second_by_log(int lane, const Eigen::Vector3d& stress,
                                const Eigen::Vector3d& tangent) const {
    const Eigen::Vector3d first = first_.row(lane).transpose().matrix();
    const Eigen::Vector3d second = second_.row(lane).transpose().matrix();
    Eigen::Matrix3d own =
        (tangent.cwiseProduct(first.cwiseAbs2()) + stress.cwiseProduct(second)).asDiagonal();
    if (!isochoric_) return own;
    const Eigen::Matrix3d projection = Eigen::Matrix3d::Identity().array() - 1.0 / 3;
    return projection * own * projection;
  }

 private:
  Eigen::Vector3d projected(const Eigen::Vector3d& by_log) const {
    if (!isochoric_) return by_log;
    return by_log.array() - by_log.mean();
  }

  bool isochoric_;
  LaneView weights_;
  std::vector<PrincipalStretches> points_;
  Eigen::Array<double, kLanes, 3> value_, first_, second_;
};

}  // namespace

PrincipalDensity::PrincipalDensity(const PrincipalMetric& metric,
                                   std::shared_ptr<const ParametricDensity> law)
    : metric_(&metric), law_(std::move(law)) {
  PLIANT_ASSERT(law_->history_size() == 0, "laws of principal stretches remember nothing");
}

void PrincipalDensity::add(const Samples& samples, const StepTime& time, Response& response) const {
  const PrincipalPoints points(*metric_, samples);
  Eigen::Array<double, kLanes, 3> stress, tangent;
  Eigen::Array<double, kLanes, kSolidStrains> own_stress;
  Eigen::Array<double, kLanes, kSolidStrains * kSolidStrains> own_tangent;
  for (int a = 0; a < 3; ++a) {
    Response inner(1);
    law_->add(points.samples(a), time, inner);
    response.stored += inner.stored;
    response.work += inner.work;
    stress.col(a) = inner.stress.col(0);
    tangent.col(a) = inner.tangent.col(0);
  }
  for (int lane = 0; lane < kLanes; ++lane) {
    if (is_as_before(samples, lane)) {
      own_stress.row(lane) = own_stress.row(lane - 1);
      own_tangent.row(lane) = own_tangent.row(lane - 1);
      continue;
    }
    const Eigen::Vector3d y = stress.row(lane).transpose().matrix();
    const Eigen::Vector3d by_log = points.by_log(lane, y);
    const PrincipalStretches& point = points.point(lane);
    const SolidMatrix second = point.tangent(
        by_log, points.second_by_log(lane, y, tangent.row(lane).transpose().matrix()));
    own_stress.row(lane) = point.stress(by_log).transpose().array();
    for (int i = 0; i < kSolidStrains; ++i) {
      for (int j = 0; j < kSolidStrains; ++j) {  // symmetric to the last bit
        own_tangent(lane, kSolidStrains * i + j) = second(std::min(i, j), std::max(i, j));
      }
    }
  }
  response.stress += own_stress;
  response.tangent += own_tangent;
}

void PrincipalDensity::add_stored(const Samples& samples, Lane& stored) const {
  const PrincipalPoints points(*metric_, samples);
  for (int a = 0; a < 3; ++a) law_->add_stored(points.samples(a), stored);
}

std::unique_ptr<ParametricDensity> PrincipalDensity::with_parameters(
    const Eigen::VectorXd& values) const {
  return std::make_unique<PrincipalDensity>(*metric_, law_->with_parameters(values));
}

void PrincipalDensity::differentiate(const Samples& samples, const StepTime& time, int lane, int,
                                     int first_parameter, SampleDerivatives& derivatives) const {
  const PrincipalPoints points(*metric_, samples);
  const auto count = static_cast<int>(parameters().size());
  Eigen::MatrixXd by_parameter(3, count);
  for (int a = 0; a < 3; ++a) {
    SampleDerivatives inner(1, 0, count);
    law_->differentiate(points.samples(a), time, lane, 0, 0, inner);
    by_parameter.row(a) = inner.stress_by_parameter.row(0);
    derivatives.stored_by_parameter.segment(first_parameter, count) += inner.stored_by_parameter;
  }
  for (int p = 0; p < count; ++p) {
    derivatives.stress_by_parameter.col(first_parameter + p) +=
        points.point(lane).stress(points.by_log(lane, by_parameter.col(p)));
  }
}

}  // namespace pliant
