#include "pliant/capture/homography.h"

#include <cmath>

#include <Eigen/LU>
#include <Eigen/SVD>

namespace pliant {
namespace {

// Moves places to a middle of 0 and a mean distance of sqrt(2), which conditions the equations.
Eigen::Matrix3d normalisation(const Eigen::Matrix2Xd& places) {
  const Eigen::Vector2d middle = places.rowwise().mean();
  const double distance = (places.colwise() - middle).colwise().norm().mean();
  const double scale = distance > 0 ? std::sqrt(2.0) / distance : 1;
  Eigen::Matrix3d result;
  result << scale, 0, -scale * middle.x(), 0, scale, -scale * middle.y(), 0, 0, 1;
  return result;
}

Eigen::Matrix3d pinhole(double focal_length, const Eigen::Vector2d& principal) {
  Eigen::Matrix3d result;
  result << focal_length, 0, principal.x(), 0, focal_length, principal.y(), 0, 0, 1;
  return result;
}

}  // namespace

Eigen::Matrix3d homography(const Eigen::Matrix2Xd& plane, const Eigen::Matrix2Xd& seen) {
  const Eigen::Matrix3d from = normalisation(plane), to = normalisation(seen);
  Eigen::Matrix<double, Eigen::Dynamic, 9> equations(2 * plane.cols(), 9);
  for (Eigen::Index i = 0; i < plane.cols(); ++i) {
    const Eigen::RowVector3d p = (from * plane.col(i).homogeneous()).transpose();
    const Eigen::Vector2d q = (to * seen.col(i).homogeneous()).head<2>();
    equations.row(2 * i) << p, 0, 0, 0, -q.x() * p;
    equations.row(2 * i + 1) << 0, 0, 0, p, -q.y() * p;
  }
  const Eigen::Matrix<double, 9, 9> normal = equations.transpose() * equations;
  const Eigen::JacobiSVD<Eigen::Matrix<double, 9, 9>> svd(normal, Eigen::ComputeFullV);
  const Eigen::Vector<double, 9> h = svd.matrixV().col(8);
  const Eigen::Matrix3d normalised =
      Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(h.data());
  const Eigen::Matrix3d result = to.inverse() * normalised * from;
  return result / result.norm();
}

double focal_length_of_planes(const std::vector<Eigen::Matrix3d>& homographies,
                              const Eigen::Vector2d& principal, double otherwise) {
  // Images of two unit vectors across each other remain so, and of one length: two equations for
  // 1 / f^2 from each view.
  double product = 0, square = 0;
  for (const Eigen::Matrix3d& seen : homographies) {
    Eigen::Matrix3d h = pinhole(1, principal).inverse() * seen;
    h.topRows<2>() /= otherwise;  // numbers about one
    h /= h.leftCols<2>().norm();
    const Eigen::Vector3d a = h.col(0), b = h.col(1);
    const double across = a.head<2>().dot(b.head<2>());
    const double longer = a.head<2>().squaredNorm() - b.head<2>().squaredNorm();
    product -= across * a.z() * b.z() + longer * (a.z() * a.z() - b.z() * b.z());
    square += across * across + longer * longer;
  }
  if (!(product > 0) || !(square > 0)) return otherwise;
  const double inverse_square = product / square;  // of f in units of `otherwise`
  constexpr double kLongest = 20, kShortest = 0.1;
  const double f = 1 / std::sqrt(inverse_square);
  return f > kShortest && f < kLongest ? f * otherwise : otherwise;
}

RigidMotion pose_of_plane(const Eigen::Matrix3d& homography, double focal_length,
                          const Eigen::Vector2d& principal) {
  Eigen::Matrix3d h = pinhole(focal_length, principal).inverse() * homography;
  h /= std::sqrt(h.col(0).norm() * h.col(1).norm());
  if (h(2, 2) < 0) h = -h;
  Eigen::Matrix3d turn;
  turn << h.col(0), h.col(1), h.col(0).cross(h.col(1));
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(turn, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = svd.matrixU() * svd.matrixV().transpose();
  if (pose.linear().determinant() < 0) {
    pose.linear() =
        svd.matrixU() * Eigen::Vector3d(1, 1, -1).asDiagonal() * svd.matrixV().transpose();
  }
  pose.translation() = h.col(2);
  return RigidMotion::of(pose);
}

}  // namespace pliant
