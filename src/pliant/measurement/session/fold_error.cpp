#include "pliant/measurement/session/fold_error.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/QR>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

/// Standard deviation of a window over the longer side; and how far windows are apart, and their
/// middles from the sheet's rim.
constexpr double kWindow = 1.0 / 8;
constexpr int kWindowsAlong = 7;

using Basis = Eigen::Matrix<double, 1, 6>;

Basis quadratics(double u, double v) { return {1, u, v, u * u, u * v, v * v}; }
Basis quadratics_by_u(double u, double v) { return {0, 1, 0, 2 * u, v, 0}; }
Basis quadratics_by_v(double u, double v) { return {0, 0, 1, 0, u, 2 * v}; }

/// Mean square height and slope of the folds in each window of a shape.
struct LocalSquares {
  Eigen::VectorXd height, slope;
};

/// The windows of a rest mesh, which are the same for all shapes.
class Windows {
 public:
  explicit Windows(const TriangleMesh& rest) : rest_(rest) {
    const Eigen::Matrix2Xd plane = rest.positions.topRows<2>();
    low_ = plane.rowwise().minCoeff();
    extent_ = plane.rowwise().maxCoeff() - low_;
    fill_basis(plane);
    fill_weights();
    fill_gradients();
  }

  LocalSquares local_squares(const Eigen::Matrix3Xd& positions) const {
    const Eigen::VectorXd heights = fold_heights(positions);
    Eigen::VectorXd square(rest_.triangle_count()), slope(rest_.triangle_count());
    for (int t = 0; t < rest_.triangle_count(); ++t) {
      const Eigen::Vector3d at = heights(rest_.triangles.col(t));
      square(t) = at.squaredNorm() / 3;
      slope(t) = (gradients_.middleCols<3>(3 * t) * at).squaredNorm();
    }
    return {weights_ * square, weights_ * slope};
  }

 private:
  /// In coordinates from -1 to 1, in which the polynomials are alike in size.
  void fill_basis(const Eigen::Matrix2Xd& plane) {
    scaled_.resize(2, plane.cols());
    basis_.resize(plane.cols(), 6);
    for (Eigen::Index i = 0; i < plane.cols(); ++i) {
      scaled_.col(i) = 2 * (plane.col(i) - low_).cwiseQuotient(extent_).array() - 1;
      basis_.row(i) = quadratics(scaled_(0, i), scaled_(1, i));
    }
    fit_.compute(basis_);
  }

  /// One row a window, one column a triangle; rows sum up to one.
  void fill_weights() {
    const double sigma = kWindow * extent_.maxCoeff();
    weights_.resize(kWindowsAlong * kWindowsAlong, rest_.triangle_count());
    for (int t = 0; t < rest_.triangle_count(); ++t) {
      const Eigen::Vector2d middle = rest_.rest_triangle(t).rowwise().mean();
      for (int i = 0; i < kWindowsAlong; ++i) {
        for (int j = 0; j < kWindowsAlong; ++j) {
          const Eigen::Array2d share = Eigen::Array2d(i + 1, j + 1) / (kWindowsAlong + 1);
          const Eigen::Vector2d centre = low_ + (share * extent_.array()).matrix();
          const double distance = (middle - centre).norm() / sigma;
          weights_(kWindowsAlong * i + j, t) =
              rest_area(rest_, t) * std::exp(-distance * distance / 2);
        }
      }
    }
    weights_.array().colwise() /= weights_.rowwise().sum().array().eval();
  }

  /// Of the linear functions of each triangle's vertices (1/m).
  void fill_gradients() {
    gradients_.resize(2, 3 * rest_.triangle_count());
    for (int t = 0; t < rest_.triangle_count(); ++t) {
      const Eigen::Matrix<double, 2, 3> x = rest_.rest_triangle(t);
      Eigen::Matrix2d sides;
      sides << x.col(1) - x.col(0), x.col(2) - x.col(0);
      const Eigen::Matrix2d inverse = sides.inverse();
      auto gradient = gradients_.middleCols<3>(3 * t);
      gradient.rightCols<2>() = inverse.transpose();
      gradient.col(0) = -gradient.col(1) - gradient.col(2);
    }
  }

  /// What the best quadratic surface leaves along its normal (m).
  Eigen::VectorXd fold_heights(const Eigen::Matrix3Xd& positions) const {
    const Eigen::Matrix<double, 6, 3> smooth = fit_.solve(positions.transpose());
    const Eigen::MatrixX3d left = positions.transpose() - basis_ * smooth;
    Eigen::VectorXd heights(positions.cols());
    for (Eigen::Index i = 0; i < positions.cols(); ++i) {
      const double u = scaled_(0, i), v = scaled_(1, i);
      const Eigen::RowVector3d along_u = quadratics_by_u(u, v) * smooth;
      const Eigen::RowVector3d along_v = quadratics_by_v(u, v) * smooth;
      heights(i) = left.row(i).dot(along_u.cross(along_v).normalized());
    }
    return heights;
  }

  const TriangleMesh& rest_;
  Eigen::Vector2d low_, extent_;
  Eigen::Matrix2Xd scaled_;
  Eigen::MatrixXd basis_;
  Eigen::HouseholderQR<Eigen::MatrixXd> fit_;
  Eigen::MatrixXd weights_;
  Eigen::Matrix2Xd gradients_;
};

double squared_difference(const Eigen::VectorXd& squares, const Eigen::VectorXd& others) {
  return (squares.cwiseSqrt() - others.cwiseSqrt()).squaredNorm();
}

}  // namespace

FoldError fold_error(const Session& measured, const Session& predicted) {
  PLIANT_ASSERT(measured.frame_count() == predicted.frame_count() && measured.frame_count() > 0 &&
                    measured.rest.vertex_count() == predicted.rest.vertex_count(),
                "two sessions are compared frame by frame on one mesh");
  const Windows windows(measured.rest);
  double heights = 0, slopes = 0;
  for (std::size_t f = 0; f < measured.frames.size(); ++f) {
    const LocalSquares seen = windows.local_squares(measured.frames[f].positions);
    const LocalSquares found = windows.local_squares(predicted.frames[f].positions);
    heights += squared_difference(seen.height, found.height);
    slopes += squared_difference(seen.slope, found.slope);
  }
  const double count = kWindowsAlong * kWindowsAlong * measured.frame_count();
  return {std::sqrt(heights / count), std::sqrt(slopes / count)};
}

}  // namespace pliant
