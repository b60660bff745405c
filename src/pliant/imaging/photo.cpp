#include "pliant/imaging/photo.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "pliant/base/errors.h"
#include "pliant/imaging/deep_picture.h"

namespace pliant {
namespace {

constexpr double kLevels = 255;

/// Its colours, where they stand.
cv::Mat matrix_of(ColourPhoto& photo) {
  return {photo.rows, photo.columns, CV_8UC3, photo.levels.data()};
}

// In 1/16 of a pixel.
cv::Point in_sixteenths(const Eigen::Vector2d& point) {
  return {static_cast<int>(std::lround(16 * point.x())),
          static_cast<int>(std::lround(16 * point.y()))};
}

int stroke_of(const cv::Mat& picture) {
  return std::max(1, std::max(picture.cols, picture.rows) / 1000);
}

// Halfway to white, so that colours stand out from it.
void make_paler(cv::Mat picture) { picture.convertTo(picture, -1, 0.5, kLevels / 2); }

}  // namespace

Photo read_photo(const std::filesystem::path& file) {
  if (auto deep = read_deep_picture(file)) return *std::move(deep);
  ColourPhoto colours = read_shallow_picture(file);
  cv::Mat levels;
  cv::cvtColor(matrix_of(colours), levels, cv::COLOR_BGR2GRAY);
  Photo photo(levels.rows, levels.cols);
  cv::Mat brightness(levels.rows, levels.cols, CV_32F, photo.data());
  levels.convertTo(brightness, CV_32F, 1 / kLevels);
  return photo;
}

void require_within(const PixelRegion& region, int columns, int rows, const Location& where) {
  const bool within = region.x >= 0 && region.y >= 0 && region.width > 0 && region.height > 0 &&
                      region.width <= columns - region.x && region.height <= rows - region.y;
  if (within) return;
  throw InputError(where,
                   fmt::format("the region of {} x {} pixels at {},{} is not within the picture",
                               region.width, region.height, region.x, region.y),
                   fmt::format("a region of its {} x {} pixels", columns, rows));
}

ColourPhoto read_colours(const std::filesystem::path& file,
                         const std::optional<PixelRegion>& region) {
  ColourPhoto whole = read_picture(file);
  if (!region) return whole;
  require_within(*region, whole.columns, whole.rows, {file.string()});
  const cv::Mat part =
      matrix_of(whole)({region->x, region->y, region->width, region->height}).clone();
  return {part.rows, part.cols, {part.datastart, part.dataend}};
}

std::string photo_with_line(const std::filesystem::path& file,
                            const std::vector<Eigen::Vector2d>& line) {
  constexpr int kSixteenths = 4;  // bits of a fraction
  ColourPhoto photo = read_picture(file);
  const cv::Mat picture = matrix_of(photo);
  const int stroke = stroke_of(picture);
  const cv::Scalar line_colour(60, 110, 255), point_colour(60, 220, 255);  // blue, green, red
  std::vector<cv::Point> points;
  for (const Eigen::Vector2d& point : line) points.push_back(in_sixteenths(point));
  cv::polylines(picture, points, /*isClosed=*/false, line_colour, stroke, cv::LINE_AA, kSixteenths);
  for (const cv::Point& point : points) {
    cv::circle(picture, point, 16 * 3 * stroke, point_colour, stroke, cv::LINE_AA, kSixteenths);
  }
  return png_of(photo);
}

std::string photo_with_outline(const std::filesystem::path& file,
                               const std::vector<Eigen::Vector2d>& outline,
                               const Eigen::Vector2d& cross) {
  constexpr int kSixteenths = 4;  // bits of a fraction
  ColourPhoto photo = read_picture(file);
  const cv::Mat picture = matrix_of(photo);
  const cv::Scalar colour(60, 110, 255);  // blue, green, red
  const int stroke = 2 * stroke_of(picture);
  std::vector<cv::Point> points;
  for (const Eigen::Vector2d& point : outline) points.push_back(in_sixteenths(point));
  cv::polylines(picture, points, /*isClosed=*/true, colour, stroke, cv::LINE_AA, kSixteenths);
  const cv::Point middle(static_cast<int>(std::lround(cross.x())),
                         static_cast<int>(std::lround(cross.y())));
  cv::drawMarker(picture, middle, colour, cv::MARKER_CROSS, 20 * stroke, stroke, cv::LINE_AA);
  return png_of(photo);
}

std::string photo_as_seen(const std::filesystem::path& file, const SeenPixels& seen, int x, int y) {
  ColourPhoto photo = read_picture(file);
  const cv::Mat picture = matrix_of(photo);
  make_paler(picture);
  const cv::Rect region(x, y, static_cast<int>(seen.cols()), static_cast<int>(seen.rows()));
  cv::Mat part = picture(region);
  part.forEach<cv::Vec3b>([&](cv::Vec3b& pixel, const int* at) {
    const Seen what = seen(at[0], at[1]);
    if (what == Seen::standing_out) pixel = {200, 120, 40};  // blue, green, red
    if (what == Seen::candidate) pixel = {0, 110, 255};
  });
  cv::rectangle(picture, region, cv::Scalar(200, 120, 40), stroke_of(picture));
  return png_of(photo);
}

}  // namespace pliant
