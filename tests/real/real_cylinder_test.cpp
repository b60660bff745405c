// Two cameras that see a cylinder of known marks, and a speckled one that is loaded; skipped where
// PLIANT_TEST_DATA does not hold their pictures. The lines they print are those of the
// documentation.

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <queue>
#include <string>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/capture/chessboard_corners.h"
#include "pliant/capture/match_check.h"
#include "pliant/capture/median.h"
#include "pliant/capture/patch_tracker.h"
#include "pliant/capture/rig_calibration.h"
#include "pliant/capture/stereo_rest.h"
#include "pliant/capture/triangulation.h"
#include "pliant/imaging/photo.h"
#include "pliant/io/csv.h"

#include "real/real_capture.h"
#include "real/real_fit.h"

namespace pliant::test {
namespace {

constexpr double kRadius = 0.057;  // of the cylinder (m)
constexpr int kRows = 20, kColumns = 14;

/// Marks by their number, row by row.
using Marks = std::map<int, Eigen::Vector2d>;

Eigen::Matrix3Xd control_points(const std::filesystem::path& folder) {
  const CsvTable table = read_csv(folder / "object_points_mm.csv");
  Eigen::Matrix3Xd points(3, kRows * kColumns);
  const std::vector<double> x = table.quantity("x", Dimension::length);
  const std::vector<double> y = table.quantity("y", Dimension::length);
  const std::vector<double> z = table.quantity("z", Dimension::length);
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    points.col(i) << x[row], y[row], z[row];
  }
  return points;
}

/// Middles of dark spots of a mark's size on white.
std::vector<Eigen::Vector2d> dark_spots(const GreyPicture& picture) {
  constexpr float kDark = 0.4F, kWhite = 0.6F;
  constexpr int kSmallest = 150, kLargest = 3000, kBeside = 8;
  Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> seen(picture.rows(),
                                                                           picture.cols());
  seen.setConstant(false);
  std::vector<Eigen::Vector2d> spots;
  for (Eigen::Index row = 0; row < picture.rows(); ++row) {
    for (Eigen::Index column = 0; column < picture.cols(); ++column) {
      if (seen(row, column) || picture(row, column) > kDark) continue;
      std::vector<Eigen::Vector2i> pixels;
      std::queue<Eigen::Vector2i> next;
      next.emplace(column, row);
      seen(row, column) = true;
      while (!next.empty()) {
        const Eigen::Vector2i at = next.front();
        next.pop();
        pixels.push_back(at);
        for (const Eigen::Vector2i& step : {Eigen::Vector2i(1, 0), Eigen::Vector2i(-1, 0),
                                            Eigen::Vector2i(0, 1), Eigen::Vector2i(0, -1)}) {
          const Eigen::Vector2i to = at + step;
          if (to.minCoeff() < 0 || to.x() >= picture.cols() || to.y() >= picture.rows()) continue;
          if (seen(to.y(), to.x()) || picture(to.y(), to.x()) > kDark) continue;
          seen(to.y(), to.x()) = true;
          next.push(to);
        }
      }
      if (std::ssize(pixels) < kSmallest || std::ssize(pixels) > kLargest) continue;
      Eigen::AlignedBox2i box;
      for (const Eigen::Vector2i& pixel : pixels) box.extend(pixel);
      box.min().array() -= kBeside;
      box.max().array() += kBeside;
      if (box.min().minCoeff() < 0 || box.max().x() >= picture.cols() ||
          box.max().y() >= picture.rows()) {
        continue;
      }
      const auto around =
          picture.block(box.min().y(), box.min().x(), box.sizes().y() + 1, box.sizes().x() + 1);
      const float white = around.topRows<1>().mean() / 2 + around.bottomRows<1>().mean() / 2;
      if (white < kWhite) continue;
      // By how much darker than white each pixel is: grey rims count in part.
      Eigen::Vector2d sum = Eigen::Vector2d::Zero();
      double weights = 0;
      for (Eigen::Index y = 0; y < around.rows(); ++y) {
        for (Eigen::Index x = 0; x < around.cols(); ++x) {
          const double weight = std::max(0.0F, 0.9F * white - around(y, x));
          sum += weight * Eigen::Vector2d(x, y);
          weights += weight;
        }
      }
      spots.emplace_back(box.min().cast<double>() + sum / weights);
    }
  }
  return spots;
}

/// Marks that a camera sees nearly from the front, each with the spot beside it.
Marks marks_at(const CameraModel& camera, const Eigen::Matrix3Xd& points,
               const std::vector<Eigen::Vector2d>& spots, double reach) {
  constexpr double kFlattest = 0.35;  // cosine of how aside a mark is seen
  Marks marks;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector3d point = points.col(i);
    const Eigen::Vector3d normal(point.x() / kRadius, point.y() / kRadius, 0);
    if (normal.dot((camera.centre() - point).normalized()) < kFlattest) continue;
    const auto pixel = camera.project(point);
    if (!pixel) continue;
    const auto nearest = std::ranges::min_element(
        spots, {}, [&](const Eigen::Vector2d& spot) { return (spot - *pixel).norm(); });
    if (nearest != spots.end() && (*nearest - *pixel).norm() < reach) {
      marks[static_cast<int>(i)] = *nearest;
    }
  }
  return marks;
}

