#include "imaging/drawn_strip.h"

#include <cmath>
#include <fstream>
#include <stdexcept>

#include <opencv2/imgproc.hpp>

#include "pliant/imaging/picture_file.h"
#include "pliant/material/bending_strain.h"
#include "pliant/solver/elastica/strip_release.h"

namespace pliant::test {
namespace {

constexpr int kFiner = 4;  // drawn so much finer, then averaged

cv::Point finer(const Eigen::Vector2d& pixel) {
  // The centre of a pixel stands in the middle of its finer ones.
  const auto at = [](double p) { return static_cast<int>(std::lround((p + 0.5) * kFiner - 0.5)); };
  return {at(pixel.x()), at(pixel.y())};
}

// The band around a line, cut off square at its ends.
std::vector<cv::Point> band(const std::vector<Eigen::Vector2d>& line, double thickness) {
  std::vector<cv::Point> one, other;
  for (size_t i = 0; i < line.size(); ++i) {
    const Eigen::Vector2d along =
        (line[std::min(i + 1, line.size() - 1)] - line[i > 0 ? i - 1 : 0]).normalized();
    const Eigen::Vector2d across(-along.y() * thickness / 2, along.x() * thickness / 2);
    one.push_back(finer(line[i] + across));
    other.push_back(finer(line[i] - across));
  }
  one.insert(one.end(), other.rbegin(), other.rend());
  return one;
}

void write_grey(const std::filesystem::path& file, const cv::Mat& grey) {
  ColourPhoto photo{grey.rows, grey.cols, std::vector<unsigned char>(3 * grey.total())};
  cv::Mat colours(grey.rows, grey.cols, CV_8UC3, photo.levels.data());
  cv::cvtColor(grey, colours, cv::COLOR_GRAY2BGR);
  std::ofstream(file, std::ios::binary) << png_of(photo);
}

}  // namespace

std::vector<Eigen::Vector2d> elastic_profile(double rigidity, double weight, double length) {
  constexpr int kPoints = 400;
  ComponentLaw law;
  law.stiffness = ScalarCurve::constant(rigidity / kStrainPerCurvature);
  const Elastica strip(length, 24);
  StripHistory history = strip.rested(law);
  const auto shape = released(strip, law, weight, {}, /*with_derivatives=*/false, history);
  if (!shape) throw std::invalid_argument("no equilibrium");
  const StripProfile profile = strip.profile({}, *shape);
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i <= kPoints; ++i) points.push_back(profile.at(length * i / kPoints).position);
  return points;
}

void draw_strips(const std::filesystem::path& file,
                 const std::vector<std::vector<Eigen::Vector2d>>& profiles, const DrawnStrip& look,
                 double apart) {
  cv::Mat fine = cv::Mat::zeros(kFiner * look.height, kFiner * look.width, CV_32F);
  for (size_t i = 0; i < profiles.size(); ++i) {
    std::vector<Eigen::Vector2d> line;
    for (const Eigen::Vector2d& point : profiles[i]) {
      line.emplace_back(
          look.clamp.x() + look.pixels_per_metre * point.x(),
          look.clamp.y() + apart * static_cast<double>(i) - look.pixels_per_metre * point.y());
    }
    cv::fillPoly(fine, std::vector<std::vector<cv::Point>>{band(line, look.thickness)}, 1);
  }
  cv::Mat cover, photo(look.height, look.width, CV_32F), grain(look.height, look.width, CV_32F);
  cv::resize(fine, cover, photo.size(), 0, 0, cv::INTER_AREA);
  for (int y = 0; y < look.height; ++y) {
    for (int x = 0; x < look.width; ++x) {
      const double corner =
          (static_cast<double>(x) / look.width + static_cast<double>(y) / look.height) / 2;
      const double share = static_cast<double>(cover.at<float>(y, x));
      photo.at<float>(y, x) = static_cast<float>((1 - share) * look.background +
                                                 share * look.strip + look.gradient * corner);
    }
  }
  cv::RNG(11).fill(grain, cv::RNG::NORMAL, 0, look.noise);
  photo += grain;
  if (look.mirrored) cv::flip(photo, photo, 1);
  photo.convertTo(photo, CV_8U, 255);
  write_grey(file, photo);
}

void draw_shadow(const std::filesystem::path& file, int column, double share) {
  ColourPhoto photo = read_picture(file);
  cv::Mat picture(photo.rows, photo.columns, CV_8UC3, photo.levels.data());
  picture.colRange(column, photo.columns) *= share;
  std::ofstream(file, std::ios::binary) << png_of(photo);
}

void draw_fibres(const std::filesystem::path& file, const std::vector<Eigen::Vector2d>& pixels) {
  ColourPhoto photo = read_picture(file);
  cv::Mat picture(photo.rows, photo.columns, CV_8UC3, photo.levels.data());
  for (size_t i = 2; i < pixels.size(); i += 3) {
    const int side = i % 2 == 0 ? 1 : -1;
    const cv::Point from(cvRound(pixels[i].x()), cvRound(pixels[i].y()));
    const cv::Point to(from.x + 12, from.y + side * 25);
    cv::line(picture, from, to, cv::Scalar::all(210), 1, cv::LINE_AA);
  }
  std::ofstream(file, std::ios::binary) << png_of(photo);
}

}  // namespace pliant::test
