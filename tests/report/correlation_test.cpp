#include "pliant/report/correlation.h"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/report/sections.h"

namespace pliant::report {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

ResultParameter parameter(const std::string& name, const std::string& component) {
  ResultParameter p;
  p.name = name;
  p.component = component;
  return p;
}

Results two_components() {
  Results results;
  results.parameters = {parameter("warp.k1", "warp"), parameter("warp.k2", "warp"),
                        parameter("weft.k1", "weft"), parameter("weft.k2", "weft")};
  results.covariance = {{4, 3, 0, 0}, {3, 9, 0, 0}, {0, 0, 1, -0.5}, {0, 0, -0.5, 1}};
  return results;
}

TEST(CorrelationBlocks, DivideTheCovarianceByTheStandardErrors) {
  const auto blocks = correlation_blocks(two_components());
  ASSERT_THAT(blocks, SizeIs(2));
  EXPECT_THAT(blocks[0].values[0], ElementsAre(1.0, 0.5));
  EXPECT_THAT(blocks[1].values[0], ElementsAre(1.0, -0.5));
}

TEST(CorrelationBlocks, KeepComponentsTogetherThatShareData) {
  Results results = two_components();
  results.covariance[0][2] = results.covariance[2][0] = 1.0;
  EXPECT_THAT(correlation_blocks(results), SizeIs(1));
}

TEST(CorrelationBlocks, LeaveOutWhatIsFixedOrNotDetermined) {
  Results results = two_components();
  results.parameters[0].fixed = true;
  results.parameters[2].identified = false;
  EXPECT_THAT(correlation_blocks(results), IsEmpty());
}

// On paper one wide table makes the whole report small.
TEST(CorrelationSection, HasColoursAloneOnPaperWhereItIsLarge) {
  EXPECT_THAT(correlation_section(two_components()), Not(HasSubstr("heat-map-large")));
  Results many;
  many.covariance.assign(20, std::vector<double>(20, 0.1));
  for (std::size_t i = 0; i < 20; ++i) {
    many.parameters.push_back(parameter("k" + std::to_string(i), "warp"));
    many.covariance[i][i] = 1;
  }
  EXPECT_THAT(correlation_section(many), HasSubstr("heat-map-large"));
}

TEST(CorrelationBlocks, HaveNoNumberWithoutAVariance) {
  Results results = two_components();
  results.covariance[1][1] = std::nan("");
  const auto blocks = correlation_blocks(results);
  EXPECT_TRUE(std::isnan(blocks[0].values[0][1]));
}

}  // namespace
}  // namespace pliant::report
