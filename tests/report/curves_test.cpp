#include "pliant/report/curves.h"

#include <cmath>

#include <gtest/gtest.h>

#include "report/sample_results.h"

namespace pliant::report {
namespace {

TEST(Curves, HaveGapsInTheirBandsWhereTheDataSeeNothing) {
  const testing::TemporaryFolder folder;
  testing::write_text(folder.path() / "curves.csv",
                      "component,strain,load,unload,low,high,elastic,friction_max\n"
                      "shear,0,0,0,,,0,1\n"
                      "shear,0.1,2,1,1.5,2.5,1.6,1\n"
                      "stretch.warp,0,0,0,,,0,1\n"
                      "stretch.warp,0.1,4,3,,,3.5,1\n");
  const std::vector<ComponentCurve> curves = read_curves(folder.path() / "curves.csv");
  ASSERT_EQ(curves.size(), 2U);
  ASSERT_EQ(curves[0].low.size(), 2U);
  EXPECT_TRUE(std::isnan(curves[0].low[0]));
  EXPECT_EQ(curves[0].high[1], 2.5);
  EXPECT_TRUE(curves[1].low.empty());
  EXPECT_EQ(curves[1].load.size(), 2U);
}

}  // namespace
}  // namespace pliant::report
