// Files as testing machines wrote them; skipped where PLIANT_TEST_DATA does not hold them.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "pliant/io/csv.h"
#include "pliant/io/document.h"

namespace pliant {
namespace {

std::filesystem::path measurement(const std::string& name) {
  const char* folder = std::getenv("PLIANT_TEST_DATA");
  return folder == nullptr ? std::filesystem::path() : std::filesystem::path(folder) / name;
}

#define SKIP_WITHOUT(path) \
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "PLIANT_TEST_DATA does not hold " << path

TEST(RealCsv, TesterWithChineseHeadersAndAUnitsRowIsRead) {
  const auto path = measurement("elastomer_cyclic_vhb4910/vhb4910_0d01_2d0.csv");
  SKIP_WITHOUT(path);
  // The headers say time, displacement and force, in GBK.
  const CsvTable table = read_csv(
      path,
      {.encoding = "gbk",
       .columns = {{"time", "\u65f6\u95f4"}, {"extension", "\u4f4d\u79fb"}, {"force", "\u529b"}}});
  const std::vector<double> time = table.quantity("time", Dimension::time);
  EXPECT_TRUE(std::is_sorted(time.begin(), time.end()));
  EXPECT_DOUBLE_EQ(time[1], 0.02);
  EXPECT_DOUBLE_EQ(table.quantity("extension", Dimension::length)[2], 3.5e-6);
  EXPECT_DOUBLE_EQ(table.quantity("force", Dimension::force)[2], 0.0195);
  EXPECT_TRUE(table.unused_columns().empty());
}

TEST(RealCsv, TesterWithAPreambleIsReadBelowIt) {
  const auto path = measurement("silicone_tensile_srmd/Ecoflex_00-30.csv");
  SKIP_WITHOUT(path);
  const CsvTable table =
      read_csv(path, {.skip_rows = 17, .columns = {{"stress", "Engineering Stress (MPa)"}}});
  EXPECT_EQ(table.header_line(), 18);
  EXPECT_DOUBLE_EQ(table.quantity("stress", Dimension::stress)[0], 1490.0);
  EXPECT_DOUBLE_EQ(table.numbers("Engineering Strain")[0], 0.06795);
}

TEST(RealJson, FabricRecordIsReadWithItsNumbers) {
  const auto path = measurement("cloth_hysteresis_fab/fab_knit_cotton_300gsm.json");
  SKIP_WITHOUT(path);
  EXPECT_EQ(read_json(path).root.kind, Node::Kind::mapping);
}

}  // namespace
}  // namespace pliant
