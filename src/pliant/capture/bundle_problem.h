#pragma once

#include <memory>
#include <vector>

#include "pliant/capture/bundle_adjustment.h"

namespace ceres {
class Problem;
}

namespace pliant {

/// By what each number of a BoardWarp moves a corner out of the plane.
/// @param board  its corners
Eigen::Vector3d bend_weights(const Eigen::Matrix3Xd& board, int corner);

/// A bundle as Ceres takes it. Results are in the bundle after `store`.
class BundleProblem {
 public:
  /// @param loss  errors beyond which Huber's loss takes over; 0: none
  BundleProblem(Bundle& bundle, const BundleOptions& options, double loss);
  ~BundleProblem();
  BundleProblem(const BundleProblem&) = delete;
  BundleProblem& operator=(const BundleProblem&) = delete;

  ceres::Problem& problem() { return *problem_; }
  void store();

  // Blocks of numbers, as Ceres knows them.
  double* intrinsics(int camera) { return bundle_.cameras[camera].intrinsics.data(); }
  double* camera_pose(int camera) { return camera_poses_[camera].data(); }
  double* placement(int number) { return placements_[number].data(); }
  double* warp(int board) { return bundle_.warps[board].data(); }
  bool has(const double* block) const;

 private:
  using Pose = Eigen::Vector<double, 6>;

  void add_views(double loss);
  void fix(const BundleOptions& options);

  Bundle& bundle_;
  std::vector<Pose> camera_poses_, placements_;
  std::unique_ptr<ceres::Problem> problem_;
};

}  // namespace pliant
