// Frames of which no equilibrium is found are left out, and said to be.

#include <cmath>
#include <limits>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/estimation/frame_measure_table.h"
#include "pliant/estimation/sheet/sheet_result.h"
#include "pliant/experiment/sheet/make_predictor.h"
#include "pliant/io/csv.h"
#include "pliant/material/density/dahl.h"

#include "support/virtual_sheets.h"

namespace pliant {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A stretch of which the clips of one frame are nowhere.
class LostFrame : public ::testing::Test {
 protected:
  LostFrame() {
    for (Pose& pose : session_.frames[kLost].poses) {
      pose.translation.setConstant(std::numeric_limits<double>::quiet_NaN());
    }
  }

  FrameShapes predict(const Material& material) const {
    const SheetTest test("stretch", session_, SheetObjective::clip_forces);
    const auto predictor = make_predictor(session_, material);
    const Eigen::VectorXd parameters = predictor->parameters();
    EXPECT_FALSE(predictor->predict(parameters, {}, 1, {}).has_value());
    return predictor->predict_each(parameters, {}, 1, {});
  }

  static constexpr std::size_t kLost = 2;
  Material material_ = test::sheet_cloth(false);
  Session session_ = test::virtual_stretch(material_, 0, 7, 5);
};

std::vector<bool> found(const FrameShapes& shapes) {
  std::vector<bool> found;
  for (const auto& shape : shapes) found.push_back(shape.has_value());
  return found;
}

TEST_F(LostFrame, LeavesTheOtherFramesOfAnElasticSheet) {
  EXPECT_THAT(found(predict(material_)), ElementsAre(true, true, false, true, true));
}

TEST_F(LostFrame, EndsAPathWithFriction) {
  material_.components.at("stretch.weft").friction =
      ComponentFriction{DahlParameters{1, 1, 0.01}, std::nullopt};
  EXPECT_THAT(found(predict(material_)), ElementsAre(true, true, false, false, false));
}

TEST_F(LostFrame, IsNotCompared) {
  FrameShapes shapes = predict(material_);
  // Off by 0.3 N at both clips of one frame of four.
  shapes[1]->clip_forces.row(0).array() += 0.3;
  const SheetTest test("stretch", session_, SheetObjective::clip_forces);
  const ExperimentResult result = compare_sheet(test, shapes);
  EXPECT_EQ(result.points, 4 * 2);
  EXPECT_EQ(result.excluded, 2);
  EXPECT_NEAR(result.rms, 0.3 / std::sqrt(4.0), 1e-4);
  ASSERT_EQ(result.predicted.size(), 5 * 2 * 3);
  for (Eigen::Index row = 0; row < result.predicted.size(); ++row) {
    const bool lost = result.columns[0].cells[static_cast<std::size_t>(row)] == "2";
    EXPECT_EQ(std::isnan(result.predicted(row)), lost);
    EXPECT_EQ(result.used[static_cast<std::size_t>(row)], lost ? 0 : 1);
  }
  ASSERT_TRUE(result.sheet.has_value());
  EXPECT_THAT(result.sheet->frames, ElementsAre(0, 1, 3, 4));
  EXPECT_THAT(result.sheet->missing_frames(), ElementsAre(2));
  EXPECT_EQ(result.sheet->predicted.frame_count(), 4);
  EXPECT_EQ(result.sheet->predicted.frames[2].positions, shapes[3]->positions);
}

TEST_F(LostFrame, HasMeasuresWithoutPrediction) {
  const SheetTest test("stretch", session_, SheetObjective::clip_forces);
  const ExperimentResult result = compare_sheet(test, predict(material_));
  const CsvTable table = parse_csv(frame_measure_table(*result.sheet), "measures.csv");
  const std::vector<std::string> seen = table.texts("measured_pull_N");
  const std::vector<std::string> predicted = table.texts("predicted_pull_N");
  ASSERT_EQ(predicted.size(), 5U);
  for (std::size_t f = 0; f < predicted.size(); ++f) {
    EXPECT_FALSE(seen[f].empty()) << f;
    EXPECT_EQ(predicted[f].empty(), f == kLost) << f;
  }
  EXPECT_EQ(predicted[4].substr(0, 4), seen[4].substr(0, 4)) << "rows stay with their frames";
}

}  // namespace
}  // namespace pliant
