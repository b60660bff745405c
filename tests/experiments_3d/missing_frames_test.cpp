// Frames of which no equilibrium is found are left out, and said to be.

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/errors.h"
#include "pliant/estimation/sheet/sheet_fit.h"
#include "pliant/estimation/sheet/sheet_result.h"
#include "pliant/experiment/session/make_predictor.h"
#include "pliant/experiment/session/virtual_session.h"
#include "pliant/io/csv.h"
#include "pliant/material/density/dahl.h"
#include "pliant/study/frame_measure_table.h"
#include "pliant/study/sheet_predictions.h"

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

/// A stretch along weft with friction, there and back; in one frame the clips are nowhere.
class LostFrameOfALoop : public ::testing::Test {
 protected:
  LostFrameOfALoop() {
    Material material = first_sheet_material({});
    material.density = 0.2;
    MaterialComponent& weft = material.components.at("stretch.weft");
    weft.stiffness = ScalarCurve::hermite({0.0}, {300.0});
    weft.friction = ComponentFriction{DahlParameters{2, 0, 0.008}, std::nullopt};
    material.components.at("shear").stiffness = ScalarCurve::hermite({0.0}, {60.0}, true);
    VirtualSession options = usual_session("stretch-weft");
    options.nodes = {6, 6};
    options.frames = 25;
    RandomStream random(3);
    Session session = make_virtual_session(material, options, random);
    for (Pose& pose : session.frames[kLost].poses) {
      pose.translation.setConstant(std::numeric_limits<double>::quiet_NaN());
    }
    experiments_.push_back({{"stretch", std::move(session), SheetObjective::clip_forces},
                            ExperimentRole::fit,
                            "",
                            "",
                            {}});
    study_.model.stiffness = CurveKind::constant;
  }

  static constexpr int kLost = 15;
  Study study_;
  std::vector<SheetExperiment> experiments_;
  RunContext context_;
};

TEST_F(LostFrameOfALoop, IsLeftOutOfTheFitAndOfThePrediction) {
  const SheetFit fit =
      fit_sheets(study_, sheet_plan(study_, {&experiments_.front().test}), context_);
  EXPECT_THAT(fit.warnings, ElementsAre("stretch: no equilibrium is found of frame 15 (of 25), "
                                        "left out of the fit"));
  const MaterialComponent& weft = fit.material.components.at("stretch.weft");
  EXPECT_NEAR(weft.stiffness->value(0), 300, 0.3);
  ASSERT_TRUE(weft.friction.has_value());
  EXPECT_NEAR(weft.friction->positive.a, 2, 0.02);

  EquilibriumWork work;
  const auto results = sheet_predictions(experiments_, fit.material, {}, context_, work);
  ASSERT_TRUE(results.front().sheet.has_value());
  EXPECT_THAT(results.front().sheet->missing_frames(), ElementsAre(kLost));
  EXPECT_LT(results.front().rms_percent, 0.1);
}

TEST_F(LostFrameOfALoop, IsNotOneOfMany) {
  Session session = experiments_.front().test.session();
  for (std::size_t f = 0; f < 7; ++f) session.frames[f].poses = session.frames[kLost].poses;
  experiments_.front().test = {"stretch", std::move(session), SheetObjective::clip_forces};
  EXPECT_THROW(fit_sheets(study_, sheet_plan(study_, {&experiments_.front().test}), context_),
               SolverError);
}

}  // namespace
}  // namespace pliant
