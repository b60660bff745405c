// Experiments that disagree, and what a study says that each counts ([T] 4.3). Those of solids:
// tests/solids/solid_study_test.cpp.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/study/study_fit.h"

#include "estimation/virtual_study.h"
#include "io/temporary_folder.h"
#include "support/virtual_sheets.h"

namespace pliant {
namespace {

constexpr double kSoft = 80, kStiff = 120;  // N/m

/// The stiffness that is fitted to two tests, of a soft and a stiff cloth.
using Fit = double (*)(double weight_of_soft);

/// @param error  of what one of both tells
void expect_between(const Fit fit, double error) {
  const double even = fit(1);
  EXPECT_GT(even, kSoft + 5);
  EXPECT_LT(even, kStiff - 5);
  EXPECT_NEAR(fit(1e8), kSoft, error);
  EXPECT_NEAR(fit(1e-8), kStiff, error);
  EXPECT_LT(fit(4), even - 1);
}

// As noisy as they disagree: without noise the one that is met exactly would count alone.
TEST(ExperimentWeights, LeadAFitOfStrips) {
  expect_between(
      [](double weight) {
        test::MeasuredFiles files;
        for (const double k : {kSoft, kStiff}) {
          ComponentLaw law;
          law.stiffness = ScalarCurve::constant(k);
          std::vector<test::AnyTest> tests;
          for (const char* name : {"soft", "stiff"}) {
            auto cycles = test::strip_cycles({0.1, 0.2});
            cycles.name = name;
            cycles.instrument.force_noise = 0.2;
            tests.emplace_back(cycles);
          }
          const auto own = test::measurements_of(
              test::lab_of(test::made_up_material("stretch.warp", law), tests));
          for (const auto& [name, content] : own) {
            if (k == kSoft || name == "stiff.csv") files.emplace_back(name, content);
          }
        }
        const test::LabFolder folder(files);
        Study study = folder.study();
        study.model.components["stretch.warp"].stiffness = CurveKind::constant;
        study.model.components["stretch.warp"].friction = FrictionChoice::none;
        study.experiments.front().weight = weight;
        return test::estimate_named(fit_study(study, {}, {}), "stretch.warp.k").value;
      },
      8);
}

TEST(ExperimentWeights, LeadAFitOfSheets) {
  expect_between(
      [](double weight) {
        const test::TemporaryFolder folder;
        for (const double k : {kSoft, kStiff}) {
          Material cloth = test::sheet_cloth(false);
          cloth.components.at("stretch.weft").stiffness = ScalarCurve::hermite({0.0}, {k});
          cloth.components.at("stretch.warp").stiffness = ScalarCurve::hermite({0.0}, {100.0});
          write_session(folder.path() / (k == kSoft ? "soft" : "stiff"),
                        test::virtual_stretch(cloth, 0, 7, 4));
        }
        folder.write("study.yaml",
                     fmt::format("pliant: study/1\nname: two\nexperiments:\n"
                                 "  - {{name: soft, type: session, data: soft, weight: {:.0e}}}\n"
                                 "  - {{name: stiff, type: session, data: stiff}}\n"
                                 "model: {{mesh: measured}}\nfit: {{control_points: 1}}\n",
                                 weight));
        const StudyResult result = fit_study(read_study(folder.path() / "study.yaml"), {}, {});
        for (const ParameterEstimate& p : result.parameters) {
          if (p.owner == "stretch.weft") return p.value;
        }
        return 0.0;
      },
      0.5);
}

}  // namespace
}  // namespace pliant
