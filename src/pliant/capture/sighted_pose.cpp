#include "pliant/capture/sighted_pose.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "pliant/capture/median.h"
#include "pliant/math/cross_matrix.h"

namespace pliant {
namespace {

/// A turn about the middle of the points, and a shift.
using Step = Eigen::Vector<double, 6>;

/// By how much sightings miss (pixels); infinite where a camera would not see the point.
std::vector<double> misses_of(const std::vector<BodySighting>& sightings, const Pose& pose) {
  std::vector<double> misses;
  for (const BodySighting& seen : sightings) {
    const auto shown = seen.camera->project(pose.apply(seen.point));
    misses.push_back(shown ? (seen.pixel - *shown).norm() : INFINITY);
  }
  return misses;
}

Step step_of(const std::vector<BodySighting>& sightings, const std::vector<double>& weights,
             const Pose& pose, const Eigen::Vector3d& middle) {
  Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
  Step right = Step::Zero();
  for (std::size_t i = 0; i < sightings.size(); ++i) {
    const BodySighting& seen = sightings[i];
    const Eigen::Vector3d place = pose.apply(seen.point);
    const auto shown = seen.camera->project_with_derivatives(place);
    if (!shown) continue;
    Eigen::Matrix<double, 2, 6> by_step;
    by_step.leftCols<3>() = -shown->by_point * cross_matrix(place - middle);
    by_step.rightCols<3>() = shown->by_point;
    normal += weights[i] * by_step.transpose() * by_step;
    right += weights[i] * by_step.transpose() * (seen.pixel - shown->pixel);
  }
  return normal.ldlt().solve(right);
}

/// [Huber1981]
std::vector<double> mild_weights(const std::vector<double>& misses, double limit) {
  std::vector<double> weights;
  for (const double miss : misses) weights.push_back(miss > limit ? limit / miss : 1);
  return weights;
}

/// Those of the biweight, which leaves out what is far off.
std::vector<double> strict_weights(const std::vector<double>& misses, double limit) {
  std::vector<double> weights;
  for (const double miss : misses) {
    const double share = miss / limit;
    weights.push_back(share < 1 ? (1 - share * share) * (1 - share * share) : 0);
  }
  return weights;
}

}  // namespace

Pose sighted_pose(const std::vector<BodySighting>& sightings, const Pose& start, double noise) {
  constexpr int kRounds = 60, kMild = 30;
  constexpr double kLimit = 2, kStrict = 5;  // noises; noises and medians of the misses
  constexpr double kSmall = 1e-9;            // rad, m
  Pose pose = start;
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<double> misses = misses_of(sightings, pose);
    const std::vector<double> weights =
        round < kMild ? mild_weights(misses, kLimit * noise)
                      : strict_weights(misses, kStrict * std::max(noise, median(misses)));
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const BodySighting& seen : sightings) middle += pose.apply(seen.point);
    middle /= static_cast<double>(sightings.size());
    const Step step = step_of(sightings, weights, pose, middle);
    if (!step.allFinite()) break;
    const Eigen::Vector3d turn = step.head<3>();
    const Eigen::Quaterniond by(Eigen::AngleAxisd(turn.norm(), turn.stableNormalized()));
    pose.rotation = (by * pose.rotation).normalized();
    pose.translation = by * (pose.translation - middle) + middle + step.tail<3>();
    if (round > kMild && step.norm() < kSmall) break;
  }
  return pose;
}

}  // namespace pliant
