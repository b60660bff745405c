#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "pliant/capture/view_drawing.h"

#include "capture/drawn_rig.h"

namespace pliant::test {

/// What cameras can see of a sheet, as rays tell.
class Sight {
 public:
  /// @param sheet   where a place of it is, in the axes of the cameras
  /// @param mesh    the sheet as it is drawn; its places are those of `sheet`
  /// @param others  what may hide it
  Sight(std::vector<CameraModel> cameras, const Eigen::Vector2d& size, SheetMotion sheet,
        DrawnSurface mesh, const std::vector<DrawnSurface>& others = {})
      : cameras_(std::move(cameras)), size_(size), sheet_(std::move(sheet)) {
    for (const CameraModel& camera : cameras_) {
      pictures_.emplace_back(shown(camera, mesh, others, 0), shown(camera, mesh, others, 1));
    }
  }

  /// Whether two cameras at least see a place from 70 degrees or less off the normal.
  bool of(const Eigen::Vector2d& place) const {
    int cameras = 0;
    for (std::size_t c = 0; c < pictures_.size(); ++c) cameras += shows(c, place);
    return cameras >= 2;
  }

 private:
  static constexpr double kNowhere = 2;  // no share of a side

  /// Of each pixel a coordinate of the place that it shows, over the side.
  GreyPicture shown(const CameraModel& camera, DrawnSurface mesh, std::vector<DrawnSurface> others,
                    Eigen::Index axis) const {
    mesh.gloss = 0;
    mesh.brightness = [this, axis](const Eigen::Vector2d& place) {
      return place(axis) / size_(axis);
    };
    for (DrawnSurface& other : others) {
      other.brightness = [](const Eigen::Vector2d&) { return kNowhere; };
    }
    others.push_back(std::move(mesh));
    ViewOptions plain;
    plain.ambient = 1;
    plain.background = kNowhere;
    plain.blur = 0;
    plain.samples = 1;
    return draw_view(camera, others, plain);
  }

  bool shows(std::size_t c, const Eigen::Vector2d& place) const {
    constexpr double kNear = 1.5e-3, kFacing = 0.34;
    const CameraModel& camera = cameras_[c];
    const auto pixel = camera.project(sheet_(place));
    if (!pixel) return false;
    const Eigen::Array2i at = pixel->array().round().cast<int>();
    if ((at < 0).any() || at.x() >= camera.columns || at.y() >= camera.rows) return false;
    const Eigen::Vector2d shown(pictures_[c].first(at.y(), at.x()),
                                pictures_[c].second(at.y(), at.x()));
    return (shown.cwiseProduct(size_) - place).norm() < kNear && facing(camera, place) > kFacing;
  }

  /// By how much the printed side faces a camera: the cosine of the angle.
  double facing(const CameraModel& camera, const Eigen::Vector2d& place) const {
    const Eigen::Vector3d here = sheet_(place);
    const Eigen::Vector3d normal = along(place, here, 0).cross(along(place, here, 1)).normalized();
    return normal.dot((camera.centre() - here).normalized());
  }

  /// Of the sheet at a place, which may lie at its edge.
  Eigen::Vector3d along(const Eigen::Vector2d& place, const Eigen::Vector3d& here,
                        Eigen::Index axis) const {
    constexpr double kStep = 1e-5;  // m
    const double step = place(axis) < size_(axis) / 2 ? kStep : -kStep;
    return (sheet_(place + step * Eigen::Vector2d::Unit(axis)) - here) / step;
  }

  std::vector<CameraModel> cameras_;
  Eigen::Vector2d size_;
  SheetMotion sheet_;
  std::vector<std::pair<GreyPicture, GreyPicture>> pictures_;  // u and v of what each pixel shows
};

}  // namespace pliant::test
