#include "pliant/report/sample_figure.h"

#include <gtest/gtest.h>

namespace pliant::report {
namespace {

ResultParameter parameter(const std::string& name, double value, bool identified = true) {
  ResultParameter p;
  p.name = name;
  p.unit = "N m";
  p.value = value;
  if (identified) {
    p.lower = value - 1e-6;
    p.upper = value + 2e-6;
  }
  p.identified = identified;
  return p;
}

const std::vector<ResultParameter> kFitted = {
    parameter("samples[0].bend.weft.k[0]", 5e-6), parameter("samples[0].shear.k[0]", 7),
    parameter("samples[1].bend.weft.k[0]", 9e-6, false), parameter("samples[1].shear.k[0]", 8),
    parameter("stretch.weft.k[0]", 80)};

TEST(SampleFigure, PutsEachNumberOfAllSamplesTogether) {
  const std::vector<SampledNumber> numbers = sampled_numbers(kFitted);
  ASSERT_EQ(numbers.size(), 2u);
  EXPECT_EQ(numbers[0].name, "bend.weft.k[0]");
  EXPECT_EQ(numbers[1].name, "shear.k[0]");
  EXPECT_EQ(numbers[1].at[1].value, 8);
}

TEST(SampleFigure, DrawsIntervalsWhereTheyAreKnownInAReadableUnit) {
  const Figure figure = sample_figure(sampled_numbers(kFitted).front());
  EXPECT_EQ(figure.layout.at("yaxis").at("title").at("text"), "bend.weft.k[0] (µN m)");
  const auto& known = figure.traces.at(0);
  EXPECT_EQ(known.at("x"), nlohmann::json({0.0}));
  EXPECT_EQ(known.at("y"), nlohmann::json({5.0}));
  EXPECT_EQ(known.at("error_y").at("array"), nlohmann::json({2.0}));
  EXPECT_EQ(known.at("error_y").at("arrayminus"), nlohmann::json({1.0}));
  EXPECT_EQ(figure.traces.at(1).at("x"), nlohmann::json({1.0}));
}

}  // namespace
}  // namespace pliant::report
