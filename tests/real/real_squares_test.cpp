// A photograph of a sheet with nine black squares of 5 cm (Garcia-Camacho et al. 2024); skipped
// where PLIANT_TEST_DATA does not hold it. The line it prints is that of the documentation.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "pliant/capture/plane_fit.h"
#include "pliant/capture/tag_edges.h"
#include "pliant/imaging/photo.h"

#include "real/real_fit.h"

namespace pliant::test {
namespace {

constexpr double kSide = 0.05;  // m, as their makers print them
constexpr int kSquares = 9;

using Corners = Eigen::Matrix<double, 2, 4>;

/// Corners of what is dark, large and has four, to a pixel or two.
std::vector<Corners> dark_quadrilaterals(const GreyPicture& picture) {
  constexpr double kLeastArea = 1e4, kRounding = 0.03;  // pixels^2, of the outline
  const Eigen::Array<unsigned char, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> levels =
      (255 * picture).cast<unsigned char>();
  const cv::Mat grey(static_cast<int>(picture.rows()), static_cast<int>(picture.cols()), CV_8U,
                     const_cast<unsigned char*>(levels.data()));
  cv::Mat dark;
  cv::threshold(grey, dark, 0, 255, cv::THRESH_BINARY_INV | cv::THRESH_OTSU);
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(dark, outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  std::vector<Corners> found;
  for (const std::vector<cv::Point>& outline : outlines) {
    std::vector<cv::Point> corners;
    cv::approxPolyDP(outline, corners, kRounding * cv::arcLength(outline, true), true);
    if (corners.size() != 4 || cv::contourArea(corners) < kLeastArea) continue;
    Corners& square = found.emplace_back();
    for (Eigen::Index k = 0; k < 4; ++k) {
      const cv::Point& corner = corners[static_cast<std::size_t>(k)];
      square.col(k) << corner.x, corner.y;
    }
  }
  return found;
}

// What their codes are is no matter: their outlines are found as those of tags are.
TEST(RealSquares, OfAPhotographedSheetHaveOneSide) {
  const auto file = measurement("cloth_drape_photos/EOS_aruco_scale.jpg");
  SKIP_WITHOUT(file);
  const GreyPicture picture = read_photo(file);
  Corners upright;
  upright << 0, kSide, kSide, 0, 0, 0, kSide, kSide;
  std::vector<LabelSighting> squares;
  for (const Corners& corners : dark_quadrilaterals(picture)) {
    const int number = static_cast<int>(squares.size());
    squares.push_back({upright, corners_by_edges(picture, corners).corners, number});
  }
  ASSERT_EQ(std::ssize(squares), kSquares);

  // The view of the plane in which all are alike, wherever they lie in it.
  const PlaneFit plane = fit_plane(squares, kSquares);
  const Eigen::Matrix3d to_plane = plane.to_picture.inverse();
  std::vector<double> sides, means;
  for (const LabelSighting& square : squares) {
    const Corners in_plane =
        (to_plane * square.seen.colwise().homogeneous()).colwise().hnormalized();
    for (Eigen::Index k = 0; k < 4; ++k) {
      sides.push_back((in_plane.col((k + 1) % 4) - in_plane.col(k)).norm() / kSide);
    }
    means.push_back(std::reduce(sides.end() - 4, sides.end()) / 4);
  }
  double off = 0;
  for (const double side : sides) off = std::max(off, std::abs(side - 1));
  const auto [smallest, largest] = std::ranges::minmax(means);
  fmt::print(
      "{} squares, {:.3f} mm a pixel: sides are within {:.2f} % of 5 cm, squares (mean of four "
      "sides) differ by {:.2f} % at most; corners miss the plane by {:.2f} px\n",
      squares.size(), 1e3 * kSide / (squares[0].seen.col(1) - squares[0].seen.col(0)).norm(),
      100 * off, 100 * (largest - smallest), plane.miss);
  EXPECT_LT(off, 0.01);
  EXPECT_LT(largest - smallest, 0.01);
}

}  // namespace
}  // namespace pliant::test
