// What an import of points, and of the log of the tester beside them, says of it.
#include "pliant/capture/dic_import.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "capture/point_tables.h"

namespace pliant {
namespace {

using test::PointTables;
using test::TemporaryFolder;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kTwoClips =
    "clips: [{name: lower, side: bottom}, {name: upper, side: top}]\n";

/// By 1 % a frame along warp.
Eigen::Vector3d stretched(int frame, const Eigen::Vector2d& place) {
  return {place.x(), (1 + 0.01 * frame) * place.y(), 0};
}

/// A sample that is stretched, and the force that a row a frame tells.
DicImport pulled_by(const std::vector<double>& forces) {
  const TemporaryFolder folder;
  PointTables::write(folder, static_cast<int>(forces.size()), stretched);
  std::string log = "force_N\n";
  for (const double force : forces) log += fmt::format("{}\n", force);
  folder.write("log.csv", log);
  return import_dic(PointTables::describe(
                        folder, std::string(kTwoClips) + "forces: {data: log.csv, on: upper}\n"),
                    {}, {});
}

TEST(DicImport, WarnsOfALogThatDoesNotBeginAtZero) {
  const auto of_zero = HasSubstr(
      "pulled by 1 N in the first frame, where it is taken to be at rest: a frame of the slack "
      "sample comes first, or the cell's zero is off");
  EXPECT_THAT(pulled_by({1, 3, 5, 7}).study.warnings, Contains(of_zero));
  EXPECT_THAT(pulled_by({0, 2, 4, 6}).study.warnings,
              Not(Contains(HasSubstr("the cell's zero is off"))));
}

// What pulls there is more than is read.
TEST(DicImport, LeavesOutFramesInWhichACellIsAtItsLimit) {
  const DicImport made = pulled_by({0, 1, 2, 3, 4, 5, 5, 5, 5});
  EXPECT_EQ(made.made.used, (std::vector{0, 1, 2, 3, 4}));
  EXPECT_THAT(made.study.warnings,
              Contains(HasSubstr("the log of the forces reads 5 N again and again")));
  EXPECT_THAT(made.study.notes,
              Contains(HasSubstr("4 frames are left out: frame 5 has the tester's cell at its "
                                 "limit, or not connected; frame 6")));
}

// All after it were taken a second later than they would have been without the gap.
TEST(DicImport, TakesTheForcesOfFramesAfterAGapAtTheirTimes) {
  const TemporaryFolder folder;
  PointTables::write(folder, 5, stretched);
  std::filesystem::remove(folder.path() / "points/002.csv");
  folder.write("log.csv", "time_s,force_N\n0,0\n4,8\n");
  const DicImport made = import_dic(
      PointTables::describe(
          folder, std::string(kTwoClips) + "forces: {data: log.csv, on: upper, rate: 1 Hz}\n"),
      {}, {});
  EXPECT_EQ(made.made.force, (std::vector<double>{0, 2, 6, 8}));
  EXPECT_THAT(made.study.warnings, Contains(HasSubstr("003.csv comes after 001.csv")));
}

}  // namespace
}  // namespace pliant