/// Every third mark is left out, and judges.
bool is_left_out(int mark) { return mark % 3 == 0; }

/// Moves a camera to where it sees marks best; the root mean square of a coordinate that is left
/// (pixels).
double place_camera(CameraModel& camera, const Eigen::Matrix3Xd& points, const Marks& marks) {
  double squares = 0;
  int count = 0;
  for (int round = 0; round < 30; ++round) {
    Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Vector<double, 6> right = Eigen::Vector<double, 6>::Zero();
    squares = 0;
    count = 0;
    for (const auto& [number, pixel] : marks) {
      if (is_left_out(number)) continue;
      const Eigen::Vector3d point = points.col(number);
      const auto seen = camera.project_with_derivatives(point);
      if (!seen) continue;
      Eigen::Matrix<double, 3, 6> moves;  // turn, shift of the rig
      moves << 0, point.z(), -point.y(), 1, 0, 0, -point.z(), 0, point.x(), 0, 1, 0, point.y(),
          -point.x(), 0, 0, 0, 1;
      const Eigen::Matrix<double, 2, 6> slope = seen->by_point * moves;
      const Eigen::Vector2d miss = pixel - seen->pixel;
      normal += slope.transpose() * slope;
      right += slope.transpose() * miss;
      squares += miss.squaredNorm();
      count += 2;
    }
    const Eigen::Vector<double, 6> step = normal.ldlt().solve(right);
    camera.pose = camera.pose * RigidMotion{step.head<3>(), step.tail<3>()};
  }
  return std::sqrt(squares / count);
}

constexpr double kColumnAngle = 12.0625 * std::numbers::pi / 180;

double faced_column(const CameraModel& camera) {
  return std::atan2(camera.centre().y(), camera.centre().x()) / kColumnAngle;
}

/// A camera that faces a column of marks, `height` in the middle of its picture.
void begin_before(CameraModel& camera, double column, double height, double distance) {
  const double angle = column * kColumnAngle;
  const Eigen::Vector3d out(std::cos(angle), std::sin(angle), 0);
  Eigen::Matrix3d axes;  // rows: right, down, away
  axes.row(2) = -out;
  axes.row(1) = -Eigen::RowVector3d::UnitZ();
  axes.row(0) = axes.row(1).cross(axes.row(2));
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = axes;
  pose.translation() = -axes * ((kRadius + distance) * out + height * Eigen::Vector3d::UnitZ());
  camera.pose = RigidMotion::of(pose);
}

struct SeenCylinder {
  std::vector<CameraModel> cameras;
  std::vector<Marks> marks;
};

void expect_calibrated(const std::string& name, const RigCalibration& found) {
  const CameraResiduals& camera = found.cameras[0];
  fmt::print(
      "camera {}: {} pictures, RMS {:.3f} px of {} corners, {:.3f} px of all {}; focal length "
      "{:.1f} +- {:.1f} px\n",
      name, camera.pictures, camera.rms, camera.corners, camera.rms_all,
      camera.corners + camera.left_out, found.bundle.cameras[0].intrinsics(0), found.error(0, 0));
  EXPECT_EQ(left_out_pictures(found), 0);
  EXPECT_LT(camera.rms, 0.6);
}

