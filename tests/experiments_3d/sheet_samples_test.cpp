// Sheets that differ from place to place ([T] 4.2.4), found from sessions.

#include <algorithm>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/material/material_samples.h"
#include "pliant/study/result_files.h"
#include "pliant/study/study_fit.h"

#include "io/input_error_of.h"
#include "support/five_sheet_tests.h"
#include "support/virtual_sheets.h"

namespace pliant {
namespace {

constexpr const char* kModel = ", variant: linear-orthotropic, friction: none";

/// Stretch and shear of the sheet times a factor at each of two places along weft.
Material uneven_cloth(const std::vector<double>& factors) {
  Material cloth = test::sheet_cloth(false);
  cloth.samples.width = 0.03;
  for (std::size_t k = 0; k < factors.size(); ++k) {
    SampledComponents& sample = cloth.samples.at.emplace_back(
        Eigen::Vector3d(0.025 + 0.05 * static_cast<double>(k), 0.05, 0));
    for (const char* name : {"stretch.weft", "shear"}) {
      sample.components[name] = scaled(cloth.components.at(name), factors[k]);
    }
  }
  take_means(cloth);
  return cloth;
}

StudyResult fitted(const Material& truth, const std::string& model) {
  const test::FiveSheetTests tests(truth, kModel + model, 9, 5, /*positions=*/true,
                                   /*bends=*/false);
  RunContext context;
  context.threads = 2;
  return fit_study(tests.study(), {}, context);
}

double value_of(const StudyResult& result, const std::string& name) {
  const auto found = std::ranges::find(result.parameters, name, &ParameterEstimate::name);
  EXPECT_NE(found, result.parameters.end()) << name;
  return found->value;
}

bool warns_of_samples(const StudyResult& result) {
  return std::ranges::any_of(result.warnings, [](const std::string& warning) {
    return warning.starts_with("the samples explain no more");
  });
}

TEST(SlowSheetSamples, FindWhereASheetIsStiff) {
  const StudyResult result = fitted(
      uneven_cloth({1, 2}), ", samples: {grid: [2, 1], width: 30 mm, of: [stretch.weft, shear]}");
  EXPECT_TRUE(result.converged);
  EXPECT_NEAR(value_of(result, "samples[0].stretch.weft.k[0]"), 80, 0.03 * 80);
  EXPECT_NEAR(value_of(result, "samples[1].stretch.weft.k[0]"), 160, 0.03 * 160);
  EXPECT_NEAR(value_of(result, "samples[0].shear.k[0]"), 8, 0.05 * 8);
  EXPECT_NEAR(value_of(result, "samples[1].shear.k[0]"), 16, 0.05 * 16);
  EXPECT_NEAR(value_of(result, "stretch.warp.k[0]"), 200, 0.03 * 200);
  EXPECT_FALSE(warns_of_samples(result));
  ASSERT_EQ(result.material.samples.at.size(), 2u);
  const NumberError& error =
      result.material.samples.at[1].components.at("stretch.weft").errors.at("k[0]");
  EXPECT_GT(error.std_error.value_or(0), 0);
  ASSERT_TRUE(result.body.has_value());
  const auto files = fit_files(result, {});
  const auto map = std::ranges::find(files, "sheet.vtu", [](const auto& f) { return f.first; });
  ASSERT_NE(map, files.end());
  EXPECT_NE(map->second.find("stretch.weft.k[0].std_error"), std::string::npos);
}

TEST(SlowSheetSamples, SayWhereASheetNeedsNone) {
  const StudyResult result = fitted(test::sheet_cloth(false),
                                    ", samples: {at: [[0.02, 0.05], [0.08, 0.05]], of: [shear]}");
  EXPECT_NEAR(value_of(result, "samples[0].shear.k[0]"), 8, 0.05 * 8);
  EXPECT_TRUE(warns_of_samples(result));
}

TEST(SheetSamples, AreRefusedWhereTheyMakeNoSense) {
  const auto problem = [](const std::string& model) {
    const test::FiveSheetTests tests(test::sheet_cloth(false), kModel + model, 7, 2);
    return test::input_error_of([&] { fit_study(tests.study(), {}, {}); }).problem();
  };
  EXPECT_EQ(problem(", samples: {at: [[0.02, 0.3]]}"), "sample 0 lies outside the sheet");
  EXPECT_EQ(problem(", samples: {at: [[0.02, 0.03], [0.02, 0.03]]}"),
            "sample 1 is a second one at its place");
  EXPECT_EQ(problem(", samples: {grid: [2, 1], of: [area]}"), "\"area\" is fitted by no stage");
  EXPECT_EQ(problem(", samples: {grid: [2, 1, 1]}"), "has 3 numbers");
  EXPECT_EQ(problem(", samples: {spread: 3}"), "asks for places that are found in solids alone");
  EXPECT_EQ(problem(", samples: {grid: [2, 1]}, limits: [{of: [shear]}]"),
            "stands beside `limits`");
  EXPECT_EQ(problem(", samples: {grid: [2, 1]}, components: {shear: {friction: dahl}}"),
            "has friction or another law that remembers, and differs from place to place");
}

}  // namespace
}  // namespace pliant
