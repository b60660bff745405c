#include "pliant/report/report_data.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/input_error_of.h"
#include "report/sample_results.h"

namespace pliant::report {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryFolder;
using testing::write_sample_results;
using testing::write_text;

TEST(ReadReportData, TakesAnEmptyBandAsUnknown) {
  const TemporaryFolder folder;
  write_sample_results(folder.path());
  write_text(folder.path() / "curves.csv",
             "component,strain,load,unload,low,high\nshear,0,0,0,,\nshear,0.1,1,1,,\n");
  EXPECT_TRUE(read_report_data(folder.path()).curves.at(0).low.empty());
}

TEST(ReadReportData, NamesAMissingPredictionFile) {
  const TemporaryFolder folder;
  write_sample_results(folder.path());
  std::filesystem::remove(folder.path() / "predictions" / "weft-stretch-8cm.csv");
  EXPECT_THAT(test::input_error_of([&] { read_report_data(folder.path()); }).where().file,
              HasSubstr("weft-stretch-8cm.csv"));
}

TEST(ReadReportData, RefusesAnUnknownBranchWithItsLine) {
  const TemporaryFolder folder;
  write_sample_results(folder.path());
  write_text(folder.path() / "predictions" / "warp-stretch-8cm.csv",
             "strain,branch,measured_force_N,predicted_force_N\n0,load,0,0\n0.1,up,1,1\n");
  EXPECT_EQ(test::input_error_of([&] { read_report_data(folder.path()); }).where().line, 3);
}

}  // namespace
}  // namespace pliant::report
