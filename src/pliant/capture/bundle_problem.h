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
  double* intrinsics(int camera) { return &numbers_[kIntrinsics * camera]; }
  double* camera_pose(int camera) { return &numbers_[kIntrinsics * cameras() + 6 * camera]; }
  double* warp(int board) { return &numbers_[kCameraNumbers * cameras() + 3 * board]; }
  double* placement(int number) {
    return &numbers_[kCameraNumbers * cameras() + 3 * bundle_.boards.size() + 6 * number];
  }
  bool has(const double* block) const;

 private:
  std::size_t cameras() const { return bundle_.cameras.size(); }
  void add_views(double loss);
  void fix(const BundleOptions& options);

  Bundle& bundle_;
  // Of cameras, boards and placements in turn: Ceres orders blocks by where they lie, and results
  // would differ in their last digits.
  std::vector<double> numbers_;
  std::unique_ptr<ceres::Problem> problem_;
};

}  // namespace pliant
