#include "pliant/imaging/drape_photo.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "pliant/base/assert.h"
#include "pliant/imaging/drape_mask.h"
#include "pliant/imaging/refused_photo.h"

namespace pliant {
namespace {

// A mask within its photograph.
class Placed {
 public:
  Placed(DrapeMask mask, const std::optional<PixelRegion>& region)
      : mask_(std::move(mask)), corner_(region ? region->x : 0, region ? region->y : 0) {}

  // Pixels are squares: the middle of the first one of the photograph is (0, 0).
  Eigen::Vector2d to_photo(const Eigen::Vector2d& pixel) const {
    return corner_ + (mask_.pixel * (pixel.array() + 0.5) - 0.5).matrix();
  }
  Eigen::Vector2d from_photo(const Eigen::Vector2d& pixel) const {
    return ((pixel - corner_).array() + 0.5).matrix() / mask_.pixel -
           Eigen::Vector2d::Constant(0.5);
  }
  cv::Mat inside() {
    return {static_cast<int>(mask_.inside.rows()), static_cast<int>(mask_.inside.cols()), CV_8U,
            mask_.inside.data()};
  }
  double pixel() const { return mask_.pixel; }

 private:
  DrapeMask mask_;
  Eigen::Vector2d corner_;
};

// The largest circle within a mask, in its pixels.
struct Circle {
  Eigen::Vector2d middle;
  double radius = 0;
};

Circle largest_circle(const cv::Mat& inside) {
  cv::Mat distance;
  cv::distanceTransform(inside, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  cv::Point middle;
  double radius = 0;
  cv::minMaxLoc(distance, nullptr, &radius, nullptr, &middle);
  return {{middle.x, middle.y}, radius};
}

std::vector<cv::Point> outline_of(const cv::Mat& inside) {
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(inside, outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  return *std::ranges::max_element(outlines, {}, [](const auto& line) { return line.size(); });
}

// The outermost point along each angle, counter-clockwise from the picture's right: the outline is
// closer together than the angles are.
std::vector<double> radii_of(const cv::Mat& inside, const Eigen::Vector2d& middle) {
  const double reach = std::hypot(inside.cols, inside.rows);
  std::vector<double> radii(kSilhouetteAngles, 0);
  for (int i = 0; i < kSilhouetteAngles; ++i) {
    const double angle = 2 * std::numbers::pi * i / kSilhouetteAngles;
    for (double radius = reach; radius > 0; radius -= 0.5) {
      const long x = std::lround(middle.x() + radius * std::cos(angle));
      const long y = std::lround(middle.y() - radius * std::sin(angle));
      if (x < 0 || y < 0 || x >= inside.cols || y >= inside.rows) continue;
      if (inside.at<unsigned char>(static_cast<int>(y), static_cast<int>(x)) == 0) continue;
      radii[static_cast<std::size_t>(i)] = radius;
      break;
    }
  }
  return radii;
}

void require_disc(double radius, const DrapePhotoOptions& options, const Location& where) {
  constexpr double kLess = 0.95;
  if (2 * radius > kLess * options.disc) return;
  throw InputError(where,
                   fmt::format("the largest circle within the silhouette has {:.0f} mm, the disc "
                               "below it {:.0f} mm",
                               2e3 * radius, 1e3 * options.disc),
                   "the scale at the specimen's height, the disc's diameter, and all of the "
                   "specimen in one colour");
}

void require_inside(const Eigen::Vector2d& middle, const cv::Mat& inside, const Location& where) {
  const cv::Rect picture(0, 0, inside.cols, inside.rows);
  const cv::Point pixel(static_cast<int>(std::lround(middle.x())),
                        static_cast<int>(std::lround(middle.y())));
  if (picture.contains(pixel) && inside.at<unsigned char>(pixel) > 0) return;
  throw InputError(where, "the disc's middle is not within the silhouette",
                   "the pixel X,Y of its middle, from the upper left of the photograph");
}

}  // namespace

DrapeTrace trace_drape(const std::filesystem::path& file, const DrapePhotoOptions& options) {
  PLIANT_ASSERT(options.scale > 0 && options.disc > 0, "pixels and discs have a size");
  const Location where{file.string()};
  const ColourPhoto photo = read_colours(file, options.region);
  const auto mask = [&] {
    try {
      return find_drape(photo, where);
    } catch (const InputError& error) {
      const PixelRegion at = options.region.value_or(PixelRegion{});
      throw RefusedPhoto(error, photo_as_seen(file, drape_seen(photo), at.x, at.y));
    }
  };
  Placed placed(mask(), options.region);
  const cv::Mat inside = placed.inside();
  const double length = options.scale * placed.pixel();
  const Circle circle = largest_circle(inside);
  require_disc(length * circle.radius, options, where);

  const Eigen::Vector2d middle =
      options.middle ? placed.from_photo(*options.middle) : circle.middle;
  require_inside(middle, inside, where);
  DrapeTrace trace;
  trace.middle = placed.to_photo(middle);
  trace.silhouette.area = length * length * cv::countNonZero(inside);
  trace.silhouette.radii = radii_of(inside, middle);
  for (double& radius : trace.silhouette.radii) radius *= length;
  for (const cv::Point& point : outline_of(inside)) {
    trace.outline.push_back(placed.to_photo({point.x, point.y}));
  }
  return trace;
}

}  // namespace pliant
