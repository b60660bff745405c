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

}  // namespace
}  // namespace pliant
