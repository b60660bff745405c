// Strips of a stiff weave, whose curves begin with a toe, are fitted as sheets.

#include <cstdio>

#include <gtest/gtest.h>

#include "pliant/study/study_fit.h"

#include "support/virtual_lab.h"

namespace pliant {
namespace {

/// Nearly free at rest, and a hundred times as stiff at some per cent.
constexpr const char* kWeave = R"({
  "pliant": "material/1", "name": "weave", "kind": "cloth", "density": 0.2, "membrane": "stvk",
  "components": {
    "stretch.weft": {"stiffness": {"curve": "hermite", "strain": [0, 0.02, 0.04], "value": [300, 12000, 30000]}},
    "stretch.warp": {"stiffness": {"curve": "hermite", "strain": [0, 0.01, 0.02], "value": [300, 20000, 40000]}}
  }
})";

constexpr const char* kLab = R"(pliant: lab/1
name: weave
material: weave.json
experiments:
  - {name: weft, type: tensile-cycles, direction: weft, length: 80 mm, width: 40 mm, peaks: [2 %, 4 %], samples: 200,
     slack: 0.7 mm, noise: {force: 50 mN}}
  - {name: warp, type: tensile-cycles, direction: warp, length: 80 mm, width: 40 mm, peaks: [1 %, 2 %], samples: 200,
     slack: 0.7 mm, noise: {force: 50 mN}}
)";

TEST(SlowStiffWeave, OfStripsWithAToeIsFittedAsASheet) {
  const test::TemporaryFolder lab;
  lab.write("weave.json", kWeave);
  test::LabFolder folder(test::measurements_of(read_lab(lab.write("lab.yaml", kLab)), 0));
  folder.set_model("strips: sheet, friction: none");
  RunContext context;
  context.threads = 2;
  const StudyResult fit = fit_study(folder.study(), {}, context);
  ASSERT_EQ(fit.experiments.size(), 2U);
  for (const ExperimentResult& experiment : fit.experiments) {
    std::printf("%s %.2f %%\n", experiment.name.c_str(), experiment.rms_percent);
    // Five control points at most go through a toe and forty times its stiffness.
    EXPECT_LT(experiment.rms_percent, 1) << experiment.name;
  }
  for (const char* component : {"stretch.weft", "stretch.warp"}) {
    EXPECT_GT(law_of(fit.material, component)->stiffness.value(0), 0) << component;
  }
}

}  // namespace
}  // namespace pliant
