// Pictures of several calibrated cameras whose shape, or whose agreement, is known; skipped where
// PLIANT_TEST_DATA does not hold them. The lines they print are those of the documentation.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/capture/median.h"
#include "pliant/capture/stereo_rest.h"
#include "pliant/imaging/photo.h"
#include "pliant/io/text_file.h"

#include "real/real_fit.h"

namespace pliant::test {
namespace {

/// The cameras of the temple: name, K, R, t of each.
std::vector<CameraModel> temple_cameras(const std::filesystem::path& folder) {
  std::istringstream text(read_text_file(folder / "templeSR_par.txt"));
  int count = 0;
  text >> count;
  std::vector<CameraModel> cameras;
  for (int i = 0; i < count; ++i) {
    std::string name;
    Eigen::Matrix<double, 3, 3, Eigen::RowMajor> k, r;
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    text >> name;
    for (double& number : k.reshaped<Eigen::RowMajor>()) text >> number;
    for (double& number : r.reshaped<Eigen::RowMajor>()) text >> number;
    pose.linear() = r;
    for (double& number : pose.translation()) text >> number;
    CameraModel camera;
    camera.intrinsics << k(0, 0), k(1, 1), k(0, 2), k(1, 2), 0, 0, 0, 0, 0;
    camera.pose = RigidMotion::of(pose);
    camera.columns = 640;
    camera.rows = 480;
    cameras.push_back(camera);
  }
  return cameras;
}

TEST(RealStereo, NeighboursOfTheTempleAgree) {
  const std::filesystem::path folder = measurement("multiview_templeSparseRing");
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no measurements at " << folder;
  constexpr double kPixel = 0.38e-3;  // on the temple (m)
  const std::vector<CameraModel> cameras = temple_cameras(folder);
  std::vector<GreyPicture> pictures;
  for (int i = 1; i <= 16; ++i) {
    pictures.push_back(read_photo(folder / fmt::format("templeSR{:04}.png", i)));
  }
  Quadrilateral all;
  all << 8, 631, 631, 8, 8, 8, 471, 471;
  std::vector<double> apart, misses;
  int points = 0;
  constexpr std::size_t kEvery = 7;
  for (std::size_t i = 1; i + 1 < cameras.size(); i += kEvery) {
    const std::vector<CameraModel> three{cameras[i], cameras[i - 1], cameras[i + 1]};
    const StereoRest rest =
        match_rest(three, {pictures[i], pictures[i - 1], pictures[i + 1]}, all, {7, 5}, {});
    for (const RestPoint& point : rest.points) {
      ++points;
      if (!point.seen[1] || !point.seen[2]) continue;
      const auto left = agreed_point(three, {point.seen[0], point.seen[1], std::nullopt}, INFINITY);
      const auto right =
          agreed_point(three, {point.seen[0], std::nullopt, point.seen[2]}, INFINITY);
      if (!left || !right) continue;
      apart.push_back((left->position - right->position).norm() / kPixel);
      misses.push_back(point.agreed.miss);
    }
  }
  fmt::print(
      "temple: {} points by two cameras or three, {} by three; both pairs put one {:.2f} px apart "
      "in the median, lines of sight miss by {:.2f} px\n",
      points, apart.size(), median(apart), median(misses));
  EXPECT_GT(apart.size(), 200u);
  EXPECT_LT(median(apart), 1);
}

/// The floats of an uncompressed picture, row by row.
Eigen::ArrayXXf disparities(const std::filesystem::path& file, int columns, int rows) {
  const std::string bytes = read_text_file(file);
  Eigen::Array<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> values(rows, columns);
  const std::size_t size = sizeof(float) * static_cast<std::size_t>(values.size());
  std::memcpy(values.data(), bytes.data() + bytes.size() - size, size);
  return values;
}

TEST(RealStereo, DisparitiesOfTheConesAreMet) {
  const std::filesystem::path folder = measurement("stereo_middlebury_cones");
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no measurements at " << folder;
  constexpr int kColumns = 450, kRows = 375;
  // Any camera will do for a pair that is rectified: lines of sight lie in rows.
  CameraModel left, right;
  left.intrinsics << 600, 600, kColumns / 2.0, kRows / 2.0, 0, 0, 0, 0, 0;
  left.columns = kColumns;
  left.rows = kRows;
  right = left;
  right.pose.translation.x() = -0.1;
  const std::vector<GreyPicture> pictures{read_photo(folder / "Cones_LEFT.tif"),
                                          read_photo(folder / "Cones_RIGHT.tif")};
  const Eigen::ArrayXXf truth = disparities(folder / "Cones_LEFT_GT.tif", kColumns, kRows);
  const GreyPicture occluded = read_photo(folder / "Occlusion_LEFT.png");
  Quadrilateral all;
  all << 0, kColumns - 1, kColumns - 1, 0, 0, 0, kRows - 1, kRows - 1;
  for (const int radius : {4, 7}) {
    const StereoRest rest = match_rest({left, right}, pictures, all, {radius, 3}, {});
    int known = 0, matched = 0, close = 0;
    double squares = 0;
    for (const Eigen::Vector2d& place : places_within(all, 3, radius + 1)) {
      const auto row = static_cast<int>(place.y()), column = static_cast<int>(place.x());
      known += truth(row, column) > 0 && occluded(row, column) > 0.5F;
    }
    for (const RestPoint& point : rest.points) {
      const Eigen::Vector2d place = point.seen[0]->pixel;
      const auto row = static_cast<int>(place.y()), column = static_cast<int>(place.x());
      if (!(truth(row, column) > 0 && occluded(row, column) > 0.5F)) continue;
      ++matched;
      const double off = place.x() - point.seen[1]->pixel.x() - truth(row, column);
      if (std::abs(off) > 1) continue;
      ++close;
      squares += off * off;
    }
    fmt::print(
        "cones, patches of {} px: {:.1f} % of {} places matched, {:.1f} % of them within 1 "
        "px, {:.2f} px RMS of these\n",
        2 * radius + 1, 100.0 * matched / known, known, 100.0 * close / matched,
        std::sqrt(squares / close));
    EXPECT_GT(matched, known / 2);
    EXPECT_GT(close, 9 * matched / 10);
  }
}

}  // namespace
}  // namespace pliant::test
