#include <map>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <ceres/ceres.h>

#include "pliant/base/assert.h"
#include "pliant/capture/bundle_adjustment.h"
#include "pliant/capture/bundle_problem.h"

namespace pliant {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Columns6 = Eigen::Matrix<double, Eigen::Dynamic, 6>;

// Scaled to a diagonal of ones, a direction with less than this is not told by the pictures.
constexpr double kUndetermined = 1e-13;

// Normal equations of what all pictures share (cameras and warps), and of each placement.
struct NormalEquations {
  Eigen::MatrixXd shared;
  std::vector<Matrix6> own;
  std::vector<Columns6> mixed;
  std::vector<int> full;  // number of each shared column among the cameras' and warps' numbers
};

class SharedColumns {
 public:
  SharedColumns(BundleProblem& problem, const Bundle& bundle) {
    const int cameras = static_cast<int>(bundle.cameras.size());
    for (int c = 0; c < cameras; ++c) {
      add(problem, problem.intrinsics(c), kCameraNumbers * c, kIntrinsics,
          [&](int k) { return bundle.free[c][k]; });
      add(problem, problem.camera_pose(c), kCameraNumbers * c + kIntrinsics, 6,
          [](int) { return true; });
    }
    for (int b = 0; b < std::ssize(bundle.boards); ++b) {
      add(problem, problem.warp(b), kCameraNumbers * cameras + 3 * b, 3, [](int) { return true; });
    }
  }

  std::vector<double*> blocks;
  std::vector<int> full;

 private:
  template <class IsFree>
  void add(BundleProblem& problem, double* block, int first, int size, const IsFree& is_free) {
    if (!problem.has(block) || problem.problem().IsParameterBlockConstant(block)) return;
    blocks.push_back(block);
    for (int k = 0; k < size; ++k) {
      if (is_free(k)) full.push_back(first + k);
    }
  }
};

NormalEquations normal_equations(BundleProblem& problem, const Bundle& bundle) {
  SharedColumns shared(problem, bundle);
  ceres::Problem::EvaluateOptions options;
  options.parameter_blocks = shared.blocks;
  std::vector<int> placements;
  for (int p = 0; p < std::ssize(bundle.placements); ++p) {
    if (!problem.has(problem.placement(p))) continue;
    options.parameter_blocks.push_back(problem.placement(p));
    placements.push_back(p);
  }
  ceres::CRSMatrix jacobian;
  const bool done = problem.problem().Evaluate(options, nullptr, nullptr, nullptr, &jacobian);
  PLIANT_ASSERT(done, "a result can be evaluated");
  const int count = static_cast<int>(shared.full.size());
  NormalEquations equations{Eigen::MatrixXd::Zero(count, count), {}, {}, shared.full};
  equations.own.assign(bundle.placements.size(), Matrix6::Zero());
  equations.mixed.assign(bundle.placements.size(), Columns6::Zero(count, 6));
  for (int row = 0; row < jacobian.num_rows; ++row) {
    for (int i = jacobian.rows[row]; i < jacobian.rows[row + 1]; ++i) {
      for (int k = jacobian.rows[row]; k < jacobian.rows[row + 1]; ++k) {
        const int a = jacobian.cols[i], b = jacobian.cols[k];
        const double value = jacobian.values[i] * jacobian.values[k];
        if (b < count) {
          if (a < count) equations.shared(a, b) += value;
          continue;
        }
        const int placement = placements[(b - count) / 6], column = (b - count) % 6;
        if (a < count) {
          equations.mixed[placement](a, column) += value;
        } else {
          equations.own[placement]((a - count) % 6, column) += value;
        }
      }
    }
  }
  return equations;
}

// Inverse of a matrix whose numbers have different units; nothing where it has none.
std::optional<Eigen::MatrixXd> scaled_inverse(const Eigen::MatrixXd& matrix) {
  if (matrix.size() == 0) return matrix;
  const Eigen::VectorXd diagonal = matrix.diagonal();
  if (!(diagonal.minCoeff() > 0)) return std::nullopt;
  const Eigen::VectorXd scale = diagonal.cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd unit = scale.asDiagonal() * matrix * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(unit);
  if (!(eigen.eigenvalues()(0) > kUndetermined)) return std::nullopt;
  const Eigen::MatrixXd inverse = eigen.eigenvectors() *
                                  eigen.eigenvalues().cwiseInverse().asDiagonal() *
                                  eigen.eigenvectors().transpose();
  return scale.asDiagonal() * inverse * scale.asDiagonal();
}

}  // namespace

BundleCovariance covariance_of(Bundle& bundle, const BundleOptions& options) {
  BundleProblem problem(bundle, options, 0);
  const NormalEquations equations = normal_equations(problem, bundle);
  const int cameras = static_cast<int>(bundle.cameras.size()) * kCameraNumbers;
  BundleCovariance result;
  result.cameras = Eigen::MatrixXd::Zero(cameras, cameras);
  result.placements.assign(bundle.placements.size(), Matrix6::Zero());
  result.warps.assign(bundle.boards.size(), Eigen::Matrix3d::Zero());

  std::vector<Matrix6> own_inverses;
  Eigen::MatrixXd reduced = equations.shared;
  for (int p = 0; p < std::ssize(equations.own); ++p) {
    const auto inverse = scaled_inverse(equations.own[p]);
    own_inverses.push_back(inverse ? Matrix6(*inverse) : Matrix6::Zero());
    reduced -= equations.mixed[p] * own_inverses[p] * equations.mixed[p].transpose();
  }
  const auto shared = scaled_inverse(reduced);
  if (!shared) {
    result.is_determined = false;
    return result;
  }
  const auto at = [&](int a, int b) { return (*shared)(a, b); };
  for (int a = 0; a < std::ssize(equations.full); ++a) {
    for (int b = 0; b < std::ssize(equations.full); ++b) {
      const int i = equations.full[a], k = equations.full[b];
      if (i < cameras && k < cameras) result.cameras(i, k) = at(a, b);
      if (i >= cameras && k >= cameras && (i - cameras) / 3 == (k - cameras) / 3) {
        result.warps[(i - cameras) / 3]((i - cameras) % 3, (k - cameras) % 3) = at(a, b);
      }
    }
  }
  for (int p = 0; p < std::ssize(equations.own); ++p) {
    const Columns6 carried = equations.mixed[p] * own_inverses[p];
    result.placements[p] = own_inverses[p] + carried.transpose() * *shared * carried;
  }
  return result;
}

}  // namespace pliant
