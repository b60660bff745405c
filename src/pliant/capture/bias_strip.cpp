#include "pliant/capture/bias_strip.h"

#include <numbers>

#include <Eigen/Geometry>

namespace pliant {

Session in_yarn_axes(Session strip) {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(-std::numbers::pi / 4, Eigen::Vector3d::UnitZ()));
  Eigen::Matrix3Xd turned = turn.toRotationMatrix() * strip.rest.positions;
  const Eigen::Vector3d least = turned.rowwise().minCoeff();
  turned.colwise() -= least;
  strip.rest = flat_mesh(turned.topRows<2>(), strip.rest.triangles);
  for (SessionFrame& frame : strip.frames) {
    for (Pose& pose : frame.poses) {
      pose.translation = pose.apply(turn.conjugate() * least);
      pose.rotation = (pose.rotation * turn.conjugate()).normalized();
    }
  }
  strip.sample.width = turned.row(0).maxCoeff();
  strip.sample.height = turned.row(1).maxCoeff();
  return strip;
}

}  // namespace pliant
