#include "pliant/estimation/judgement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/estimation/fit_result.h"

namespace pliant {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// An experiment that measured a force that rises to a peak (N), and its prediction.
ExperimentResult pulled(const std::string& name, double measured_peak, double predicted_peak,
                        ExperimentRole role = ExperimentRole::validate) {
  ExperimentResult e;
  e.name = name;
  e.role = role;
  e.quantity = {"force_N", "force", "N", 1};
  constexpr int kRows = 50;
  const Eigen::VectorXd rise = Eigen::VectorXd::LinSpaced(kRows, 0, 1).array().pow(4);
  e.measured = measured_peak * rise;
  e.predicted = predicted_peak * rise;
  e.used.assign(kRows, 1);
  e.points = kRows;
  e.rms = (e.measured - e.predicted).norm() / std::sqrt(kRows);
  e.rms_percent = 100 * e.rms / measured_peak;
  return e;
}

StudyResult result_of(std::vector<ExperimentResult> experiments) {
  StudyResult result;
  result.experiments = std::move(experiments);
  return result;
}

TEST(Judgement, AGoodPredictionIsFitForUse) {
  const Judgement judgement = judge(result_of({pulled("a", 5, 5.1)}), {}, false);
  EXPECT_EQ(judgement.fitness, Fitness::fit);
  EXPECT_EQ(judgement.headline, "Fit for use within the range of the data.");
  EXPECT_NEAR(*judgement.experiments.front().span_ratio, 1.02, 1e-12);
  EXPECT_TRUE(judgement.experiments.front().reasons.empty());
}

// Where a force is low for long and rises at the end, RMS over the peak hides that nothing of it is
// predicted.
TEST(Judgement, AMissIsToldByTheScaleOfWhatWasMeasured) {
  const StudyResult result = result_of({pulled("good", 3, 3.02), pulled("missed", 5.18, 0.1)});
  EXPECT_LT(result.experiments[1].rms_percent, 40);
  const Judgement judgement = judge(result, {}, false);
  EXPECT_EQ(judgement.fitness, Fitness::unfit);
  EXPECT_EQ(judgement.experiments.front().experiment, "missed");
  EXPECT_LT(*judgement.experiments.front().explained, 0.1);
  EXPECT_THAT(judgement.headline,
              AllOf(StartsWith("Not fit for use. missed: "),
                    HasSubstr("the measured span of 5.18 N is predicted as 0.1 N")));
}

TEST(Judgement, SaysOfEachLimitWhetherItIsKeptAndByWhichExperiment) {
  const StudyResult result = result_of({pulled("good", 3, 3.02), pulled("worse", 5, 5.2)});
  const Judgement judgement = judge(result, {.rms = 0.03, .span = 0.02}, false);
  ASSERT_EQ(judgement.criteria.size(), 4u);
  EXPECT_EQ(judgement.criteria[0].text(), "RMS error 1.4 % (worse; limit 3 %): pass");
  EXPECT_TRUE(judgement.criteria[0].passed());
  EXPECT_EQ(judgement.criteria[1].text(), "error of the span 4 % (worse; limit 2 %): fail");
  EXPECT_FALSE(judgement.criteria[1].passed());
  EXPECT_EQ(judgement.criteria[2].text(),
            "error of the loop's loss (limit 30 %): no experiment tells it");
}

TEST(Judgement, NothingThatCanBePredictedKeepsNoLimit) {
  ExperimentResult lost = pulled("lost", 5, 5);
  lost.points = 0;
  const Judgement judgement = judge(result_of({pulled("good", 3, 3.02), lost}), {}, false);
  EXPECT_EQ(judgement.criteria[0].text(), "RMS error without end (lost; limit 5 %): fail");
}

// A strip that hangs has the force of a catenary, whatever its stiffness: to predict that is
// nothing.
TEST(Judgement, OfAStripThatHangsCountsWhatIsBetterThanNoStiffness) {
  ExperimentResult hanging = pulled("hanging", 5, 4.8);
  const auto error = (hanging.predicted - hanging.measured).array().square().mean();
  hanging.limp_rms = 1.25 * std::sqrt(error);
  const Judgement judgement = judge(result_of({hanging}), {}, false);
  EXPECT_NEAR(*judgement.experiments.front().explained, 0.36, 1e-12);
  EXPECT_EQ(judgement.fitness, Fitness::unfit);
  EXPECT_THAT(judgement.headline,
              HasSubstr("36 % of what a strip without stiffness leaves is explained"));
}

// Where noise is a good part of what no stiffness leaves, the strip is no test of bending.
TEST(Judgement, DoesNotBlameAMaterialForNoise) {
  ExperimentResult hanging = pulled("hanging", 5, 5);
  constexpr double kNoise = 0.1;
  for (Eigen::Index i = 0; i < hanging.measured.size(); ++i) {
    hanging.measured(i) += i % 2 == 0 ? kNoise : -kNoise;
  }
  hanging.noise_floor = kNoise;
  hanging.rms = kNoise;
  hanging.rms_percent = 2;
  hanging.limp_rms = 2 * kNoise;
  const Judgement hidden = judge(result_of({hanging}), {}, true);
  EXPECT_FALSE(hidden.experiments.front().explained.has_value());
  EXPECT_NE(hidden.fitness, Fitness::unfit);
  hanging.limp_rms = 4 * kNoise;
  const Judgement told = judge(result_of({hanging}), {}, true);
  EXPECT_NEAR(*told.experiments.front().explained, 1, 1e-9);
  EXPECT_NE(told.fitness, Fitness::unfit);
}

TEST(Judgement, JudgesALoopThatIsNotThereByWhatIsPredicted) {
  for (const double measured : {-6e-4, -4e-5, 0.0, 1e-4, 8e-4}) {
    ExperimentResult elastic = pulled("elastic", 5, 5);
    elastic.measured_loop.emplace().loop_loss = measured;
    elastic.predicted_loop.emplace().loop_loss = 0.089;
    const Judgement judgement = judge(result_of({elastic}), {}, true);
    EXPECT_EQ(judgement.fitness, Fitness::unfit) << measured;
    EXPECT_FALSE(judgement.experiments.front().loop_ratio.has_value());
  }
}

TEST(Judgement, TellsSmallForcesInMillinewtons) {
  const Judgement judgement = judge(result_of({pulled("a", 0.0055, 0.001)}), {}, false);
  EXPECT_THAT(judgement.headline, HasSubstr("the measured span of 5.5 mN is predicted as 1 mN"));
}

TEST(Judgement, NamesTheComponentsThatAMaterialIsNotFitFor) {
  ExperimentResult bent = pulled("bent", 5, 1), stretched = pulled("stretched", 5, 5);
  bent.component = "bend.warp";
  stretched.component = "stretch.warp";
  EXPECT_THAT(judge(result_of({bent, stretched}), {}, false).headline,
              StartsWith("Not fit for use in bend.warp. bent: "));
  EXPECT_THAT(judge(result_of({bent}), {}, false).headline, StartsWith("Not fit for use. bent: "));
}

// A loop that loses next to nothing is noise: a material without friction is fit for it.
TEST(Judgement, ALoopThatIsHardlyOneIsNotMissed) {
  ExperimentResult flat = pulled("flat", 5, 5), round = pulled("round", 5, 5);
  flat.measured_loop = LoopMetrics{.loop_loss = 0.002};
  round.measured_loop = LoopMetrics{.loop_loss = 0.2};
  flat.predicted_loop = round.predicted_loop = LoopMetrics{};
  EXPECT_EQ(judge(result_of({flat}), {}, false).fitness, Fitness::fit);
  EXPECT_EQ(judge(result_of({round}), {}, false).fitness, Fitness::unfit);
}

TEST(Judgement, UpToThreeTimesWhatIsAcceptedIsAReservation) {
  const Judgement judgement = judge(result_of({pulled("a", 5, 6), pulled("b", 5, 5)}), {}, false);
  EXPECT_EQ(judgement.fitness, Fitness::reservations);
  EXPECT_THAT(judgement.headline, StartsWith("Fit for use with reservations. a: "));
  EXPECT_EQ(judgement.experiments[0].fitness(), Fitness::reservations);
  EXPECT_EQ(judgement.experiments[1].fitness(), Fitness::fit);
}

TEST(Judgement, TheStudySaysWhatIsAccepted) {
  const StudyResult result = result_of({pulled("a", 5, 5.3)});
  EXPECT_EQ(judge(result, {}, false).fitness, Fitness::fit);
  EXPECT_EQ(judge(result, {.span = 0.025}, false).fitness, Fitness::reservations);
  EXPECT_EQ(judge(result, {.span = 0.01}, false).fitness, Fitness::unfit);
}

TEST(Judgement, WithoutValidationThereIsAReservation) {
  const StudyResult result = result_of({pulled("a", 5, 5, ExperimentRole::fit)});
  const Judgement judgement = judge(result, {}, false);
  EXPECT_EQ(judgement.fitness, Fitness::reservations);
  EXPECT_EQ(judgement.headline,
            "Fit for use with reservations. No experiment was kept to validate it.");
}

TEST(Judgement, AFitThatDidNotConvergeIsNotFitForUse) {
  StudyResult result = result_of({pulled("a", 5, 5)});
  result.converged = false;
  EXPECT_EQ(judge(result, {}, false).fitness, Fitness::unfit);
  EXPECT_EQ(judge(result, {}, false).headline, "Not fit for use. The fit did not converge.");
}

TEST(Judgement, LoopsAreJudgedByWhatTheyLose) {
  ExperimentResult e = pulled("a", 5, 5);
  e.measured_loop = LoopMetrics{.secant_modulus = 1, .hysteresis_ratio = 0.3, .loop_loss = 0.3};
  e.predicted_loop = LoopMetrics{.secant_modulus = 1, .hysteresis_ratio = 0.1, .loop_loss = 0.1};
  const Judgement judgement = judge(result_of({e}), {}, false);
  EXPECT_EQ(judgement.fitness, Fitness::reservations);
  EXPECT_THAT(judgement.experiments.front().reasons,
              ElementsAre("the loop loses 30 %, predicted 10 %"));
}

// Distances from a profile have no peak and no variance of their own.
TEST(Judgement, DistancesAreJudgedByTheLengthOfTheStrip) {
  ExperimentResult e = pulled("profiles", 1, 1);
  e.quantity = {"distance_mm", "distance", "mm", 1000};
  e.rms_percent = 7;
  const Judgement judgement = judge(result_of({e}), {}, false);
  EXPECT_FALSE(judgement.experiments.front().span_ratio);
  EXPECT_THAT(judgement.headline, HasSubstr("RMS error 7 % of the strip's length (accepted: 5 %)"));
}

TEST(Judgement, WhatHasNoPredictionIsNoFit) {
  ExperimentResult e = pulled("sheet", 1, 1);
  e.points = 0;
  e.rms = e.rms_percent = 0;
  const Judgement judgement = judge(result_of({e}), {}, false);
  EXPECT_EQ(judgement.fitness, Fitness::unfit);
  EXPECT_THAT(judgement.headline, HasSubstr("nothing of it can be predicted"));
}

TEST(Judgement, AnErrorThatIsNoNumberIsTheWorst) {
  ExperimentResult e = pulled("b", 1, 1);
  e.rms_percent = NAN;
  const Judgement judgement = judge(result_of({pulled("a", 1, 1.2), e}), {}, false);
  EXPECT_EQ(judgement.experiments.front().experiment, "b");
  EXPECT_EQ(judgement.fitness, Fitness::unfit);
}

TEST(Judgement, WithoutExperimentsThereIsNothingToSay) {
  EXPECT_EQ(judge({}, {}, true).headline, "There is no experiment to judge the material by.");
}

}  // namespace
}  // namespace pliant
