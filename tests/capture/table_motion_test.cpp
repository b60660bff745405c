// Sheets that are pushed over the edge of a table, as points of image correlation show them.
#include "pliant/capture/table_motion.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/errors.h"
#include "pliant/capture/dic_session.h"

#include "capture/point_tables.h"
#include "io/input_error_of.h"

namespace pliant {
namespace {

using test::PointTables;
using test::TemporaryFolder;
using ::testing::HasSubstr;

constexpr double kLength = PointTables::kHeight, kRadius = 0.02;  // m

/// Of a sheet that ends at the table's edge at rest and is pushed out: what is beyond the edge is
/// bent to an arc, what lies on the table is turned a little about the middle of the edge.
/// @param out, turn  m, rad
Eigen::Vector3d pushed_out(const Eigen::Vector2d& place, double out, double turn) {
  Eigen::Vector3d at(place.x() - PointTables::kWidth / 2, place.y() + out - kLength, 0);
  if (at.y() > 0) {
    const double angle = at.y() / kRadius;
    at.y() = kRadius * std::sin(angle);
    at.z() = kRadius * (std::cos(angle) - 1);
  }
  at = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) * at;
  return at + Eigen::Vector3d(PointTables::kWidth / 2, kLength, 0);
}

struct Points {
  Eigen::Matrix3Xd rest, moved;
};

Points points_of(double out, double turn) {
  const auto places = PointTables::places();
  Points points{Eigen::Matrix3Xd::Zero(3, std::ssize(places)),
                Eigen::Matrix3Xd(3, std::ssize(places))};
  for (Eigen::Index i = 0; i < std::ssize(places); ++i) {
    const Eigen::Vector2d& place = places[static_cast<std::size_t>(i)];
    points.rest.col(i).head<2>() = place;
    points.moved.col(i) = pushed_out(place, out, turn);
  }
  return points;
}

constexpr DicTable kTable{RestAxis::v, kLength};

TEST(TableMotion, TellsTheEdgeUnderASheetThatIsPushedFarAtOnce) {
  const Points points = points_of(0.035, 0.02);
  const auto pushed = pushed_sheet(points.rest, points.moved, kTable, PointTables::kWidth / 2,
                                   kLength, 2 * PointTables::kSpacing);
  ASSERT_TRUE(pushed);
  EXPECT_NEAR(pushed->edge, kLength - 0.035, 1e-9);
  EXPECT_NEAR(std::abs(pushed->turn), 0.02, 1e-9);
  EXPECT_GT(pushed->held, 300);
  const Eigen::Vector3d held = pushed->motion.inverse() * points.moved.col(0);
  EXPECT_LT((held - points.rest.col(0)).norm(), 1e-9);
}

TEST(TableMotion, NeedsPointsOnTheTable) {
  Points points = points_of(0.03, 0);
  points.rest = points.rest.rightCols(19).eval();
  points.moved = points.moved.rightCols(19).eval();
  EXPECT_FALSE(pushed_sheet(points.rest, points.moved, kTable, PointTables::kWidth / 2,
                            kLength - 0.078, 2 * PointTables::kSpacing));
}

/// Tables of numbered points in space.
std::filesystem::path described(const TemporaryFolder& folder, const std::string& more) {
  const auto places = PointTables::places();
  for (int f = 0; f < 3; ++f) {
    std::string text = "id;X [mm];Y [mm];Z [mm]\n";
    for (std::size_t p = 0; p < places.size(); ++p) {
      const Eigen::Vector3d at = 1e3 * pushed_out(places[p], 0.015 * f, 0.01 * f);
      text += fmt::format("{};{};{};{}\n", p, at.x(), at.y(), at.z());
    }
    folder.write(fmt::format("s/{}.csv", f), text);
  }
  return folder.write("s.yaml",
                      "pliant: dic/1\ntest: bend-warp\npoints: s/*.csv\norigin: [0 mm, 0 mm]\n"
                      "sample: {width: 40 mm, height: 80 mm, mass: 0.5 g}\n" +
                          more);
}

/// The vertex that is nearest to a place at rest.
Eigen::Vector3d at(const Session& session, const SessionFrame& frame,
                   const Eigen::Vector2d& place) {
  Eigen::Index vertex = 0;
  (session.rest.positions.topRows<2>().colwise() - place).colwise().norm().minCoeff(&vertex);
  return frame.positions.col(vertex);
}

TEST(TableMotion, GivesASessionInTheSheetsOwnAxes) {
  const TemporaryFolder folder;
  const auto file = described(folder, "gravity: [0, 0, -9.81]\ntable: {edge_y: 80 mm}\n");
  const DicSession made = make_dic_session(read_dic(file));
  // The first frame shows the sample where it lies.
  ASSERT_EQ(made.session.frame_count(), 2);
  EXPECT_EQ(made.used, (std::vector{1, 2}));
  for (int f = 0; f < 2; ++f) {
    const SessionFrame& frame = made.session.frames[static_cast<std::size_t>(f)];
    const double out = 0.015 * (f + 1);
    EXPECT_NEAR(*frame.table_edge, kLength - out, 1e-6);
    const Eigen::Vector3d held = at(made.session, frame, {0.02, 0.004});
    EXPECT_LT((held - Eigen::Vector3d(0.02, 0.004, 0)).norm(), 1e-6);
    const double beyond = 0.076 + out - kLength;
    EXPECT_NEAR(at(made.session, frame, {0.02, 0.076}).z(),
                kRadius * (std::cos(beyond / kRadius) - 1), 0.05e-3);
  }
}

std::string refused_table(const std::string& more) {
  const TemporaryFolder folder;
  const auto file = described(folder, more);
  return test::input_error_of([&] { make_dic_session(read_dic(file)); }).what();
}

TEST(TableMotion, RefusesTablesThatDoNotFit) {
  EXPECT_THAT(refused_table("table: {edge_y: 80 mm}\n"), HasSubstr("table: needs `gravity`"));
  const std::string gravity = "gravity: [0, 0, -9.81]\n";
  EXPECT_THAT(refused_table(gravity + "table: {edge_y: 90 mm}\n"),
              HasSubstr("has its edge at 90 mm of a sample of 80 mm"));
  EXPECT_THAT(refused_table(gravity + "table: {edge_y: 80 mm}\nclips: [{name: a, side: top}]\n"),
              HasSubstr("clips: stands beside `table`"));
  EXPECT_THAT(refused_table(gravity + "table: {}\n"), HasSubstr("table: has no single edge"));
}

TEST(TableMotion, IsRefusedOfPointsInAPlane) {
  const TemporaryFolder folder;
  PointTables::write(folder, 2, [](int, const Eigen::Vector2d& place) -> Eigen::Vector3d {
    return {place.x(), place.y(), 0};
  });
  const auto file = folder.write(
      "flat.yaml",
      "pliant: dic/1\ntest: bend-warp\npoints: points/*.csv\nscale: 0.05 mm\n"
      "sample: {width: 40 mm, height: 80 mm, mass: 0.5 g}\norigin: [100, 1900]\nwarp: -y\n"
      "gravity: [0, 0, -9.81]\ntable: {edge_y: 80 mm}\n");
  EXPECT_THAT(test::input_error_of([&] { make_dic_session(read_dic(file)); }).what(),
              HasSubstr("is seen in points without `z`"));
}

}  // namespace
}  // namespace pliant
