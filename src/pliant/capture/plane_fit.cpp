#include "pliant/capture/plane_fit.h"

#include <cmath>

#include <Eigen/LU>
#include <Eigen/QR>
#include <ceres/ceres.h>

namespace pliant {
namespace {

/// Lengths of the plane and of the picture that make all unknowns about one.
struct PlaneUnits {
  Eigen::Vector2d place, pixel;          // that are zero
  double length = 1, pixels_a_unit = 1;  // of one
};

PlaneUnits units_of(const std::vector<LabelSighting>& sightings) {
  PlaneUnits units;
  units.place = sightings.front().rest.rowwise().mean();
  units.pixel = sightings.front().seen.rowwise().mean();
  units.length = (sightings.front().rest.colwise() - units.place).norm();
  units.pixels_a_unit = (sightings.front().seen.colwise() - units.pixel).norm();
  return units;
}

/// One corner: eight numbers of the homography (the ninth is 1), angle and shift of the body about
/// the middle of its labels.
struct CornerMiss {
  Eigen::Vector2d from_middle, middle, seen;  // in units

  template <class T>
  bool operator()(const T* h, const T* motion, T* residual) const {
    using std::cos, std::sin;
    const T c = cos(motion[0]), s = sin(motion[0]);
    const T x = c * from_middle.x() - s * from_middle.y() + middle.x() + motion[1];
    const T y = s * from_middle.x() + c * from_middle.y() + middle.y() + motion[2];
    const T depth = h[6] * x + h[7] * y + T(1);
    residual[0] = (h[0] * x + h[1] * y + h[2]) / depth - seen.x();
    residual[1] = (h[3] * x + h[4] * y + h[5]) / depth - seen.y();
    return true;
  }
};

/// The affine map by which a picture shows the body that stays: a start.
Eigen::Matrix<double, 2, 3> affine_start(const Eigen::Matrix2Xd& rest,
                                         const Eigen::Matrix2Xd& seen) {
  const Eigen::MatrixXd equations = rest.colwise().homogeneous().transpose();
  return equations.colPivHouseholderQr().solve(seen.transpose()).transpose();
}

/// All corners of a body in units: at rest above, as they are seen below.
Eigen::Matrix4Xd corners_of(const std::vector<LabelSighting>& sightings, int body,
                            const PlaneUnits& units) {
  Eigen::Matrix4Xd corners(4, 0);
  for (const LabelSighting& sighting : sightings) {
    if (sighting.body != body) continue;
    corners.conservativeResize(4, corners.cols() + 4);
    corners.topRightCorner<2, 4>() = (sighting.rest.colwise() - units.place) / units.length;
    corners.bottomRightCorner<2, 4>() =
        (sighting.seen.colwise() - units.pixel) / units.pixels_a_unit;
  }
  return corners;
}

struct BodyMotion {
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();  // of its corners at rest
  Eigen::Vector3d motion = Eigen::Vector3d::Zero();  // angle, shift
};

/// The rigid motion nearest to the one that the start of the homography shows.
BodyMotion motion_start(const Eigen::Matrix4Xd& corners, const Eigen::Matrix<double, 2, 3>& start) {
  const Eigen::Matrix2Xd rest = corners.topRows<2>();
  const Eigen::Matrix2Xd now =
      start.leftCols<2>().inverse() * (corners.bottomRows<2>().colwise() - start.col(2));
  BodyMotion body{rest.rowwise().mean()};
  const Eigen::Vector2d middle = now.rowwise().mean();
  const Eigen::Matrix2d spread =
      (now.colwise() - middle) * (rest.colwise() - body.middle).transpose();
  body.motion << std::atan2(spread(1, 0) - spread(0, 1), spread(0, 0) + spread(1, 1)),
      middle - body.middle;
  return body;
}

/// x -> middle + R (x - middle) + shift, in the units of the plane, as a motion in metres.
Pose pose_of(const BodyMotion& body, const PlaneUnits& units) {
  Pose pose;
  pose.rotation = Eigen::AngleAxisd(body.motion(0), Eigen::Vector3d::UnitZ());
  const Eigen::Vector2d middle = units.place + units.length * body.middle;
  const Eigen::Vector3d about(middle.x(), middle.y(), 0);
  const Eigen::Vector3d shift(units.length * body.motion(1), units.length * body.motion(2), 0);
  pose.translation = about + shift - pose.rotation * about;
  return pose;
}

}  // namespace

PlaneFit fit_plane(const std::vector<LabelSighting>& sightings, int bodies) {
  const PlaneUnits units = units_of(sightings);
  std::vector<Eigen::Matrix4Xd> corners;
  for (int body = 0; body < bodies; ++body) corners.push_back(corners_of(sightings, body, units));
  const Eigen::Matrix<double, 2, 3> start =
      affine_start(corners.front().topRows<2>(), corners.front().bottomRows<2>());
  Eigen::Vector<double, 8> h;
  h << start(0, 0), start(0, 1), start(0, 2), start(1, 0), start(1, 1), start(1, 2), 0, 0;
  std::vector<BodyMotion> motions;
  for (const Eigen::Matrix4Xd& body : corners) motions.push_back(motion_start(body, start));
  motions.front().motion.setZero();

  ceres::Problem problem;
  for (std::size_t body = 0; body < motions.size(); ++body) {
    for (const auto& corner : corners[body].colwise()) {
      auto* miss = new CornerMiss{corner.head<2>() - motions[body].middle, motions[body].middle,
                                  corner.tail<2>()};
      problem.AddResidualBlock(new ceres::AutoDiffCostFunction<CornerMiss, 2, 8, 3>(miss), nullptr,
                               h.data(), motions[body].motion.data());
    }
  }
  problem.SetParameterBlockConstant(motions.front().motion.data());
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.function_tolerance = 1e-14;
  options.parameter_tolerance = 1e-12;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);

  PlaneFit fit;
  Eigen::Matrix3d in_units, place, pixel;
  in_units << h(0), h(1), h(2), h(3), h(4), h(5), h(6), h(7), 1;
  place << 1 / units.length, 0, -units.place.x() / units.length, 0, 1 / units.length,
      -units.place.y() / units.length, 0, 0, 1;
  pixel << units.pixels_a_unit, 0, units.pixel.x(), 0, units.pixels_a_unit, units.pixel.y(), 0, 0,
      1;
  fit.to_picture = pixel * in_units * place;
  for (const BodyMotion& motion : motions) fit.bodies.push_back(pose_of(motion, units));
  fit.miss = units.pixels_a_unit *
             std::sqrt(2 * summary.final_cost / static_cast<double>(summary.num_residuals));
  return fit;
}

}  // namespace pliant
