#include "pliant/study/virtual_lab.h"

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/errors.h"
#include "pliant/experiment/bending/pure_bending_type.h"
#include "pliant/experiment/shear/shear_cycles_type.h"
#include "pliant/study/study.h"

#include "support/virtual_lab.h"

namespace pliant {
namespace {

using test::hung_weights;
using test::LabFolder;
using test::MeasuredFiles;
using test::measurements_of;
using ::testing::ElementsAre;

Material jersey() {
  Material material;
  material.name = "jersey";
  material.density = 0.157;
  MaterialComponent& warp = material.components["stretch.warp"];
  warp.stiffness = ScalarCurve::affine(4.42, 32.19);
  warp.friction = ComponentFriction{{0.40, 4.84, 0.088}, {}};
  MaterialComponent& weft = material.components["stretch.weft"];
  weft.stiffness = ScalarCurve::hermite({0, 0.1, 0.3}, {40, 30, 90});
  weft.friction = ComponentFriction{{0.8, 2, 0.01}, {}};
  MaterialComponent& shear = material.components["shear"];
  shear.stiffness = ScalarCurve::hermite({0, 0.05, 0.2}, {30, 40, 45}, true);
  shear.friction = ComponentFriction{{0.8, 1.5, 0.02}, {}};
  MaterialComponent& bend = material.components["bend.warp"];
  bend.stiffness = ScalarCurve::affine(6.219e-6, 7e-9);
  bend.friction = ComponentFriction{{1.284e-3, 5e-6, 7.67}, {}};
  return material;
}

VirtualTensileCycles cycles() {
  auto experiment = test::strip_cycles({0.05, 0.1, 0.2});
  experiment.name = "weft-8cm";
  experiment.direction = "weft";
  experiment.length = 0.08;
  experiment.width = 0.05;
  experiment.slack = 0.0011;
  return experiment;
}

VirtualShearCycles shear() {
  VirtualShearCycles experiment;
  experiment.name = "shear";
  experiment.peaks = {0.07, 0.14};
  experiment.transverse_tension = 9.8;
  return experiment;
}

VirtualPureBending bending() {
  VirtualPureBending experiment;
  experiment.name = "bending";
  experiment.direction = "warp";
  experiment.peaks = {100, 250};  // 1/m
  return experiment;
}

VirtualLab lab_of(const std::vector<test::AnyTest>& experiments) {
  return test::lab_of(jersey(), experiments);
}

VirtualTable& table(const VirtualLab& lab, std::size_t i) {
  return test::experiment_of<VirtualTable>(lab, i);
}

VirtualCycles& cycles(const VirtualLab& lab, std::size_t i) {
  return test::experiment_of<VirtualCycles>(lab, i);
}

std::string file(const MeasuredFiles& files, const std::string& name) {
  for (const auto& [file_name, content] : files) {
    if (file_name == name) return content;
  }
  ADD_FAILURE() << "no file " << name;
  return "";
}

/// The study of the files, its experiments made; the files stay while it lives.
class MeasuredStudy {
 public:
  explicit MeasuredStudy(const MeasuredFiles& files) : folder_(files), study_(folder_.study()) {
    for (const ExperimentSpec& spec : study_.experiments) {
      experiments_.push_back(read_experiment(spec, study_));
    }
  }
  const Study& study() const { return study_; }
  const ComponentExperiment& operator[](size_t i) const { return *experiments_.at(i); }

