#include "pliant/capture/sample_axes.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/quantity.h"

namespace pliant {
namespace {

Eigen::Vector3d unit(const PointAxis& axis) { return axis.sign * Eigen::Vector3d::Unit(axis.axis); }

/// The normal of the plane through points, on the side of weft x warp.
Eigen::Vector3d normal_of(const Eigen::Matrix3Xd& rest, const Eigen::Vector3d& towards) {
  const Eigen::Matrix3Xd centred = rest.colwise() - rest.rowwise().mean();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread(centred * centred.transpose());
  const Eigen::Vector3d normal = spread.eigenvectors().col(0);
  return normal.dot(towards) < 0 ? Eigen::Vector3d(-normal) : normal;
}

/// The point of a plane with these first two coordinates.
Eigen::Vector3d in_plane(const Eigen::Vector2d& place, const Eigen::Vector3d& normal,
                         const Eigen::Vector3d& middle) {
  const Eigen::Vector2d way = place - middle.head<2>();
  return {place.x(), place.y(), middle.z() - normal.head<2>().dot(way) / normal.z()};
}

void require_fit(const DicFile& dic, const Eigen::Matrix3Xd& on_sample) {
  constexpr double kOutside = 0.1, kCovered = 0.25;
  const Eigen::Vector2d size(dic.sample.width, dic.sample.height);
  const Eigen::Vector2d least = on_sample.topRows<2>().rowwise().minCoeff();
  const Eigen::Vector2d most = on_sample.topRows<2>().rowwise().maxCoeff();
  for (const int axis : {0, 1}) {
    const char* name = axis == 0 ? "weft" : "warp";
    const double out = std::max(-least(axis), most(axis) - size(axis));
    const double covered = most(axis) - least(axis);
    if (out <= kOutside * size(axis) && covered >= kCovered * size(axis)) continue;
    throw InputError(
        {dic.file, 0, "sample"},
        fmt::format("the points at rest go from {} to {} along {} of a sample of {}",
                    format_quantity(least(axis), Dimension::length),
                    format_quantity(most(axis), Dimension::length), name,
                    format_quantity(size(axis), Dimension::length)),
        "points of this sample: its size, `origin`, `weft`, `warp` and `scale` tell where it lies");
  }
}

}  // namespace

Pose SampleAxes::of(const Pose& motion) const {
  const Eigen::Matrix3d turn = axes * motion.rotation.toRotationMatrix() * axes.transpose();
  return {Eigen::Quaterniond(turn).normalized(), axes * (motion.apply(corner) - corner)};
}

CordLine SampleAxes::of(CordLine line) const {
  line.from = axes * (line.from - corner);
  line.direction = axes * line.direction;
  return line;
}

SampleAxes sample_axes(const DicFile& dic, const Eigen::Matrix3Xd& rest) {
  SampleAxes sample;
  const Eigen::Vector3d towards = unit(dic.weft).cross(unit(dic.warp));
  const Eigen::Vector3d normal = normal_of(rest, towards);
  const Eigen::Vector3d weft = (unit(dic.weft) - normal.dot(unit(dic.weft)) * normal).normalized();
  sample.axes.row(0) = weft;
  sample.axes.row(1) = normal.cross(weft);
  sample.axes.row(2) = normal;

  Eigen::Matrix3Xd on_sample = sample.of(rest);
  Eigen::Vector3d corner;
  if (dic.origin) {
    corner = sample.axes * in_plane(*dic.origin, normal, rest.rowwise().mean());
  } else {
    const Eigen::Vector3d middle =
        (on_sample.rowwise().minCoeff() + on_sample.rowwise().maxCoeff()) / 2;
    corner = middle - Eigen::Vector3d(dic.sample.width, dic.sample.height, 0) / 2;
  }
  corner.z() = on_sample.row(2).mean();
  sample.corner = sample.axes.transpose() * corner;
  on_sample = sample.of(rest);
  sample.off_plane = std::sqrt(on_sample.row(2).squaredNorm() / static_cast<double>(rest.cols()));
  require_fit(dic, on_sample);
  return sample;
}

}  // namespace pliant
