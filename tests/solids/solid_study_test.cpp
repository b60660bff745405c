// Fits of solids to virtual measurements of them: numbers come back, and bad input is told.

#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/material/material_file.h"
#include "pliant/material/solid/standard_solids.h"
#include "pliant/study/result_files.h"
#include "pliant/study/study_evaluation.h"

#include "solids/bodies.h"
#include "solids/solid_labs.h"
#include "support/refusal.h"

namespace pliant {
namespace {

using test::component_of;
using test::LabFolder;
using test::linear;
using test::ogden;
using test::solid_of;
using test::solid_study;
using test::value_of;
using ::testing::Contains;
using ::testing::HasSubstr;

StudyResult fit(const LabFolder& folder, const std::string& model, const std::string& more = "") {
  return fit_study(solid_study(folder, model, more), {}, {});
}

LabFolder measured(const Material& material, double noise = 0, std::uint64_t seed = 1) {
  return LabFolder(test::measurements_of(test::lab_of(material, test::three_modes(noise)), seed));
}

/// A law of some numbers, and the model that looks for them.
struct Recovery {
  std::string model;
  Material material;
  std::map<std::string, double> numbers;
};

void PrintTo(const Recovery& recovery, std::ostream* out) { *out << recovery.model; }

std::vector<Recovery> recoveries() {
  const Addend yeoh{polynomial_addend(), Eigen::Vector3d(0.3e6, -4e3, 500)};
  const Addend chains{arruda_boyce_addend(), Eigen::Vector2d(0.5e6, 3)};
  return {
      {"law: neo-hookean",
       solid_of({{"I1-bar", component_of({linear(0.3e6)})}}),
       {{"I1-bar.linear.c", 0.3e6}}},
      {"law: mooney-rivlin",
       solid_of(
           {{"I1-bar", component_of({linear(0.3e6)})}, {"I2-bar", component_of({linear(0.02e6)})}}),
       {{"I1-bar.linear.c", 0.3e6}, {"I2-bar.linear.c", 0.02e6}}},
      {"law: yeoh",
       solid_of({{"I1-bar", component_of({yeoh})}}),
       {{"I1-bar.polynomial.c1", 0.3e6},
        {"I1-bar.polynomial.c2", -4e3},
        {"I1-bar.polynomial.c3", 500}}},
      {"law: arruda-boyce",
       solid_of({{"I1-bar", component_of({chains})}}),
       {{"I1-bar.arruda-boyce.mu", 0.5e6}, {"I1-bar.arruda-boyce.lock", 3}}},
      {"law: ogden-2",
       solid_of({{"stretch-bar", component_of({ogden(0.5e6, 1.4), ogden(3e3, 5)})}}),
       {{"stretch-bar.ogden.mu", 0.5e6},
        {"stretch-bar.ogden.alpha", 1.4},
        {"stretch-bar.ogden2.mu", 3e3},
        {"stretch-bar.ogden2.alpha", 5}}},
      {"law: stvk",
       stvk_solid(2e6, 0.6e6),
       {{"trace.k", 2e6}, {"trace-of-square.linear.c", 0.6e6}}},
      // [T] 4.2.2: StVK as a sum of interpolated energies.
      {"components: {trace: {stiffness: spline}, trace-of-square: {addends: [linear]}}",
       stvk_solid(2e6, 0.6e6),
       {{"trace.k[0]", 2e6}, {"trace-of-square.linear.c", 0.6e6}}},
  };
}

class SolidRecovery : public ::testing::TestWithParam<Recovery> {};

TEST_P(SolidRecovery, FindsTheNumbersThatMadeTheData) {
  const LabFolder folder = measured(GetParam().material);
  const StudyResult result = fit(folder, GetParam().model);
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.parameters.size(), GetParam().numbers.size());
  for (const auto& [name, value] : GetParam().numbers) {
    EXPECT_NEAR(value_of(result, name), value, 1e-8 * std::abs(value)) << name;
  }
  for (const ExperimentResult& e : result.experiments) {
    EXPECT_NEAR(e.r_squared.value(), 1, 1e-12) << e.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, SolidRecovery, ::testing::ValuesIn(recoveries()));

/// Uniaxial and equibiaxial tests of Neo-Hookean solids that differ, in one folder.
LabFolder two_modes(const std::array<double, 2>& c, const std::array<double, 2>& noise = {},
                    std::uint64_t seed = 1) {
  test::MeasuredFiles files;
  for (const std::size_t i : {0, 1}) {
    std::vector<test::AnyTest> tests = test::three_modes(noise[i]);
    tests.pop_back();
    const Material material = solid_of({{"I1-bar", component_of({linear(c[i])})}});
    const auto own = test::measurements_of(test::lab_of(material, tests), 2 * seed + i);
    for (const auto& [name, content] : own) {
      if (i == 0 || name == "equibiaxial.csv") files.emplace_back(name, content);
    }
  }
  return LabFolder(files);
}

// Differences are shares of the largest stress, which a Neo-Hookean solid multiplies: of the two
// materials c1 and c2 the sum of w (c / c_i - 1)^2 is least where c sum w / c_i^2 = sum w / c_i,
// with the mean squares of both modes alike in w.
TEST(SolidStudy, CountsExperimentsByTheirWeights) {
  const LabFolder folder = two_modes({1e5, 2e5});
  Study study = solid_study(folder, "law: neo-hookean");
  const auto c_at = [&](double weight) {
    study.experiments.front().weight = weight;
    return value_of(fit_study(study, {}, {}), "I1-bar.linear.c");
  };
  const double even = c_at(1), first = c_at(1e6), second = c_at(1e-6);
  EXPECT_GT(even, 1.2e5);
  EXPECT_LT(even, 1.8e5);
  EXPECT_NEAR(first, 1e5, 1);
  EXPECT_NEAR(second, 2e5, 2);
  // With a = sum of squares of the second mode over those of the first the two ends give `even`:
  // (1 / c1 + a / c2) / (1 / c1^2 + a / c2^2). Four times the weight of the first is a quarter of
  // a.
  const double a = (1 / first - even / (first * first)) / (even / (second * second) - 1 / second);
  EXPECT_NEAR(c_at(4),
              (1 / first + a / 4 / second) / (1 / (first * first) + a / 4 / (second * second)), 1);
}

// Both modes count alike by their stress, though one is twenty times as noisy: standard errors are
// those of this estimate, and not of the best there is.
TEST(SlowSolidStudy, KnowsTheErrorOfRowsThatCountOtherwiseThanByTheirNoise) {
  int held = 0;
  double squares = 0, told = 0;
  constexpr int kSeeds = 40;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const LabFolder folder = two_modes({1e5, 1e5}, {1e3, 2e4}, static_cast<std::uint64_t>(seed));
    const StudyResult result = fit(folder, "law: neo-hookean");
    const ParameterEstimate& c = result.parameters.front();
    squares += std::pow(c.value - 1e5, 2);
    told += std::pow(c.std_error.value(), 2);
    held += c.lower.value() < 1e5 && 1e5 < c.upper.value() ? 1 : 0;
  }
  fmt::print("{} of {} hold the truth; scatter over error {:.3g}\n", held, kSeeds,
             std::sqrt(squares / told));
  EXPECT_GE(held, 35);
  EXPECT_NEAR(std::sqrt(squares / told), 1, 0.3);
}

// A mode that is not fitted: the band by the errors of the numbers holds what was measured.
TEST(SolidStudy, TellsTheBandOfAPrediction) {
  const LabFolder folder = measured(
      solid_of({{"I1-bar", component_of({linear(3e5)})}, {"I2-bar", component_of({linear(2e4)})}}),
      /*noise=*/0);
  const StudyResult exact =
      fit_study(solid_study(folder, "law: mooney-rivlin", "validate: [planar]\n"), {}, {});
  EXPECT_THAT(exact.experiments.back().handled, Contains(HasSubstr("the 95 % band")));
  const LabFolder noisy = measured(solid_of({{"I1-bar", component_of({linear(3e5)})}}), 2e3);
  const StudyResult fitted =
      fit_study(solid_study(noisy, "law: neo-hookean", "validate: [planar]\n"), {}, {});
  EXPECT_THAT(fitted.experiments.back().handled,
              Contains(::testing::ContainsRegex("is .- 0\\.[0-9]+ % of the peak")));
  const ExperimentResult& planar = fitted.experiments.back();
  ASSERT_TRUE(planar.half_band.has_value());
  EXPECT_EQ(planar.half_band->size(), planar.predicted.size());
  const auto largest = [](const Eigen::VectorXd& rows) { return rows.cwiseAbs().maxCoeff(); };
  EXPECT_GT(largest(*planar.half_band), 1e-4 * largest(planar.predicted));
  EXPECT_LT(largest(*planar.half_band), 1e-2 * largest(planar.predicted));
  const auto files = fit_files(fitted, {});
  const auto table = std::ranges::find(files, "predictions/planar.csv",
                                       [](const auto& file) { return file.first; });
  ASSERT_NE(table, files.end());
  EXPECT_THAT(
      table->second,
      HasSubstr(",predicted_nominal_stress_Pa,low_nominal_stress_Pa,high_nominal_stress_Pa\n"));
}

// One reading in eight is a fifth too large.
TEST(SolidStudy, ARobustLossLeavesSlipsOut) {
  const LabFolder folder = two_modes({1e5, 1e5});
  std::string table = "stretch,nominal_stress_MPa\n";
  RandomStream random(3);
  for (int i = 1; i <= 40; ++i) {
    const double stretch = 1 + 0.05 * i, slip = i % 8 == 0 ? 1.2 : 1;
    const double stress = 2e5 * (stretch - std::pow(stretch, -2));  // 2 c (l - 1 / l^2)
    table += fmt::format("{:.6f},{:.6f}\n", stretch, slip * stress / 1e6 + 1e-3 * random.normal());
  }
  folder.write("uniaxial.csv", table);
  Study study = solid_study(folder, "law: neo-hookean");
  const auto error_with = [&](RobustLoss loss) {
    study.fit.loss = loss;
    const StudyResult result = fit_study(study, {}, {});
    const ParameterEstimate& c = result.parameters.front();
    fmt::print("{}: {:.6g} +- {:.2g} Pa\n", name_of(loss), c.value, c.std_error.value());
    return std::abs(c.value - 1e5);
  };
  EXPECT_GT(error_with(RobustLoss::none), 1000);
  EXPECT_LT(error_with(RobustLoss::cauchy), 100);
  EXPECT_LT(error_with(RobustLoss::huber), 300);
}

TEST(SlowSolidStudy, AConvexSplineEnergyFollowsOgdensMaterial) {
  const LabFolder folder = measured(
      solid_of({{"stretch-bar", component_of({ogden(0.5e6, 1.4), ogden(3e3, 5)})}}), 1000, 3);
  const StudyResult result = fit(folder, "law: additive");
  for (const ExperimentResult& e : result.experiments) EXPECT_GT(e.r_squared.value(), 0.999);
  const ScalarCurve& curve = *result.material.components.at("stretch-bar").stiffness;
  EXPECT_EQ(curve.kind(), CurveKind::spline);
  for (const double value : curve.values()) EXPECT_GE(value, 0);
  EXPECT_GT(curve.size(), 2);
}

TEST(SolidStudy, FindsLawsOfSolidsWhoseVolumeChanges) {
  std::vector<test::AnyTest> tests = test::three_modes();
  for (test::AnyTest& any : tests) {
    auto& own = dynamic_cast<VirtualHomogeneous&>(*any.test);
    own.incompressible = false;
    for (double& peak : own.peaks) peak = 1 + 0.2 * (peak - 1);
  }
  const Material material = neo_hookean_solid(0.3e6, 1.5e6);
  const LabFolder folder(test::measurements_of(test::lab_of(material, tests), 1));
  const StudyResult result = fit(folder, "law: neo-hookean");
  EXPECT_NEAR(value_of(result, "I1-bar.linear.c"), 0.3e6, 1e-8 * 0.3e6);
  EXPECT_NEAR(value_of(result, "J.k"), 1.5e6, 1e-8 * 1.5e6);
}

TEST(SolidStudy, FindsFrictionOnAMetric) {
  Material material = solid_of({{"I1-bar", component_of({linear(0.3e6)})},
                                {"green.xx", component_of(ScalarCurve::constant(1e4))}});
  material.components["green.xx"].friction = ComponentFriction{{2e4, 5e3, 0.2}, {}};
  VirtualHomogeneous cycles = test::homogeneous(HomogeneousMode::uniaxial, {1.4, 1.8});
  cycles.cycles = true;
  cycles.samples = 60;
  const LabFolder folder(test::measurements_of(test::lab_of(material, cycles), 1));
  const StudyResult result =
      fit(folder,
          "components: {I1-bar: {addends: [linear]}, green.xx: {stiffness: constant, friction: "
          "dahl}}");
  EXPECT_NEAR(value_of(result, "I1-bar.linear.c"), 0.3e6, 1e-6 * 0.3e6);
  EXPECT_NEAR(value_of(result, "green.xx.friction.a"), 2e4, 1e-5 * 2e4);
  EXPECT_NEAR(value_of(result, "green.xx.friction.tau"), 0.2, 1e-5 * 0.2);
}

/// Mooney and Rivlin, addend by addend.
constexpr const char* kTwoAddends =
    "components: {I1-bar: {addends: [linear]}, I2-bar: {addends: [linear]}}";

LabFolder mooney_rubber() {
  return measured(solid_of(
      {{"I1-bar", component_of({linear(0.3e6)})}, {"I2-bar", component_of({linear(0.02e6)})}}));
}

// [T] 4.4: addend after addend, each from what tells it; then all of them.
TEST(SolidStudy, FollowsThePlanOfItsStages) {
  const StudyResult result =
      fit(mooney_rubber(), kTwoAddends,
          "fit:\n  plan:\n    - {components: [I1-bar], experiments: [uniaxial]}\n"
          "    - {components: [I2-bar], experiments: [equibiaxial, planar]}\n");
  EXPECT_NEAR(value_of(result, "I1-bar.linear.c"), 0.3e6, 1e-8 * 0.3e6);
  EXPECT_NEAR(value_of(result, "I2-bar.linear.c"), 0.02e6, 1e-8 * 0.02e6);
  ASSERT_EQ(result.stages.size(), 3u);
  EXPECT_EQ(result.stages[0].name, "stage I1-bar");
  EXPECT_EQ(result.stages[1].name, "stage I2-bar");
  // The line on I1 alone, from one test, leaves what the second addend is for.
  EXPECT_GT(result.stages[0].rms, 0.1);
  EXPECT_LT(result.stages[2].rms, 1e-6);
}

TEST(SolidStudy, RefusesAPlanOfWhatIsNotThere) {
  const auto refusal = [](const std::string& stage) {
    const InputError error = test::input_error_of(
        [&] { fit(mooney_rubber(), kTwoAddends, "fit:\n  plan: [" + stage + "]\n"); });
    return std::string(error.what());
  };
  EXPECT_THAT(refusal("{components: [J], experiments: [planar]}"),
              HasSubstr("fit.plan[0]: \"J\" is no component of the model"));
  EXPECT_THAT(refusal("{components: [I1-bar], experiments: [pull]}"),
              HasSubstr("\"pull\" matches no experiment that is fitted"));
}

TEST(SlowSolidStudy, StandardErrorsCoverTheTruth) {
  constexpr int kSeeds = 40;
  int covered = 0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const LabFolder folder = measured(solid_of({{"I1-bar", component_of({linear(0.3e6)})}}), 5000,
                                      static_cast<std::uint64_t>(seed));
    const StudyResult result = fit(folder, "law: neo-hookean");
    const ParameterEstimate& c = result.parameters.front();
    covered += *c.lower <= 0.3e6 && 0.3e6 <= *c.upper;
  }
  // 95 % of 40 is 38; fewer than 34 would come by chance in one of 100.
  EXPECT_GE(covered, 34);
}

