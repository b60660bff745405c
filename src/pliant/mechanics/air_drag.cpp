#include "pliant/mechanics/air_drag.h"

#include <cmath>

namespace pliant {

AirDrag::AirDrag(const Air& air, const Eigen::Matrix3Xi& faces, const Eigen::Matrix3Xd& start,
                 const Eigen::Matrix3Xd& velocities, double time)
    : faces_(faces), normals_(3, faces.cols()), stiffness_(faces.cols()), targets_(faces.size()) {
  for (Eigen::Index f = 0; f < faces.cols(); ++f) {
    const Eigen::Vector3d a = start.col(faces(0, f));
    const Eigen::Vector3d twice_area =
        (start.col(faces(1, f)) - a).cross(start.col(faces(2, f)) - a);
    const double length = twice_area.norm();
    const Eigen::Vector3d normal = length > 0 ? (twice_area / length).eval() : twice_area;
    normals_.col(f) = normal;
    const Eigen::Vector3d mean =
        (velocities.col(faces(0, f)) + velocities.col(faces(1, f)) + velocities.col(faces(2, f))) /
        3;
    const double against = std::abs(normal.dot(mean - air.wind));
    stiffness_(f) = air.drag * air.density * length / 2 * against / 2 / time / 3;
    for (int i = 0; i < 3; ++i) {
      targets_(3 * f + i) = normal.dot(start.col(faces(i, f)) + time * air.wind);
    }
  }
}

void AirDrag::evaluate(const Evaluation& at, Derivatives& derivatives) const {
  for (Eigen::Index f = 0; f < faces_.cols(); ++f) {
    const Eigen::Vector3d n = normals_.col(f);
    for (int i = 0; i < 3; ++i) {
      const int point = faces_(i, f);
      const double along = way(f, i, at.configuration);
      derivatives.energy.work += stiffness_(f) * along * along / 2;
      if (derivatives.gradient) derivatives.gradient->col(point) += stiffness_(f) * along * n;
      if (derivatives.hessian) {
        derivatives.hessian->coordinates.add_coupling(at.configuration, point, point,
                                                      stiffness_(f) * n * n.transpose(),
                                                      derivatives.hessian->matrix);
      }
    }
  }
}

double AirDrag::work(const Configuration& from, const Configuration& to) const {
  double sum = 0;
  for (Eigen::Index f = 0; f < faces_.cols(); ++f) {
    for (int i = 0; i < 3; ++i) {
      const int point = faces_(i, f);
      const Eigen::Vector3d moved = to.positions.col(point) - from.positions.col(point);
      sum += stiffness_(f) * way(f, i, to) * normals_.col(f).dot(moved);
    }
  }
  return sum;
}

}  // namespace pliant
