#include "pliant/capture/bundle_problem.h"

#include <ceres/ceres.h>

namespace pliant {
namespace {

// One corner in one picture: predicted less seen, in errors.
struct CornerError {
  Eigen::Vector2d pixel;
  Eigen::Vector3d corner;        // of the flat board
  Eigen::Vector3d bend_weights;  // of BoardWarp
  double noise;

  template <class T>
  bool operator()(const T* intrinsics, const T* camera, const T* placement, const T* warp,
                  T* error) const {
    Eigen::Vector<T, 3> point = corner.cast<T>();
    point.z() += warp[0] * bend_weights(0) + warp[1] * bend_weights(1) + warp[2] * bend_weights(2);
    const Eigen::Vector<T, 3> in_rig =
        turned(placement, point) + Eigen::Map<const Eigen::Vector<T, 3>>(placement + 3);
    const Eigen::Vector<T, 3> local =
        turned(camera, in_rig) + Eigen::Map<const Eigen::Vector<T, 3>>(camera + 3);
    if (!(local.z() > T(0))) return false;
    const Eigen::Vector<T, 2> seen = pixel_of(intrinsics, local);
    error[0] = (seen.x() - pixel.x()) / noise;
    error[1] = (seen.y() - pixel.y()) / noise;
    return true;
  }
};

void write_motion(const RigidMotion& motion, double* numbers) {
  Eigen::Map<Eigen::Vector<double, 6>>(numbers) << motion.rotation, motion.translation;
}

RigidMotion read_motion(const double* numbers) {
  return {Eigen::Map<const Eigen::Vector3d>(numbers),
          Eigen::Map<const Eigen::Vector3d>(numbers + 3)};
}

}  // namespace

Eigen::Vector3d bend_weights(const Eigen::Matrix3Xd& board, int corner) {
  const Eigen::Vector3d least = board.rowwise().minCoeff(), most = board.rowwise().maxCoeff();
  const Eigen::Vector2d half = ((most - least) / 2).head<2>().cwiseMax(1e-9);
  const Eigen::Vector2d place =
      (board.col(corner) - (least + most) / 2).head<2>().cwiseQuotient(half);
  return {place.x() * place.x(), place.x() * place.y(), place.y() * place.y()};
}

BundleProblem::BundleProblem(Bundle& bundle, const BundleOptions& options, double loss)
    : bundle_(bundle), problem_(std::make_unique<ceres::Problem>()) {
  numbers_.resize(kCameraNumbers * cameras() + 3 * bundle.boards.size() +
                  6 * bundle.placements.size());
  for (int c = 0; c < std::ssize(bundle.cameras); ++c) {
    Eigen::Map<Intrinsics>(intrinsics(c)) = bundle.cameras[c].intrinsics;
    write_motion(bundle.cameras[c].pose, camera_pose(c));
  }
  for (int b = 0; b < std::ssize(bundle.warps); ++b) {
    Eigen::Map<BoardWarp>(warp(b)) = bundle.warps[b];
  }
  for (int p = 0; p < std::ssize(bundle.placements); ++p) {
    write_motion(bundle.placements[p].pose, placement(p));
  }
  add_views(loss);
  fix(options);
}

BundleProblem::~BundleProblem() = default;

void BundleProblem::add_views(double loss) {
  for (const CornerView& view : bundle_.views) {
    const int board = bundle_.placements[view.placement].board;
    for (int i = 0; i < std::ssize(view.corners); ++i) {
      if (!view.is_used[i]) continue;
      const Eigen::Matrix3Xd& corners = bundle_.boards[board];
      auto* error =
          new CornerError{view.pixels.col(i), corners.col(view.corners[i]),
                          bend_weights(corners, view.corners[i]), bundle_.noise[view.camera]};
      using Cost = ceres::AutoDiffCostFunction<CornerError, 2, kIntrinsics, 6, 6, 3>;
      problem_->AddResidualBlock(new Cost(error), loss > 0 ? new ceres::HuberLoss(loss) : nullptr,
                                 intrinsics(view.camera), camera_pose(view.camera),
                                 placement(view.placement), warp(board));
    }
  }
}

void BundleProblem::fix(const BundleOptions& options) {
  for (int c = 0; c < std::ssize(bundle_.cameras); ++c) {
    if (!has(intrinsics(c))) continue;
    std::vector<int> kept;
    for (int k = 0; k < kIntrinsics; ++k) {
      if (!bundle_.free[c][k]) kept.push_back(k);
    }
    if (options.fix_cameras || std::ssize(kept) == kIntrinsics) {
      problem_->SetParameterBlockConstant(intrinsics(c));
    } else if (!kept.empty()) {
      problem_->SetManifold(intrinsics(c), new ceres::SubsetManifold(kIntrinsics, kept));
    }
    if (c == 0 || options.fix_cameras) problem_->SetParameterBlockConstant(camera_pose(c));
  }
  for (int b = 0; b < std::ssize(bundle_.boards); ++b) {
    if (has(warp(b)) && (!options.warp || options.fix_cameras)) {
      problem_->SetParameterBlockConstant(warp(b));
    }
  }
}

bool BundleProblem::has(const double* block) const {
  return problem_->HasParameterBlock(const_cast<double*>(block));
}

void BundleProblem::store() {
  for (int c = 0; c < std::ssize(bundle_.cameras); ++c) {
    bundle_.cameras[c].intrinsics = Eigen::Map<Intrinsics>(intrinsics(c));
    bundle_.cameras[c].pose = read_motion(camera_pose(c));
  }
  for (int b = 0; b < std::ssize(bundle_.warps); ++b) {
    bundle_.warps[b] = Eigen::Map<BoardWarp>(warp(b));
  }
  for (int p = 0; p < std::ssize(bundle_.placements); ++p) {
    bundle_.placements[p].pose = read_motion(placement(p));
  }
}

}  // namespace pliant