 private:
  LabFolder folder_;
  Study study_;
  std::vector<std::unique_ptr<ComponentExperiment>> experiments_;
};

// Measured less predicted by the law that made the measurements.
Eigen::VectorXd residuals(const ComponentExperiment& experiment, const Material& material) {
  const auto law = law_of(material, experiment.info().component);
  const auto nuisance =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(experiment.nuisance().size()));
  return experiment.measured() - experiment.predict(*law, nuisance, false)->value;
}

TEST(VirtualLab, PathPredictionOfNoiseFreeFilesIsTheirOwnNumbers) {
  for (const MembraneMeasure measure_kind :
       {MembraneMeasure::stvk, MembraneMeasure::soft_constraint}) {
    VirtualLab lab = lab_of({hung_weights(), cycles(), shear(), bending()});
    lab.material.membrane = measure_kind;
    const MeasuredStudy measured(measurements_of(lab));
    for (size_t i = 0; i < 4; ++i) {
      // Reversals between samples are found again from the samples, to rounding.
      EXPECT_LT(residuals(measured[i], lab.material).cwiseAbs().maxCoeff(), 1e-12)
          << measured[i].info().name;
    }
  }
}

TEST(VirtualLab, RefusesSoFewRowsThatReversalsCannotBeFoundAgain) {
  VirtualLab lab = lab_of({cycles()});
  cycles(lab, 0).samples = 20;
  EXPECT_THROW(measurements_of(lab), InputError);
}

TEST(VirtualLab, PathPredictionHoldsWhereverTurnsFallBetweenSamples) {
  // At 37 samples the smallest cycle has the eight rows a leg from which turns are found.
  for (const int samples : {37, 50, 64, 100, 251, 1000}) {
    VirtualLab lab = lab_of({cycles(), shear()});
    for (std::size_t i = 0; i < 2; ++i) {
      cycles(lab, i).samples = samples;
      cycles(lab, i).repeats = 2;
    }
    const MeasuredStudy measured(measurements_of(lab));
    for (size_t i = 0; i < 2; ++i) {
      EXPECT_LT(residuals(measured[i], lab.material).cwiseAbs().maxCoeff(), 1e-12)
          << measured[i].info().name << ", " << samples << " samples";
    }
  }
}

TEST(VirtualLab, ReadsBackAsTheStudyThatWasAskedFor) {
  VirtualLab lab = lab_of({hung_weights(), cycles(), shear()});
  lab.material.membrane = MembraneMeasure::soft_constraint;
  lab.validate = {"weft-*"};
  const MeasuredStudy measured(measurements_of(lab));
  const Study& study = measured.study();
  EXPECT_EQ(study.name, "jersey");
  EXPECT_DOUBLE_EQ(study.density, 0.157);
  EXPECT_EQ(study.model.membrane, MembraneMeasure::soft_constraint);
  EXPECT_EQ(study.experiments[0].direction, "warp");
  EXPECT_DOUBLE_EQ(spec_of<HangingWeightsSpec>(study.experiments[0]).clip_mass, 0.02);
  EXPECT_DOUBLE_EQ(study.experiments[1].test->length, 0.08);
  EXPECT_DOUBLE_EQ(study.experiments[1].test->width, 0.05);
  EXPECT_EQ(study.experiments[1].role, ExperimentRole::validate);
  EXPECT_EQ(spec_of<TensileCyclesSpec>(study.experiments[1]).initial_friction,
            InitialFriction::rest);
  EXPECT_DOUBLE_EQ(spec_of<ShearCyclesSpec>(study.experiments[2]).transverse_tension, 9.8);
  EXPECT_EQ(measured[0].rows(), 3 * (3 + 5 + 7 + 9 + 11 + 13));  // [T] 5.3.2
}

TEST(VirtualLab, AMaterialWithoutDensityMakesAStudyWithoutOne) {
  VirtualLab lab = lab_of({cycles()});
  lab.material.density = 0;
  EXPECT_EQ(MeasuredStudy(measurements_of(lab)).study().density, 0);
}

TEST(VirtualLab, NamesSurviveWhateverTheyContain) {
  VirtualLab lab = lab_of({cycles()});
  lab.name = "jersey: 5 % #2 \"navy\"";
  lab.material.name = "- {odd";
  EXPECT_EQ(MeasuredStudy(measurements_of(lab)).study().name, lab.name);
}

VirtualLab noisy_lab() {
  VirtualLab lab = lab_of({hung_weights(), cycles(), shear()});
  table(lab, 0).instrument.length_noise = 2e-4;
  table(lab, 1).instrument.force_noise = 0.01;
  table(lab, 2).instrument.force_noise = 0.1;
  return lab;
}

TEST(VirtualLab, TheSameSeedMakesTheSameTextAnotherOneOtherNoise) {
  const VirtualLab lab = noisy_lab();
  EXPECT_EQ(measurements_of(lab, 7), measurements_of(lab, 7));
  for (const char* name : {"weights.csv", "weft-8cm.csv", "shear.csv"}) {
    EXPECT_NE(file(measurements_of(lab, 7), name), file(measurements_of(lab, 8), name));
  }
}

TEST(VirtualLab, NoiseOfAnExperimentDoesNotDependOnTheOthers) {
  const VirtualLab lab = noisy_lab();
  VirtualLab alone = lab;
  alone.experiments = {lab.experiments[2]};
  EXPECT_EQ(file(measurements_of(alone), "shear.csv"), file(measurements_of(lab), "shear.csv"));
}

void expect_standard_deviation(const Eigen::VectorXd& residuals, double expected) {
  const auto count = static_cast<double>(residuals.size());
  const double deviation = std::sqrt(residuals.squaredNorm() / count);
  // Four standard errors of a standard deviation from that many samples.
  EXPECT_NEAR(deviation, expected, 4 * expected / std::sqrt(2 * count)) << count << " samples";
  EXPECT_NEAR(residuals.mean(), 0, 4 * expected / std::sqrt(count));
}

TEST(VirtualLab, NoiseHasTheStatedStandardDeviation) {
  VirtualLab lab = noisy_lab();
  cycles(lab, 1).samples = cycles(lab, 2).samples = 1000;
  table(lab, 0).repeats = 20;
  const MeasuredStudy measured(measurements_of(lab));
  expect_standard_deviation(residuals(measured[0], lab.material), 2e-4);
  expect_standard_deviation(residuals(measured[1], lab.material), 0.01);
  expect_standard_deviation(residuals(measured[2], lab.material), 0.1);
}

TEST(VirtualLab, LengthNoiseOfCyclesIsInTheirLengths) {
  VirtualLab lab = lab_of({cycles()});
  const MeasuredStudy ideal(measurements_of(lab));
  table(lab, 0).instrument.length_noise = 1e-4;
  const MeasuredStudy noisy(measurements_of(lab));
  const Eigen::VectorXd& force = noisy[0].measured();
  EXPECT_EQ(force, ideal[0].measured());
  expect_standard_deviation(noisy[0].loop(force)->abscissa - ideal[0].loop(force)->abscissa, 1e-4);
}

void expect_multiples(const Eigen::VectorXd& values, double resolution) {
  for (const double value : values) {
    const double steps = value / resolution;
    EXPECT_NEAR(steps, std::round(steps), 1e-9) << value;  // rounding of the text's number
  }
}

TEST(VirtualLab, ResolutionRounds) {
  VirtualLab lab = lab_of({hung_weights(), cycles()});
  table(lab, 0).instrument.length_resolution = 5e-4;
  table(lab, 1).instrument = {0, 0, 0.02, 1e-4};
  const MeasuredStudy measured(measurements_of(lab));
  expect_multiples(measured[0].measured(), 5e-4);
  expect_multiples(measured[1].measured(), 0.02);
  expect_multiples(measured[1].loop(measured[1].measured())->abscissa, 1e-4);
  // Rounding is by half a step at most.
  EXPECT_LE(residuals(measured[0], lab.material).cwiseAbs().maxCoeff(), 2.5e-4 + 1e-12);
}

TEST(VirtualLab, SpecimensDifferByTheirNoiseAndTheirVariation) {
  VirtualLab lab = lab_of({cycles()});
  lab.specimens = 3;
  const MeasuredFiles same = measurements_of(lab);
  EXPECT_EQ(same.size(), 4U);  // and the study
  EXPECT_EQ(file(same, "weft-8cm-01.csv"), file(same, "weft-8cm-02.csv"));
  lab.specimen_variation = 0.05;
  const MeasuredFiles varied = measurements_of(lab);
  EXPECT_NE(file(varied, "weft-8cm-01.csv"), file(varied, "weft-8cm-02.csv"));
  lab.specimen_variation = 0;
  table(lab, 0).instrument.force_noise = 0.01;
  const MeasuredFiles noisy = measurements_of(lab);
  EXPECT_NE(file(noisy, "weft-8cm-01.csv"), file(noisy, "weft-8cm-02.csv"));
  EXPECT_THAT(MeasuredStudy(noisy)[0].info().specimens,
              ElementsAre("weft-8cm-01", "weft-8cm-02", "weft-8cm-03"));
}

TEST(VirtualLab, VariationBetweenSpecimensHasTheStatedSize) {
  VirtualLab lab = lab_of({cycles()});
  lab.material.components["stretch.weft"] = {};
  lab.material.components["stretch.weft"].stiffness = ScalarCurve::constant(50);
  lab.specimens = 400;
  lab.specimen_variation = 0.05;
  cycles(lab, 0).samples = 12;
  cycles(lab, 0).peaks = {0.1};
  const MeasuredStudy measured(measurements_of(lab));
  // Without friction the force is proportional to the specimen's one stiffness.
  std::vector<double> logs;
  const MeasuredPath& path = measured[0].path();
  for (size_t i = 1; i < path.force.size(); ++i) {
    const bool peak = path.direction[i] == -1 && path.direction[i - 1] == 1;
    if (peak)
      logs.push_back(std::log(path.force[i - 1] / path.factor[i - 1] / path.strain[i - 1] / 50));
  }
  ASSERT_EQ(logs.size(), 400U);
  expect_standard_deviation(Eigen::Map<const Eigen::VectorXd>(logs.data(), 400), 0.05);
}

TEST(VirtualLab, AMaterialThatCannotCarryALoadIsASolverError) {
  VirtualLab lab = lab_of({hung_weights()});
  lab.material.components["stretch.warp"].stiffness = ScalarCurve::constant(1e-4);
  lab.material.components["stretch.warp"].friction.reset();
  EXPECT_THROW(measurements_of(lab), SolverError);
}

}  // namespace
}  // namespace pliant