SeenCylinder seen_cylinder(const std::filesystem::path& folder, const Eigen::Matrix3Xd& points) {
  SeenCylinder seen;
  // By the numbers above the columns, the first of which is 1.
  const std::vector<std::pair<std::string, double>> faced{{"201", 5.0}, {"202", 7.5}};
  for (const auto& [name, column] : faced) {
    const RigCalibration found =
        calibrated("{columns: 19, rows: 14, square: 10 mm}", fmt::format("{{c{}: }}", name),
                   fmt::format("{{c{0}: {1}/board_{0}_*.jpg}}", name, folder.string()));
    expect_calibrated(name, found);
    CameraModel camera = found.bundle.cameras[0];
    const auto spots = dark_spots(read_photo(folder / ("object_" + name + ".jpg")));
    double miss = 0;
    Marks marks;
    CameraModel placed;
    for (const double aside : {-0.6, -0.3, 0.0, 0.3, 0.6}) {
      begin_before(camera, column + aside, 0.11, 0.28);
      double own_miss = 0;
      Marks own;
      for (const double reach : {50.0, 30.0, 20.0, 10.0, 10.0, 5.0}) {
        own = marks_at(camera, points, spots, reach);
        own_miss = place_camera(camera, points, own);
      }
      // Before another column all marks are met as well.
      if (std::abs(faced_column(camera) - column) > 0.5 || own.size() <= marks.size()) continue;
      placed = camera;
      marks = own;
      miss = own_miss;
    }
    fmt::print("camera {}: {} marks, two thirds of them met to {:.3f} px RMS\n", name, marks.size(),
               miss);
    seen.cameras.push_back(placed);
    seen.marks.push_back(marks);
  }
  return seen;
}

void judge_by_marks_left_out(const SeenCylinder& seen, const Eigen::Matrix3Xd& points) {
  double squares = 0;
  int count = 0;
  std::vector<double> radii;
  for (const auto& [number, pixel] : seen.marks[0]) {
    const auto other = seen.marks[1].find(number);
    if (!is_left_out(number) || other == seen.marks[1].end()) continue;
    const auto point =
        triangulate({{&seen.cameras[0], pixel, 1}, {&seen.cameras[1], other->second, 1}});
    ASSERT_TRUE(point);
    squares += (point->point - points.col(number)).squaredNorm();
    radii.push_back(point->point.head<2>().norm());
    ++count;
  }
  fmt::print("{} control points that were left out: {:.3f} mm RMS, radius {:.3f} mm (median)\n",
             count, 1e3 * std::sqrt(squares / count), 1e3 * median(radii));
  EXPECT_GT(count, 30);
  EXPECT_LT(std::sqrt(squares / count), 0.15e-3);
  EXPECT_NEAR(median(radii), kRadius, 0.05e-3);
}

/// Of the circle through points along the cylinder's axis, which need not be that of the marks (m).
double fitted_radius(const std::vector<RestPoint>& points) {
  Eigen::MatrixX3d rows(std::ssize(points), 3);
  Eigen::VectorXd squares(std::ssize(points));
  for (Eigen::Index i = 0; i < std::ssize(points); ++i) {
    const Eigen::Vector2d at = points[static_cast<std::size_t>(i)].agreed.position.head<2>();
    rows.row(i) << at.transpose(), 1;
    squares(i) = at.squaredNorm();
  }
  const Eigen::Vector3d circle = rows.colPivHouseholderQr().solve(squares);
  return std::sqrt(circle(2) + circle.head<2>().squaredNorm() / 4);
}

/// Neighbours among points, by their numbers.
std::vector<std::pair<int, int>> edges_of(const std::vector<RestPoint>& points, double reach) {
  std::vector<std::pair<int, int>> edges;
  for (int i = 0; i < std::ssize(points); ++i) {
    for (int k = 0; k < i; ++k) {
      if ((points[i].seen[0]->pixel - points[k].seen[0]->pixel).norm() < reach) {
        edges.emplace_back(i, k);
      }
    }
  }
  return edges;
}

