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

/// A sample that is stretched by 1 % a frame along warp, and the force that a row a frame tells.
DicImport pulled_by(const std::vector<double>& forces) {
  const TemporaryFolder folder;
  PointTables::write(folder, static_cast<int>(forces.size()),
                     [](int frame, const Eigen::Vector2d& place) {
                       return Eigen::Vector3d(place.x(), (1 + 0.01 * frame) * place.y(), 0);
                     });
  std::string log = "force_N\n";
  for (const double force : forces) log += fmt::format("{}\n", force);
  folder.write("log.csv", log);
  return import_dic(PointTables::describe(folder,
                                          "clips: [{name: lower, side: bottom}, {name: upper, "
                                          "side: top}]\nforces: {data: log.csv, on: upper}\n"),
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

}  // namespace
}  // namespace pliant