TEST(SolidStudy, PredictsWhatIsKeptOutOfTheFitAndWhatAMaterialFileHolds) {
  const LabFolder folder =
      measured(solid_of({{"stretch-bar", component_of({ogden(0.5e6, 1.4), ogden(3e3, 5)})}}));
  const Study study = solid_study(folder, "law: ogden-2", "validate: [planar]\n");
  const StudyResult result = fit_study(study, {}, {});
  EXPECT_EQ(result.experiments.back().role, ExperimentRole::validate);
  EXPECT_NEAR(result.experiments.back().r_squared.value(), 1, 1e-9);
  folder.write("material.json", material_text(result.material));
  const Material material = read_material(folder.path() / "material.json");
  EXPECT_EQ(material.kind, MaterialKind::solid);
  const StudyResult again = evaluate_study(study, material, {}, {});
  for (const ExperimentResult& e : again.experiments) {
    EXPECT_NEAR(e.r_squared.value(), 1, 1e-9) << e.name;
  }
}

TEST(SolidStudy, AsksWhetherStressesAreTrueOnes) {
  const LabFolder folder = measured(solid_of({{"I1-bar", component_of({linear(0.3e6)})}}));
  EXPECT_TRUE(fit(folder, "law: neo-hookean").questions.empty());
  // Of an incompressible solid the true stress along 1 is the nominal one times the stretch.
  const LabFolder other = measured(solid_of({{"I1-bar", component_of({linear(0.3e6)})}}));
  for (const char* mode : {"uniaxial", "equibiaxial", "planar"}) {
    const CsvTable table = read_csv(other.path() / (std::string(mode) + ".csv"));
    const std::vector<double> stretch = table.numbers("stretch");
    const std::vector<double> stress = table.numbers("nominal_stress_Pa");
    std::string text = "stretch,nominal_stress_Pa\n";
    for (std::size_t i = 0; i < stretch.size(); ++i) {
      text += fmt::format("{},{}\n", stretch[i], stretch[i] * stress[i]);
    }
    other.write(std::string(mode) + ".csv", text);
  }
  const StudyResult result = fit(other, "law: neo-hookean");
  ASSERT_EQ(result.questions.size(), 1u);
  EXPECT_THAT(result.questions.front(), HasSubstr("if they were true"));
  EXPECT_THAT(result.questions.front(), HasSubstr("1.0000"));
  // A law that stresses fall short of where the stretch is largest is no reason to ask.
  const LabFolder softer = measured(solid_of({{"stretch-bar", component_of({ogden(0.4e6, 0.6)})}}));
  EXPECT_TRUE(fit(softer, "law: neo-hookean").questions.empty());
}

