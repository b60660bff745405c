// Pictures of a temple of plaster by calibrated cameras on a ring (Seitz et al. 2006), whose shape
// is not public; skipped where PLIANT_TEST_DATA does not hold them. The lines they print are those
// of the documentation.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/capture/median.h"
#include "pliant/capture/stereo_rest.h"
#include "pliant/imaging/photo.h"
#include "pliant/io/text_file.h"

#include "real/real_fit.h"

namespace pliant::test {
namespace {

constexpr double kPixel = 0.38e-3;  // on the temple (m)

/// A camera of the temple and what it sees.
struct TempleView {
  CameraModel camera;
  GreyPicture picture;
};

/// By rows of name, K, R, t.
std::vector<TempleView> temple_views(const std::filesystem::path& folder) {
  std::istringstream text(read_text_file(folder / "templeSR_par.txt"));
  std::size_t count = 0;
  text >> count;
  std::vector<TempleView> views(count);
  for (auto& [camera, picture] : views) {
    std::string name;
    Eigen::Matrix<double, 3, 3, Eigen::RowMajor> k, r;
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    text >> name;
    for (double& number : k.reshaped<Eigen::RowMajor>()) text >> number;
    for (double& number : r.reshaped<Eigen::RowMajor>()) text >> number;
    pose.linear() = r;
    for (double& number : pose.translation()) text >> number;
    camera.intrinsics << k(0, 0), k(1, 1), k(0, 2), k(1, 2), 0, 0, 0, 0, 0;
    camera.pose = RigidMotion::of(pose);
    camera.columns = 640;
    camera.rows = 480;
    picture = read_photo(folder / name);
  }
  return views;
}

/// Numbers of a picture and of those whose cameras stood some 23 degrees away on either side of it
/// (12 and 16: 31 degrees from each other): all that have two such. The gantry stood otherwise for
/// 12 to 16, upside down: each picture has neighbours of its own kind.
constexpr std::array<std::array<std::size_t, 3>, 8> kNeighbours{{{4, 3, 5},
                                                                 {7, 6, 8},
                                                                 {8, 7, 9},
                                                                 {9, 8, 10},
                                                                 {10, 9, 11},
                                                                 {11, 10, 2},
                                                                 {12, 13, 16},
                                                                 {16, 12, 15}}};

/// What three neighbours see, the one between them first.
struct SeenTemple {
  std::vector<CameraModel> cameras;
  std::vector<RestPoint> points;
};

std::vector<SeenTemple> seen_temple(const std::filesystem::path& folder) {
  const std::vector<TempleView> views = temple_views(folder);
  Quadrilateral all;
  all << 8, 631, 631, 8, 8, 8, 471, 471;
  RunContext context;
  context.threads = 2;
  std::vector<SeenTemple> seen;
  for (const auto& numbers : kNeighbours) {
    SeenTemple& temple = seen.emplace_back();
    std::vector<GreyPicture> pictures;
    for (const std::size_t number : numbers) {
      temple.cameras.push_back(views[number - 1].camera);
      pictures.push_back(views[number - 1].picture);
    }
    temple.points = match_rest(temple.cameras, pictures, all, {7, 5}, context).points;
  }
  return seen;
}

TEST(RealSlowTemple, NeighboursAgree) {
  const std::filesystem::path folder = measurement("multiview_templeSparseRing");
  SKIP_WITHOUT(folder);
  std::vector<double> apart, misses;
  std::size_t points = 0, views = 0;
  for (const auto& [cameras, seen] : seen_temple(folder)) {
    points += seen.size();
    views += !seen.empty();
    for (const RestPoint& point : seen) {
      if (!point.seen[1] || !point.seen[2]) continue;
      const auto left =
          agreed_point(cameras, {point.seen[0], point.seen[1], std::nullopt}, INFINITY);
      const auto right =
          agreed_point(cameras, {point.seen[0], std::nullopt, point.seen[2]}, INFINITY);
      if (!left || !right) continue;
      apart.push_back((left->position - right->position).norm() / kPixel);
      misses.push_back(point.agreed.miss);
    }
  }
  fmt::print(
      "temple: {} of {} views; {} points by two cameras or three, {} by three; both pairs put one "
      "{:.2f} px apart in the median, lines of sight miss by {:.2f} px\n",
      views, kNeighbours.size(), points, apart.size(), median(apart), median(misses));
  EXPECT_GE(views, kNeighbours.size() - 1);  // nothing is found of 4, which sees it from the side
  EXPECT_GT(apart.size(), 4000u);
  EXPECT_LT(median(apart), 1);
}

Eigen::Matrix3Xd side_by_side(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Matrix3Xd columns(3, std::ssize(points));
  for (Eigen::Index i = 0; i < columns.cols(); ++i) {
    columns.col(i) = points[static_cast<std::size_t>(i)];
  }
  return columns;
}

/// The points of COLMAP's points3D.txt (m).
Eigen::Matrix3Xd colmap_points(const std::filesystem::path& file) {
  std::istringstream text(read_text_file(file));
  std::vector<Eigen::Vector3d> points;
  for (std::string line; std::getline(text, line);) {
    std::istringstream row(line);
    int number = 0;
    Eigen::Vector3d point;
    if (row >> number >> point.x() >> point.y() >> point.z()) points.push_back(point);
  }
  return side_by_side(points);
}

/// How far a place is off the plane through the points around it; nothing where they are too few.
std::optional<double> off_surface(const Eigen::Matrix3Xd& points, const Eigen::Vector3d& place) {
  constexpr double kReach = 8 * kPixel;
  constexpr std::ptrdiff_t kFewest = 6;
  std::vector<Eigen::Index> near;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    if ((points.col(i) - place).squaredNorm() < kReach * kReach) near.push_back(i);
  }
  if (std::ssize(near) < kFewest) return std::nullopt;
  const Eigen::Matrix3Xd around = points(Eigen::all, near);
  const Eigen::Vector3d middle = around.rowwise().mean();
  const Eigen::Matrix3Xd centred = around.colwise() - middle;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread(centred * centred.transpose());
  return std::abs(spread.eigenvectors().col(0).dot(place - middle));
}

// COLMAP's points stand in the folder PLIANT_COLMAP, which temple_by_colmap.sh makes.
TEST(RealSlowTemple, LiesWhereColmapPutsIt) {
  const std::filesystem::path folder = measurement("multiview_templeSparseRing");
  SKIP_WITHOUT(folder);
  const char* colmap = std::getenv("PLIANT_COLMAP");
  if (!colmap) GTEST_SKIP() << "PLIANT_COLMAP names no folder with COLMAP's points3D.txt";
  std::vector<Eigen::Vector3d> all;
  for (const SeenTemple& temple : seen_temple(folder)) {
    for (const RestPoint& point : temple.points) all.push_back(point.agreed.position);
  }
  const Eigen::Matrix3Xd points = side_by_side(all);
  const Eigen::Matrix3Xd theirs = colmap_points(std::filesystem::path(colmap) / "points3D.txt");
  std::vector<double> distances;
  for (const auto& place : theirs.colwise()) {
    if (const auto off = off_surface(points, place)) distances.push_back(*off);
  }
  ASSERT_GT(distances.size(), 300u);
  const auto near = std::ranges::count_if(distances, [](double off) { return off < kPixel; });
  fmt::print(
      "temple: {} of COLMAP's {} points lie {:.2f} mm ({:.2f} px) off the surface through ours in "
      "the median, {:.0f} % of them less than a pixel\n",
      distances.size(), theirs.cols(), 1e3 * median(distances), median(distances) / kPixel,
      100.0 * static_cast<double>(near) / static_cast<double>(distances.size()));
  EXPECT_LT(median(distances), kPixel);
}

}  // namespace
}  // namespace pliant::test
