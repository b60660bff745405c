#include "pliant/capture/view_drawing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "pliant/base/parallel.h"

namespace pliant {
namespace {

/// Directions (x / z, y / z) that are seen at the corners of pixels, NaN where none is.
class PixelCorners {
 public:
  explicit PixelCorners(const CameraModel& camera)
      : x_(camera.rows + 1, camera.columns + 1), y_(camera.rows + 1, camera.columns + 1) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    parallel_for(camera.rows + 1, [&](int row) {
      for (int column = 0; column <= camera.columns; ++column) {
        const auto straight = camera.straight({column - 0.5, row - 0.5});
        x_(row, column) = straight ? straight->x() : kNone;
        y_(row, column) = straight ? straight->y() : kNone;
      }
    });
  }

  /// @param right, down  within the pixel, 0 to 1; over a pixel no lens bends noticeably
  Eigen::Vector3d direction(int row, int column, double right, double down) const {
    const auto between = [&](const Grid& grid) {
      const double upper = (1 - right) * grid(row, column) + right * grid(row, column + 1);
      const double lower = (1 - right) * grid(row + 1, column) + right * grid(row + 1, column + 1);
      return (1 - down) * upper + down * lower;
    };
    return {between(x_), between(y_), 1};
  }

 private:
  using Grid = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Grid x_, y_;
};

/// A triangle in camera axes and the pixels that may show it.
struct Facet {
  int surface = 0, triangle = 0;
  Eigen::Vector3d corner, first, second;  // two edges from the corner
  Eigen::Vector2i from, to;               // columns and rows, both included
  double light = 1, shine = 0;
};

/// Where a ray from the camera's centre meets a plane piece [Moller1997].
struct Meeting {
  double depth = std::numeric_limits<double>::infinity();
  double first = 0, second = 0;  // along the edges
};

std::optional<Meeting> meeting_of(const Facet& facet, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d across = direction.cross(facet.second);
  const double volume = facet.first.dot(across);
  if (volume == 0) return std::nullopt;
  const Eigen::Vector3d back = -facet.corner;
  const double first = back.dot(across) / volume;
  if (!(first >= 0 && first <= 1)) return std::nullopt;
  const Eigen::Vector3d turned = back.cross(facet.first);
  const double second = direction.dot(turned) / volume;
  if (!(second >= 0 && first + second <= 1)) return std::nullopt;
  const double depth = facet.second.dot(turned) / volume;
  if (!(depth > 0)) return std::nullopt;
  return Meeting{depth, first, second};
}

double light_on(const Eigen::Vector3d& normal, const ViewOptions& options) {
  const double facing = std::abs(normal.normalized().dot(options.light.normalized()));
  return options.ambient + (1 - options.ambient) * facing;
}

/// Of the light that comes from one side.
double shine_on(const Eigen::Vector3d& normal, const Eigen::Vector3d& to_camera,
                const ViewOptions& options) {
  constexpr double kSharpness = 30;
  const Eigen::Vector3d half = to_camera.normalized() + options.light.normalized();
  return std::pow(std::abs(normal.normalized().dot(half.normalized())), kSharpness);
}

std::vector<Facet> facets_of(const CameraModel& camera, const std::vector<DrawnSurface>& surfaces,
                             const ViewOptions& options) {
  const Eigen::Vector2d size(camera.columns, camera.rows);
  const Eigen::Matrix3d turn = camera.pose.matrix();
  const Eigen::Vector3d centre = camera.centre();
  std::vector<Facet> facets;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    const DrawnSurface& surface = surfaces[s];
    for (int t = 0; t < static_cast<int>(surface.triangles.cols()); ++t) {
      const Eigen::Matrix3d corners = surface.positions(Eigen::all, surface.triangles.col(t));
      if (!corners.allFinite()) continue;
      Eigen::Vector2d least = Eigen::Vector2d::Constant(INFINITY), most = -least;
      bool is_shown = true;
      for (const auto& corner : corners.colwise()) {
        const auto pixel = camera.project(corner);
        is_shown = is_shown && pixel;
        if (!is_shown) break;
        least = least.cwiseMin(*pixel);
        most = most.cwiseMax(*pixel);
      }
      // A lens bends edges a little beyond the corners.
      const Eigen::Vector2d from = least.array() - 2, to = most.array() + 2;
      if (!is_shown || (to.array() < 0).any() || (from.array() >= size.array()).any()) continue;
      const Eigen::Matrix3d own = (turn * corners).colwise() + camera.pose.translation;
      const Eigen::Vector3d normal =
          (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0));
      facets.push_back({static_cast<int>(s), t, own.col(0), own.col(1) - own.col(0),
                        own.col(2) - own.col(0), from.cwiseMax(0).cast<int>(),
                        to.cwiseMin(size.array().matrix() - Eigen::Vector2d::Ones()).cast<int>(),
                        light_on(normal, options),
                        surface.gloss > 0
                            ? surface.gloss * shine_on(normal, centre - corners.col(0), options)
                            : 0});
    }
  }
  return facets;
}

