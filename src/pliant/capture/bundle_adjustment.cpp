#include "pliant/capture/bundle_adjustment.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <ceres/ceres.h>

#include "pliant/base/errors.h"
#include "pliant/capture/bundle_problem.h"
#include "pliant/capture/median.h"

namespace pliant {
namespace {

// Below it a corner is known better than pictures can tell, and others would count too little.
constexpr double kLeastNoise = 1e-3;  // pixels

// Ends a search when the user asks to.
class StopWhenAsked : public ceres::IterationCallback {
 public:
  explicit StopWhenAsked(const StopToken& stop) : stop_(stop) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    return stop_.stop_requested() ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
  }

 private:
  const StopToken& stop_;
};

void solve(Bundle& bundle, const BundleOptions& options, double loss) {
  BundleProblem problem(bundle, options, loss);
  ceres::Solver::Options search;
  search.linear_solver_type = ceres::DENSE_SCHUR;
  search.num_threads = 1;  // sums of several threads come in any order
  search.max_num_iterations = 100;
  search.function_tolerance = 1e-10;
  search.logging_type = ceres::SILENT;
  auto ordering = std::make_shared<ceres::ParameterBlockOrdering>();
  for (int p = 0; p < std::ssize(bundle.placements); ++p) {
    if (problem.has(problem.placement(p))) ordering->AddElementToGroup(problem.placement(p), 0);
  }
  std::vector<double*> blocks;
  problem.problem().GetParameterBlocks(&blocks);
  for (double* block : blocks) {
    if (!ordering->IsMember(block)) ordering->AddElementToGroup(block, 1);
  }
  search.linear_solver_ordering = ordering;
  StopWhenAsked stop(options.stop);
  search.callbacks.push_back(&stop);
  ceres::Solver::Summary summary;
  ceres::Solve(search, &problem.problem(), &summary);
  options.stop.throw_if_requested();
  if (!summary.IsSolutionUsable()) {
    throw SolverError("the adjustment of the cameras", static_cast<int>(summary.iterations.size()),
                      std::sqrt(summary.final_cost));
  }
  problem.store();
}

struct CameraErrors {
  std::vector<double> absolute;  // of each coordinate that is used
  double squares = 0;
};

std::vector<CameraErrors> errors_by_camera(const Bundle& bundle) {
  std::vector<CameraErrors> errors(bundle.cameras.size());
  for (const CornerView& view : bundle.views) {
    const Eigen::Matrix2Xd residuals = bundle.residuals(view);
    for (int i = 0; i < std::ssize(view.corners); ++i) {
      if (!view.is_used[i]) continue;
      errors[view.camera].squares += residuals.col(i).squaredNorm();
      for (const double r : residuals.col(i)) errors[view.camera].absolute.push_back(std::abs(r));
    }
  }
  return errors;
}

// By the middle of the errors, which corners that miss do not move.
void estimate_noise_robustly(Bundle& bundle) {
  constexpr double kMedianOfNormal = 0.6745;
  const auto errors = errors_by_camera(bundle);
  for (int c = 0; c < std::ssize(errors); ++c) {
    if (errors[c].absolute.empty()) continue;
    bundle.noise[c] = std::max(kLeastNoise, median(errors[c].absolute) / kMedianOfNormal);
  }
}

// By the mean square, with what the estimated numbers took of it: those of cameras by themselves,
// those of a placement shared by the cameras that see it.
void estimate_noise(Bundle& bundle, const BundleOptions& options) {
  const auto errors = errors_by_camera(bundle);
  std::vector<double> rows_of(bundle.placements.size(), 0);
  for (const CornerView& view : bundle.views) rows_of[view.placement] += 2 * view.used();
  std::vector<double> taken(bundle.cameras.size(), 0);
  for (const CornerView& view : bundle.views) {
    if (view.used() > 0) taken[view.camera] += 6 * 2 * view.used() / rows_of[view.placement];
  }
  for (int c = 0; c < std::ssize(errors); ++c) {
    if (!options.fix_cameras) {
      taken[c] += static_cast<double>(std::ranges::count(bundle.free[c], true) + (c > 0 ? 6 : 0));
    }
    const double left = static_cast<double>(errors[c].absolute.size()) - taken[c];
    if (left < 1) continue;
    bundle.noise[c] = std::max(kLeastNoise, std::sqrt(errors[c].squares / left));
  }
}

// @return whether any changed
bool choose_used(Bundle& bundle, double outlier) {
  bool changed = false;
  for (CornerView& view : bundle.views) {
    const Eigen::Matrix2Xd residuals = bundle.residuals(view);
    for (int i = 0; i < std::ssize(view.corners); ++i) {
      const bool use = residuals.col(i).norm() <= outlier * bundle.noise[view.camera];
      changed = changed || use != view.is_used[i];
      view.is_used[i] = use;
    }
  }
  return changed;
}

}  // namespace

int CornerView::used() const { return static_cast<int>(std::ranges::count(is_used, true)); }

Eigen::Vector3d Bundle::corner(const BoardPlacement& placement, int number) const {
  Eigen::Vector3d point = boards[placement.board].col(number);
  point.z() += warps[placement.board].dot(bend_weights(boards[placement.board], number));
  return placement.pose * point;
}

Eigen::Matrix2Xd Bundle::residuals(const CornerView& view) const {
  const BoardPlacement& placement = placements[view.placement];
  const CameraModel& camera = cameras[view.camera];
  Eigen::Matrix2Xd result(2, std::ssize(view.corners));
  for (int i = 0; i < std::ssize(view.corners); ++i) {
    const Eigen::Vector3d local = camera.pose * corner(placement, view.corners[i]);
    result.col(i) = view.pixels.col(i) - pixel_of(camera.intrinsics.data(), local);
  }
  return result;
}

void adjust(Bundle& bundle, const BundleOptions& options) {
  constexpr double kHuber = 2;
  constexpr int kRounds = 6;
  for (int round = 0; round < kRounds; ++round) {
    solve(bundle, options, kHuber);
    estimate_noise_robustly(bundle);
    // Of the first result the noise tells little: a start may have been far off.
    if (round > 0 && !choose_used(bundle, options.outlier)) break;
  }
  solve(bundle, options, 0);
  estimate_noise(bundle, options);
}

void readjust(Bundle& bundle, const BundleOptions& options) { solve(bundle, options, 0); }

}  // namespace pliant
