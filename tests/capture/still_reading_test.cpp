// What cells read while a sample stands still.
#include "pliant/capture/still_reading.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/random.h"
#include "pliant/capture/dic_import.h"

#include "capture/point_tables.h"

namespace pliant {
namespace {

using test::PointTables;

struct Rows {
  std::vector<double> times, values;
};

/// At 20 Hz for ten seconds.
Rows rows(double slope, double noise, std::uint64_t seed = 1) {
  RandomStream random(seed);
  Rows rows;
  for (int i = 0; i <= 200; ++i) {
    rows.times.push_back(i / 20.0);
    rows.values.push_back(2 + slope * (rows.times.back() - 5) + noise * random.normal());
  }
  return rows;
}

TEST(StillReading, IsTheMeanOfTheTimeAroundAFrame) {
  const Rows all = rows(0, 0.01);
  const auto reading = still_reading(all.times, all.values, 5, 1, 2);
  ASSERT_TRUE(reading);
  EXPECT_NEAR(reading->mean, 2, 4 * reading->error);
  EXPECT_NEAR(reading->spread, 0.01, 0.004);
  EXPECT_NEAR(reading->error, 0.01 / std::sqrt(21), 0.001);
  EXPECT_FALSE(reading->creeps);
}

TEST(StillReading, CoversItsErrors) {
  int missed = 0, creeping = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const Rows all = rows(0, 0.01, seed);
    const auto reading = still_reading(all.times, all.values, 5, 1, 2);
    missed += std::abs(reading->mean - 2) > 1.96 * reading->error;
    creeping += reading->creeps;
  }
  EXPECT_LT(missed, 40);
  EXPECT_GT(missed, 8);
  EXPECT_EQ(creeping, 0);
}

TEST(StillReading, TellsACreepThatItsSpreadDoesNot) {
  const Rows all = rows(-0.06, 0.01);
  const auto reading = still_reading(all.times, all.values, 5, 1, 2);
  EXPECT_TRUE(reading->creeps);
  EXPECT_NEAR(reading->creep, -0.06, 0.02);
  EXPECT_THAT(frame_stand(*reading, "the force").creep,
              ::testing::HasSubstr("the force creeps by -"));
}

// A hundredth of a force is little, however well it is known.
TEST(StillReading, LetsALittleCreepPass) {
  const Rows all = rows(-0.015, 1e-5);
  EXPECT_FALSE(still_reading(all.times, all.values, 5, 1, 2)->creeps);
}

TEST(StillReading, NeedsRowsAroundAFrame) {
  const Rows all = rows(0, 0.01);
  EXPECT_FALSE(still_reading(all.times, all.values, 10.1, 1, 2));
  EXPECT_FALSE(still_reading(all.times, all.values, -0.1, 1, 2));
  EXPECT_TRUE(still_reading(all.times, all.values, 0, 1, 2)) << "the half that the log covers";
  EXPECT_FALSE(still_reading(all.times, all.values, 5, 0.04, 2));
  EXPECT_FALSE(still_reading({}, {}, 5, 1, 2));
}

// A tester that holds at 1, 3 and 5 s; at the last the sample gives way.
TEST(StillReading, NamesAFrameInWhichAForceCreeps) {
  const test::TemporaryFolder folder;
  PointTables::write(folder, 3, [](int frame, const Eigen::Vector2d& place) {
    return Eigen::Vector3d(place.x(), (1 + 0.01 * frame) * place.y(), 0);
  });
  RandomStream random(1);
  std::string log = "time_s,force_N\n";
  for (int row = 0; row <= 130; ++row) {
    const double time = row / 20.0;
    const double pulls = time < 2 ? 0 : time < 4 ? 5 : 10 - 0.8 * (time - 4);
    log += fmt::format("{},{}\n", time, pulls + 0.01 * random.normal());
  }
  folder.write("log.csv", log);
  const DicImport made = import_dic(
      PointTables::describe(
          folder,
          "clips: [{name: lower, side: bottom}, {name: upper, side: top}]\n"
          "forces: {data: log.csv, on: upper, rate: 0.5 Hz, start: 1 s, still: 0.8 s}\n"),
      {}, {});
  EXPECT_NEAR(made.made.force[1], 5, 0.01);
  EXPECT_NEAR(made.made.force[2], 9.2, 0.01);
  ASSERT_EQ(made.doubts.size(), 1U);
  EXPECT_EQ(made.doubts[0].frame, 2);
  EXPECT_THAT(made.study.warnings,
              ::testing::Contains(::testing::HasSubstr("frame 2: the force creeps by -")));
}

}  // namespace
}  // namespace pliant