std::string study_of(const std::string& experiment, const std::string& model) {
  return "pliant: study/1\nname: rubber\nexperiments:\n  - " + experiment + "\nmodel: " + model +
         "\n";
}

// A pull along the axes strains no component of shear, which the moved body has.
TEST(SolidStudy, RefusesATestThatShowsNothingOfTheMaterial) {
  std::vector<test::AnyTest> tests{test::three_modes().front(), test::moved_block({2, 1, 1})};
  const LabFolder folder(
      test::measurements_of(test::lab_of(neo_hookean_solid(1e5, 1e6), tests), 1));
  const Study study = solid_study(folder, "components: {green.xy: {stiffness: constant}}");
  const InputError error = test::input_error_of([&] { fit_study(study, {}, {}); });
  EXPECT_THAT(error.problem(), HasSubstr("\"uniaxial\" shows nothing of the material"));
  EXPECT_EQ(error.where().field, "experiments");
}

TEST(SolidStudy, RefusesBadInputWhereItStands) {
  const test::TemporaryFolder folder;
  folder.write("good.csv", "stretch,nominal_stress_MPa\n1.1,0.1\n1.5,0.4\n2,0.6\n");
  folder.write("zero.csv", "stretch,nominal_stress_MPa\n1.1,0.1\n0,0.4\n2,0.6\n");
  folder.write("modes.csv",
               "mode,stretch,nominal_stress_MPa\nuniaxial,1.1,0.1\nuniaxail,1.5,0.4\nplanar,2,1\n");
  const std::string good = "{name: pull, type: homogeneous, mode: uniaxial, data: good.csv}";
  const auto refused = [&](const std::string& experiment, const std::string& model) {
    folder.write("study.yaml", study_of(experiment, model));
    return test::input_error_of(
        [&] { fit_study(read_study(folder.path() / "study.yaml"), {}, {}); });
  };
  const InputError zero =
      refused("{name: pull, type: homogeneous, mode: uniaxial, data: zero.csv}", "{kind: solid}");
  EXPECT_EQ(zero.where().line, 3);
  EXPECT_THAT(std::string(zero.what()), HasSubstr("stretch 0 is not above 0"));
  folder.write("second.csv",
               "stretch,stretch_2,nominal_stress_MPa\n1.1,1,0.1\n1.5,1,0.4\n2,-1.2,0.6\n");
  const InputError second =
      refused("{name: pull, type: homogeneous, mode: biaxial, data: second.csv}", "{kind: solid}");
  EXPECT_EQ(second.where().line, 4);
  EXPECT_THAT(std::string(second.what()), HasSubstr("stretch_2: the stretch -1.2 is not above 0"));
  const InputError mode =
      refused("{name: pull, type: homogeneous, data: modes.csv}", "{kind: solid}");
  EXPECT_EQ(mode.where().line, 3);
  EXPECT_THAT(std::string(mode.what()), HasSubstr("uniaxail"));
  const InputError law = refused(good, "{kind: solid, law: neohookean}");
  EXPECT_EQ(law.where().line, 5);
  EXPECT_THAT(std::string(law.what()), HasSubstr("neo-hookean"));
  // A shear strain does not change where a specimen is pulled along its axes.
  EXPECT_THAT(std::string(refused(good,
                                  "{kind: solid, components: {green.xy: {stiffness: "
                                  "constant}}}")
                              .what()),
              HasSubstr("changes in no experiment"));
  folder.write("strip.csv", "length_mm,force_N\n80,0\n90,12\n85,3\n");
  const InputError cloth = refused(
      good +
          "\n  - {name: strip, type: tensile-cycles, direction: warp, data: strip.csv, length: "
          "80 mm, width: 40 mm}",
      "{kind: solid}");
  EXPECT_EQ(cloth.where().line, 5);
  EXPECT_THAT(cloth.problem(), HasSubstr("\"strip\" is of cloth"));
  // What a fit of a solid would not heed.
  for (const auto& [option, line] :
       {std::pair<std::string, std::string>{"monotone_stress", "monotone_stress: true"},
        {"plan", "plan: [{components: [shear], experiments: [pull]}]"}}) {
    const InputError error = refused(good, "{kind: solid}\nfit: {" + line + "}");
    EXPECT_THAT(error.where().field, HasSubstr("fit." + option));
  }
  EXPECT_EQ(refused(good, "{kind: solid, law: yeoh, limits: [{of: [J]}]}").where().field,
            "model.limits");
  EXPECT_THAT(std::string(refused(good,
                                  "{kind: solid, components: {stretch: {stiffness: spline, "
                                  "friction: dahl}}}")
                              .what()),
              HasSubstr("remembers"));
  EXPECT_THAT(std::string(refused("{name: pull, type: homogeneous, mode: uniaxial, data: good.csv, "
                                  "incompressible: false}",
                                  "{kind: solid, components: {I1-bar: {addends: [linear]}}}")
                              .what()),
              HasSubstr("resists a change of volume"));
}

}  // namespace
}  // namespace pliant