void follow_speckles(const SeenCylinder& seen, const std::filesystem::path& folder) {
  const auto picture = [&](int camera, int configuration) {
    return read_photo(folder / fmt::format("speckle_{}_{}.jpg", 201 + camera, configuration));
  };
  Quadrilateral corners;  // what both see, in the first camera's picture
  corners << 1000, 1500, 1500, 1000, 600, 600, 2450, 2450;
  constexpr int kPatch = 41, kStep = 20;
  const std::vector<GreyPicture> first{picture(0, 1), picture(1, 1)};
  RunContext context;
  context.threads = 2;
  const StereoRest rest = match_rest(seen.cameras, first, corners, {kPatch / 2, kStep}, context);
  fmt::print(
      "speckled cylinder: {} of {} places seen by both, lines of sight miss by {:.2f} px (median), "
      "radius {:.2f} mm\n",
      rest.points.size(), rest.places, rest.median_miss, 1e3 * fitted_radius(rest.points));
  EXPECT_GT(static_cast<double>(rest.points.size()), 0.9 * rest.places);
  EXPECT_LT(rest.median_miss, 1);

  std::vector<PatchTracker> trackers;
  std::vector<MatchCheck> checks;
  for (std::size_t c = 0; c < 2; ++c) {
    trackers.emplace_back(first[c], kPatch / 2, kStep, context);
    for (const RestPoint& point : rest.points) trackers[c].add(point.seen[c]->pixel);
    ASSERT_EQ(trackers[c].count(), std::ssize(rest.points));
  }
  for (const PatchTracker& tracker : trackers) checks.emplace_back(tracker);
  const auto edges = edges_of(rest.points, 1.2 * kStep);
  for (int configuration = 2; configuration <= 5; ++configuration) {
    MatchMisses matches;
    for (int c = 0; c < 2; ++c) {
      trackers[c].follow(picture(c, configuration));
      matches.add(checks[c].of(trackers[c], 2));
    }
    std::vector<std::optional<AgreedPoint>> now;
    std::vector<double> misses;
    for (std::size_t i = 0; i < rest.points.size(); ++i) {
      std::vector<std::optional<SeenPlace>> places;
      for (const PatchTracker& tracker : trackers) {
        const TrackedPatch& patch = tracker.patches()[i];
        places.emplace_back();
        if (patch.is_seen) places.back() = SeenPlace{patch.now(), 0.05};
      }
      now.push_back(agreed_point(seen.cameras, places, most_miss(rest.median_miss)));
      if (now.back()) misses.push_back(now.back()->miss);
    }
    std::vector<double> changes, scatter;
    for (const auto& [i, k] : edges) {
      if (!now[i] || !now[k]) continue;
      const double before =
          (rest.points[i].agreed.position - rest.points[k].agreed.position).norm();
      changes.push_back((now[i]->position - now[k]->position).norm() / before - 1);
    }
    const double middle = median(changes);
    for (const double change : changes) scatter.push_back(std::abs(change - middle));
    const MatchQuality quality = matches.quality();
    const double share =
        static_cast<double>(misses.size()) / static_cast<double>(rest.points.size());
    fmt::print(
        "configuration {}: {:.1f} % of the points seen, lines of sight miss by {:.2f} px, there "
        "and back {:.3f} px, edges {:+.2f} % (median; half of them within {:.2f} %)\n",
        configuration, 100 * share, median(misses), quality.back, 100 * middle,
        100 * median(scatter));
    EXPECT_GT(share, 0.9) << configuration;
    EXPECT_LT(quality.back, 0.2) << configuration;
  }
}

TEST(RealCylinder, ItsMarksPlaceCamerasThatFollowASpeckledOne) {
  const std::filesystem::path folder = measurement("stereo_dic_cylinder");
  SKIP_WITHOUT(folder);
  if (!can_find_chessboards()) GTEST_SKIP() << "needs OpenCV's calib3d";
  const Eigen::Matrix3Xd points = control_points(folder);
  const SeenCylinder seen = seen_cylinder(folder, points);
  judge_by_marks_left_out(seen, points);
  follow_speckles(seen, folder);
}

}  // namespace
}  // namespace pliant::test
