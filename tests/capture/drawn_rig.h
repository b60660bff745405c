#pragma once

#include <cmath>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "pliant/capture/cloth_print.h"
#include "pliant/capture/dic_file.h"
#include "pliant/capture/point_source.h"
#include "pliant/capture/view_drawing.h"
#include "pliant/geometry/regular_grid.h"

namespace pliant::test {

/// Where a place of the sample is, in axes in which it is at rest at (u, v, 0).
using SheetMotion = std::function<Eigen::Vector3d(const Eigen::Vector2d& rest)>;

/// A print of 0.1 mm a pixel on a square.
inline ClothPrint print_on_square(double size) {
  constexpr double kPixel = 0.1e-3;
  const int pixels = static_cast<int>(size / kPixel);
  ClothPattern pattern;
  pattern.seed = 3;
  return {pattern, pixels, pixels, kPixel};
}

/// Cameras half a metre away that look at the middle of a printed square from all around, 0.25 mm a
/// pixel ([T] 3.2.1), and what they see of it frame by frame.
class DrawnRig {
 public:
  double size = 0.1;  ///< of the square (m)
  std::vector<CameraModel> cameras;
  std::vector<SheetMotion> frames;  ///< the first at rest
  ViewOptions light;
  ChipNoise noise;

  DrawnRig(int count, int columns, int rows, double sheet)
      : size(sheet), to_rig_(Eigen::Isometry3d::Identity()), print_(print_on_square(sheet)) {
    for (int c = 0; c < count; ++c) cameras.push_back(camera(c, count, columns, rows));
    const RigidMotion first = cameras[0].pose.inverse();
    to_rig_ = cameras[0].pose.isometry();
    for (CameraModel& own : cameras) own.pose = own.pose * first;
  }

  const Eigen::Isometry3d& to_rig() const { return to_rig_; }

  /// What there is besides the sheet, in its axes.
  std::function<std::vector<DrawnSurface>(int frame)> others = [](int) {
    return std::vector<DrawnSurface>{};
  };

  GreyPicture picture(int camera, int frame) const {
    std::vector<DrawnSurface> surfaces = others(frame);
    for (DrawnSurface& surface : surfaces) surface.positions = in_rig(surface.positions);
    surfaces.push_back(sheet(frame));
    GreyPicture drawn = draw_view(cameras[camera], surfaces, light);
    RandomStream random(static_cast<std::uint64_t>(1000 * camera + frame));
    add_chip_noise(drawn, noise, random);
    return drawn;
  }

  /// As it is drawn, in rig axes.
  DrawnSurface sheet(int frame) const {
    const int nodes = static_cast<int>(std::lround(size / 1e-3)) + 1;
    const TriangleMesh rest = regular_grid(size, size, nodes, nodes);
    DrawnSurface surface;
    surface.triangles = rest.triangles;
    surface.places = rest.positions.topRows<2>();
    surface.positions.resize(3, rest.vertex_count());
    for (int v = 0; v < rest.vertex_count(); ++v) {
      surface.positions.col(v) = to_rig_ * frames[frame](surface.places.col(v));
    }
    surface.brightness = [this](const Eigen::Vector2d& place) { return print_.at(place); };
    return surface;
  }

  ReadPicture reader() const {
    return [this](const std::filesystem::path& file) {
      return picture(std::stoi(file.parent_path().string()), std::stoi(file.filename().string()));
    };
  }

  /// The document of it; its files are camera/frame.
  DicFile dic() const {
    DicFile dic;
    dic.file = "capture.yaml";
    dic.test = "free";
    dic.sample = {"", size, size, std::nullopt, 0.15};
    dic.origin = Eigen::Vector2d::Zero();
    DicViews& views = dic.views.emplace();
    views.cameras = cameras;
    const auto numbers = static_cast<Eigen::Index>(15 * cameras.size());
    views.covariance = Eigen::MatrixXd::Zero(numbers, numbers);
    for (int c = 0; c < std::ssize(cameras); ++c) {
      views.names.push_back(std::string("camera") + std::to_string(c));
      std::vector<std::filesystem::path> files;
      for (int f = 0; f < std::ssize(frames); ++f) {
        files.push_back(std::filesystem::path(std::to_string(c)) / std::to_string(f));
      }
      views.files.push_back(files);
    }
    Eigen::Matrix<double, 3, 4> corners;
    corners << 0, size, size, 0, 0, 0, size, size, 0, 0, 0, 0;
    for (int k = 0; k < 4; ++k) {
      views.corners.col(k) = *cameras[0].project(to_rig_ * corners.col(k));
    }
    return dic;
  }

 private:
  static constexpr double kDistance = 0.5;  // m

  CameraModel camera(int number, int count, int columns, int rows) const {
    CameraModel result;
    result.columns = columns;
    result.rows = rows;
    result.intrinsics << 2000 + 8 * number, 2003, columns / 2.0 + 3 * number, rows / 2.0, -0.12,
        0.05, 0.0004, -0.0003, 0;
    // On a circle around the sheet's normal, 20 degrees off it.
    const double around = 2 * M_PI * number / count + 0.4, off = 0.35;
    const Eigen::Vector3d middle(size / 2, size / 2, 0);
    const Eigen::Vector3d from =
        middle + kDistance * Eigen::Vector3d(std::sin(off) * std::cos(around),
                                             std::sin(off) * std::sin(around), std::cos(off));
    Eigen::Matrix3d axes;  // rows: right, down, away
    axes.row(2) = (middle - from).normalized();
    axes.row(0) = Eigen::Vector3d::UnitY().cross(Eigen::Vector3d(-axes.row(2))).normalized();
    axes.row(1) = axes.row(2).cross(axes.row(0));
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = axes;
    pose.translation() = -axes * from;
    result.pose = RigidMotion::of(pose);
    return result;
  }

  Eigen::Matrix3Xd in_rig(const Eigen::Matrix3Xd& positions) const {
    return (to_rig_.linear() * positions).colwise() + to_rig_.translation();
  }

  Eigen::Isometry3d to_rig_;  // from the axes of the sheet
  ClothPrint print_;
};

}  // namespace pliant::test