/// Draws some rows: every sample of every pixel takes the nearest facet.
class RowDrawing {
 public:
  RowDrawing(const PixelCorners& corners, const std::vector<DrawnSurface>& surfaces,
             const ViewOptions& options, int first_row, int rows, int columns)
      : corners_(corners),
        surfaces_(surfaces),
        options_(options),
        first_row_(first_row),
        rows_(rows),
        columns_(columns),
        side_(options.samples) {
    const auto samples =
        static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns * side_ * side_);
    nearest_.resize(samples);
    facet_.resize(samples, nullptr);
  }

  void add(const Facet& facet) {
    const int from = std::max(facet.from.y(), first_row_);
    const int to = std::min(facet.to.y(), first_row_ + rows_ - 1);
    for (int row = from; row <= to; ++row) {
      for (int column = facet.from.x(); column <= facet.to.x(); ++column) {
        for (int k = 0; k < side_ * side_; ++k) {
          const auto met = meeting_of(facet, direction(row, column, k));
          const std::size_t i = index(row, column, k);
          if (!met || !(met->depth < nearest_[i].depth)) continue;
          nearest_[i] = *met;
          facet_[i] = &facet;
        }
      }
    }
  }

  float pixel(int row, int column) const {
    double sum = 0;
    for (int k = 0; k < side_ * side_; ++k) sum += brightness(index(row, column, k));
    return static_cast<float>(sum / (side_ * side_));
  }

 private:
  // No two samples of a pixel are in a line along rows or columns, nor are those of pixels along an
  // edge: edges along these would move by steps of a sample.
  Eigen::Vector3d direction(int row, int column, int k) const {
    const int right = k % side_, down = k / side_;
    const double step = 1.0 / (side_ * side_);
    return corners_.direction(row, column, (right * side_ + down + part(row)) * step,
                              (down * side_ + right + part(column)) * step);
  }
  /// Of a number: between 0 and 1, and those of numbers in a row evenly spread (golden ratio).
  static double part(int number) {
    const double along = number / std::numbers::phi;
    return along - std::floor(along);
  }
  std::size_t index(int row, int column, int k) const {
    return static_cast<std::size_t>(((row - first_row_) * columns_ + column) * side_ * side_ + k);
  }
  double brightness(std::size_t i) const {
    if (!facet_[i]) return options_.background;
    const Facet& facet = *facet_[i];
    const DrawnSurface& surface = surfaces_[static_cast<std::size_t>(facet.surface)];
    const Eigen::Vector3i corners = surface.triangles.col(facet.triangle);
    const Eigen::Vector3d weights(1 - nearest_[i].first - nearest_[i].second, nearest_[i].first,
                                  nearest_[i].second);
    return facet.light * surface.brightness(surface.places(Eigen::all, corners) * weights) +
           facet.shine;
  }

  const PixelCorners& corners_;
  const std::vector<DrawnSurface>& surfaces_;
  const ViewOptions& options_;
  int first_row_, rows_, columns_, side_;
  std::vector<Meeting> nearest_;
  std::vector<const Facet*> facet_;
};

/// A spot of normal shape, pixel by pixel.
GreyPicture blurred(const GreyPicture& picture, double sd) {
  if (!(sd > 0)) return picture;
  const int reach = static_cast<int>(std::ceil(4 * sd));
  Eigen::ArrayXf weights(2 * reach + 1);
  for (int i = -reach; i <= reach; ++i) {
    weights(i + reach) = static_cast<float>(std::exp(-i * i / (2 * sd * sd)));
  }
  weights /= weights.sum();
  const auto along_rows = [&](const GreyPicture& from) {
    GreyPicture to(from.rows(), from.cols());
    const auto last = static_cast<int>(from.cols()) - 1;
    parallel_for(static_cast<int>(from.rows()), [&](int row) {
      for (int column = 0; column <= last; ++column) {
        float sum = 0;
        for (int i = -reach; i <= reach; ++i) {
          sum += weights(i + reach) * from(row, std::clamp(column + i, 0, last));
        }
        to(row, column) = sum;
      }
    });
    return to;
  };
  return along_rows(along_rows(picture.transpose()).transpose());
}

}  // namespace

DrawnSurface flat_rectangle(const Eigen::AlignedBox2d& box, double height,
                            std::function<double(const Eigen::Vector2d& place)> brightness) {
  const Eigen::Vector2d least = box.min(), most = box.max();
  DrawnSurface surface;
  surface.positions.resize(3, 4);
  surface.positions << least.x(), most.x(), most.x(), least.x(), least.y(), least.y(), most.y(),
      most.y(), height, height, height, height;
  surface.triangles.resize(3, 2);
  surface.triangles << 0, 0, 1, 2, 2, 3;
  surface.places = surface.positions.topRows<2>();
  surface.brightness = std::move(brightness);
  return surface;
}

GreyPicture draw_view(const CameraModel& camera, const std::vector<DrawnSurface>& surfaces,
                      const ViewOptions& options) {
  constexpr int kBand = 16;  // rows that are drawn at once
  const PixelCorners corners(camera);
  const std::vector<Facet> facets = facets_of(camera, surfaces, options);
  GreyPicture picture(camera.rows, camera.columns);
  parallel_for((camera.rows + kBand - 1) / kBand, [&](int band) {
    const int first = kBand * band, rows = std::min(kBand, camera.rows - first);
    RowDrawing drawing(corners, surfaces, options, first, rows, camera.columns);
    for (const Facet& facet : facets) {
      if (facet.from.y() < first + rows && facet.to.y() >= first) drawing.add(facet);
    }
    for (int row = first; row < first + rows; ++row) {
      for (int column = 0; column < camera.columns; ++column) {
        picture(row, column) = drawing.pixel(row, column);
      }
    }
  });
  return blurred(picture, options.blur);
}

void add_chip_noise(GreyPicture& picture, const ChipNoise& noise, RandomStream& random) {
  const double levels = std::pow(2.0, noise.bits) - 1;
  for (float& pixel : picture.reshaped<Eigen::RowMajor>()) {
    const double bright = std::max(static_cast<double>(pixel), 0.0);
    const double sd = std::hypot(noise.read, noise.shot * std::sqrt(bright));
    const double level = std::round((bright + sd * random.normal()) * levels);
    pixel = static_cast<float>(std::clamp(level, 0.0, levels) / levels);
  }
}

}  // namespace pliant
