#pragma once

#include <vector>

#include "pliant/base/random.h"
#include "pliant/capture/rig_calibration.h"

namespace pliant::test {

/// Cameras on an arc of 40 degrees that look at a board, and pictures of it as corners with noise.
class VirtualRig {
 public:
  std::vector<CameraModel> cameras;
  RigFile rig;
  double noise = 0.05;     ///< pixels
  double tilt = 0.6;       ///< largest, of the board (rad)
  double print_scale = 1;  ///< of the board, against what its file says

  double bend = 0;  ///< of the board out of its plane at its left and right edges (m)

  explicit VirtualRig(int count, const TagBoard& board = {4, 6, 0.018, 0.0045, 0}) {
    rig.file = "rig.yaml";
    rig.boards = {{"board.yaml", board}};
    rig.where_boards = {{"rig.yaml", 4, "calibration.boards"}};
    for (int c = 0; c < count; ++c) {
      const std::string name = std::string("camera") + std::to_string(c);
      rig.cameras.push_back({name, free_intrinsics("k1 k2 p1 p2"), {"rig.yaml", 2 + c, name}});
      cameras.push_back(camera(count < 2 ? 0 : -0.35 + 0.7 * c / (count - 1), c));
    }
    const RigidMotion first = cameras[0].pose.inverse();
    for (CameraModel& own : cameras) own.pose = own.pose * first;
  }

  /// @param sees  whether a camera takes part in a shot
  std::vector<RigPicture> pictures(
      int shots, RandomStream random,
      const std::function<bool(int, int)>& sees = [](int, int) { return true; }) const {
    std::vector<RigPicture> result;
    Eigen::Matrix3Xd corners = print_scale * rig.boards[0].corners();
    const Eigen::RowVectorXd along =
        2 * corners.row(0).array() / corners.row(0).maxCoeff() - 1;  // -1 to 1
    corners.row(2) = bend * along.cwiseAbs2();
    const Eigen::Vector3d middle = corners.rowwise().mean();
    for (int shot = 0; shot < shots; ++shot) {
      const RigidMotion pose = placement_of(shot, random, middle);
      for (int c = 0; c < std::ssize(cameras); ++c) {
        if (sees(c, shot)) result.push_back(picture(c, shot, pose, corners, random));
      }
    }
    return result;
  }

  /// The same with two tags, 100 and 101, in the board's plane below it.
  /// @param length  between their middles (m)
  std::vector<RigPicture> pictures_with_ruler(int shots, double length, RandomStream random) const {
    std::vector<RigPicture> result = pictures(shots, random);
    const Eigen::Vector3d middle = (print_scale * rig.boards[0].corners()).rowwise().mean();
    RandomStream noises = random.split("ruler");
    for (int shot = 0; shot < shots; ++shot) {
      // The placements are drawn again, as `pictures` drew them.
      const auto pose = placement_of(shot, random, middle);
      for (RigPicture& picture : result) {
        if (picture.shot != shot) continue;
        for (int k = 0; k < 2; ++k) {
          picture.findings.other_tags.push_back(
              ruler_tag(picture.camera, 100 + k, pose, {k * length, -0.02, 0}, noises));
        }
      }
    }
    return result;
  }

 private:
  static constexpr double kDistance = 0.5;  // m

  static CameraModel camera(double angle, int number) {
    CameraModel result;
    result.columns = 1280;
    result.rows = 1024;
    result.intrinsics << 2000 + 10 * number, 2005, 640 + 4 * number, 512, -0.12, 0.05, 0.0004,
        -0.0003, 0;
    result.pose = {{0, angle, 0}, {0, 0, kDistance}};  // looks at the origin
    return result;
  }

  RigidMotion placement(RandomStream& random, const Eigen::Vector3d& middle) const {
    const auto any = [&](double most) { return random.uniform(-most, most); };
    // Its face towards the cameras: half a turn about x.
    const RigidMotion face{{3.141592653589793, 0, 0}, {0, 0, 0}};
    const RigidMotion turn = RigidMotion{{any(tilt), any(tilt), any(0.5)}, Eigen::Vector3d::Zero()};
    const RigidMotion shift{Eigen::Vector3d::Zero(), {any(0.07), any(0.05), any(0.06)}};
    const RigidMotion to_middle{Eigen::Vector3d::Zero(), -middle};
    return origin_in_rig() * shift * turn * face * to_middle;
  }

  RigidMotion placement_of(int shot, const RandomStream& random,
                           const Eigen::Vector3d& middle) const {
    RandomStream own = random.split("shot" + std::to_string(shot));
    return placement(own, middle);
  }

  DetectedTag ruler_tag(int camera, int code, const RigidMotion& pose, const Eigen::Vector3d& at,
                        RandomStream& random) const {
    constexpr double kSide = 0.01;
    constexpr double kX[] = {-1, 1, 1, -1}, kY[] = {-1, -1, 1, 1};
    DetectedTag tag;
    tag.code = code;
    for (int i = 0; i < 4; ++i) {
      const Eigen::Vector3d corner = at + kSide / 2 * Eigen::Vector3d(kX[i], kY[i], 0);
      tag.corners.col(i) = *cameras[camera].project(pose * corner) +
                           noise * Eigen::Vector2d(random.normal(), random.normal());
    }
    tag.of_lines = tag.corners;  // so small that the lens bends no edge
    return tag;
  }

  // The point that all cameras look at, with the axes of the middle of their arc.
  RigidMotion origin_in_rig() const {
    const double angle = cameras.size() < 2 ? 0 : -0.35;
    return {{0, angle, 0}, {0, 0, kDistance}};
  }

  RigPicture picture(int camera, int shot, const RigidMotion& pose, const Eigen::Matrix3Xd& corners,
                     RandomStream& random) const {
    RigPicture result;
    result.camera = camera;
    result.shot = shot;
    result.file = rig.cameras[camera].name + "/" + std::to_string(shot) + ".png";
    const CameraModel& model = cameras[camera];
    result.columns = model.columns;
    result.rows = model.rows;
    BoardView view;
    std::vector<Eigen::Vector2d> pixels;
    for (int tag = 0; tag < corners.cols() / 4; ++tag) {
      std::vector<Eigen::Vector2d> own;
      for (int i = 0; i < 4; ++i) {
        const auto pixel = model.project(pose * corners.col(4 * tag + i));
        if (!pixel || pixel->minCoeff() < 2 || pixel->x() > model.columns - 3 ||
            pixel->y() > model.rows - 3) {
          break;
        }
        own.push_back(*pixel);
      }
      if (own.size() < 4) continue;
      for (int i = 0; i < 4; ++i) {
        view.corners.push_back(4 * tag + i);
        pixels.push_back(own[i] + noise * Eigen::Vector2d(random.normal(), random.normal()));
      }
    }
    view.pixels.resize(2, std::ssize(pixels));
    for (int i = 0; i < std::ssize(pixels); ++i) view.pixels.col(i) = pixels[i];
    if (view.corners.size() >= 8) {
      result.findings.boards.push_back(view);
    } else {
      result.left_out = "shows no board";
    }
    return result;
  }
};

}  // namespace pliant::test
