#include "pliant/report/figure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pliant::report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(FigureSheet, LetsNoTextEndItsScriptElement) {
  FigureSheet sheet(true);
  Figure figure;
  figure.layout["title"] = "</script><script>alert(1)<!--";
  sheet.add(figure, "figure-tall");
  const std::string block = sheet.data_block();
  EXPECT_EQ(block.find("</script>"), block.rfind("</script>"));
  EXPECT_THAT(block, Not(HasSubstr("<!--")));
}

TEST(FigureSheet, DataReadBackAsTheyWereGiven) {
  FigureSheet sheet(true);
  Figure figure;
  figure.traces.push_back({{"x", {1.0, 2.0}}, {"name", "a < b"}});
  sheet.add(figure, "figure-tall");
  const std::string block = sheet.data_block();
  const std::size_t begin = block.find('>') + 1;
  const auto json = nlohmann::json::parse(block.substr(begin, block.rfind("</") - begin));
  EXPECT_EQ(json.at("figure-1").at("data"), figure.traces);
}

TEST(FigureSheet, WithoutAScriptAFigureNamesItsData) {
  FigureSheet sheet(false);
  Figure figure;
  figure.data_file = "predictions/warp.csv";
  EXPECT_THAT(sheet.add(figure, "figure-tall"),
              HasSubstr("This build of Pliant has no drawing script. The numbers are in "
                        "predictions/warp.csv."));
}

}  // namespace
}  // namespace pliant::report
