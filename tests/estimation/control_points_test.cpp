#include <cmath>

#include <gtest/gtest.h>

#include "pliant/estimation/experiment_result.h"
#include "pliant/estimation/law_growth.h"
#include "pliant/experiment/shear/shear_cycles_type.h"
#include "pliant/study/study.h"

#include "estimation/virtual_study.h"
#include "support/study_folder.h"

namespace pliant {
namespace {

using test::lab_of;
using test::made_up_material;
using test::strip_cycles;
using test::VirtualStudy;

/// Experiment and problem of a study with one experiment.
struct OneExperiment {
  explicit OneExperiment(const Study& study)
      : experiment(read_experiment(study.experiments.front(), study)),
        problem({experiment.get()}) {}

  double percent_of_peak(const LawFit& fit) const {
    return compare(*experiment, fit.law, fit.nuisance).rms_percent;
  }

  std::unique_ptr<ComponentExperiment> experiment;
  ComponentProblem problem;
};

/// Noise of a good load cell: 0.1 % of the peak force or so.
VirtualTensileCycles noisy_cycles(std::vector<double> strains, double force_noise) {
  auto experiment = strip_cycles(std::move(strains));
  experiment.instrument.force_noise = force_noise;
  return experiment;
}

TEST(ControlPoints, OneIsEnoughForAConstantStiffness) {
  const Material material = made_up_material(
      "stretch.warp", {ScalarCurve::constant(80), FrictionLaw::dahl, {0.5, 1, 0.01}});
  for (const double noise : {0.0, 2e-3}) {
    const VirtualStudy study(lab_of(material, noisy_cycles({0.05, 0.1, 0.2}, noise)));
    const OneExperiment one(study.study());
    const GrownFit grown = grow_law(one.problem, {ScalarCurve::none(), FrictionLaw::dahl}, {5}, {});
    EXPECT_EQ(grown.fit.law.stiffness.size(), 1) << "noise " << noise;
    EXPECT_TRUE(grown.stages.front().accepted);
    for (size_t i = 1; i < grown.stages.size(); ++i) EXPECT_FALSE(grown.stages[i].accepted) << i;
    EXPECT_EQ(grown.end, noise > 0 ? GrowthEnd::not_worth_it : GrowthEnd::accurate);
  }
}

/// A stiff weave: crimp is pulled out up to a strain of 0.15, then the yarns themselves are
/// stretched and the sheet is twenty times as stiff.
Material long_toe() {
  return made_up_material("stretch.warp",
                          {ScalarCurve::hermite({0, 0.1, 0.15, 0.175, 0.2}, {20, 20, 20, 400, 400}),
                           FrictionLaw::dahl,
                           {0.3, 1, 0.01}});
}

LawFit fit_equidistant(const OneExperiment& one, int points) {
  std::vector<double> knots;
  for (int i = 0; i < points; ++i) knots.push_back(one.problem.largest_strain() * i / (points - 1));
  const ComponentLaw shape{
      ScalarCurve::hermite(knots, std::vector<double>(knots.size(), 0.0)), FrictionLaw::dahl, {}};
  return fit_law(one.problem, shape, {});
}

TEST(ControlPoints, StandWhereAStiffWeaveBends) {
  // Engineering strains whose Green-Lagrange strains reach 0.2.
  const VirtualStudy study(lab_of(long_toe(), noisy_cycles({0.1, 0.15, 0.1832}, 2e-3)));
  const OneExperiment one(study.study());
  const GrownFit grown = grow_law(one.problem, {ScalarCurve::none(), FrictionLaw::dahl}, {5}, {});
  const LawFit equidistant = fit_equidistant(one, 5);
  EXPECT_LE(grown.fit.law.stiffness.size(), 5);
  EXPECT_LT(one.percent_of_peak(grown.fit), 1);
  EXPECT_LT(one.percent_of_peak(grown.fit), 0.5 * one.percent_of_peak(equidistant));
}

TEST(ControlPoints, HoldACurveOfFivePointsBetweenThem) {
  const Material material = test::strip_of_five_points();
  const ScalarCurve& truth = *material.components.at("stretch.warp").stiffness;
  const VirtualStudy study(lab_of(material, noisy_cycles({0.05, 0.1, 0.1832}, 1e-3)));
  const OneExperiment one(study.study());
  const ScalarCurve found =
      grow_law(one.problem, {ScalarCurve::none(), FrictionLaw::dahl}, {5}, {}).fit.law.stiffness;
  EXPECT_EQ(found.size(), 5);
  // At rest friction hides the stiffness.
  for (double strain = 0.01; strain < 0.2; strain += 0.005) {
    EXPECT_NEAR(found.value(strain), truth.value(strain), 0.02 * truth.value(strain)) << strain;
  }
}

TEST(ControlPoints, StayWithinTheNumberThatTheStudyAllows) {
  const VirtualStudy study(lab_of(long_toe(), noisy_cycles({0.1, 0.15, 0.1832}, 2e-3)));
  const OneExperiment one(study.study());
  const GrownFit grown = grow_law(one.problem, {ScalarCurve::none(), FrictionLaw::dahl}, {3}, {});
  EXPECT_EQ(grown.fit.law.stiffness.size(), 3);
  EXPECT_EQ(grown.end, GrowthEnd::most);
}

// The sheet is sheared both ways and its law is even: knots stand on one side.
TEST(ControlPoints, OfShearBeginAtZero) {
  VirtualShearCycles experiment;
  experiment.name = "shear";
  experiment.peaks = {0.07, 0.14};
  const Material material = made_up_material(
      "shear", {ScalarCurve::affine(5, 300), FrictionLaw::dahl, {0.1, 0.2, 0.005}});
  const VirtualStudy study(lab_of(material, experiment));
  const OneExperiment one(study.study());
  const ScalarCurve curve =
      grow_law(one.problem, {ScalarCurve::none(), FrictionLaw::dahl}, {5}, {}).fit.law.stiffness;
  EXPECT_TRUE(curve.even());
  EXPECT_EQ(curve.knots().front(), 0);
  EXPECT_GT(curve.size(), 1);
}

TEST(ControlPoints, GrowthNeverLeavesALargerResidual) {
  const VirtualStudy study(lab_of(long_toe(), noisy_cycles({0.1, 0.15, 0.1832}, 2e-3)));
  const OneExperiment one(study.study());
  const GrownFit grown = grow_law(one.problem, {ScalarCurve::none(), FrictionLaw::dahl}, {5}, {});
  double accepted = grown.stages.front().rms;
  for (size_t i = 1; i < grown.stages.size(); ++i) {
    if (!grown.stages[i].accepted) continue;
    EXPECT_LT(grown.stages[i].rms, 0.99 * accepted);  // the 1 % rule of [T] 3.4.2
    accepted = grown.stages[i].rms;
  }
  EXPECT_DOUBLE_EQ(grown.fit.rms, accepted);
}

TEST(ControlPoints, OfThreeRowsDoNotCoincide) {
  const test::StudyFolder folder;
  folder.write("t.csv", "length_mm,force_N\n80,0\n90,12\n85,3\n");
  const OneExperiment one(
      folder.study("{name: strip, type: tensile-cycles, data: t.csv, length: 80 mm, width: 40 mm, "
                   "direction: warp}"));
  const GrownFit grown = grow_law(one.problem, {ScalarCurve::none(), FrictionLaw::none}, {5}, {});
  EXPECT_TRUE(std::isfinite(one.percent_of_peak(grown.fit)));
}

}  // namespace
}  // namespace pliant
