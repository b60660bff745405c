// A stiff weave of a few per cent of strain, whose curves begin with a toe.

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/base/random.h"
#include "pliant/experiment/session/sheet_path.h"
#include "pliant/experiment/session/strip_sheets.h"
#include "pliant/material/material_file.h"
#include "pliant/measurement/session/frame_measures.h"
#include "pliant/study/study_fit.h"

#include "support/study_folder.h"
#include "support/virtual_lab.h"

namespace pliant {
namespace {

RunContext two_threads() {
  RunContext context;
  context.threads = 2;
  return context;
}

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
  const StudyResult fit = fit_study(folder.study(), {}, two_threads());
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

/// The same as a sheet, thirty times softer on the bias, where it rubs.
constexpr const char* kSheet = R"({
  "pliant": "material/1", "name": "weave", "kind": "cloth", "density": 0.2, "membrane": "stvk",
  "bending": "discrete-shells", "bending_of": "hinges",
  "components": {
    "stretch.weft": {"stiffness": {"curve": "hermite", "strain": [0, 0.02, 0.04], "value": [300, 12000, 30000]}},
    "stretch.warp": {"stiffness": {"curve": "hermite", "strain": [0, 0.02, 0.04], "value": [300, 20000, 40000]}},
    "shear": {"stiffness": {"curve": "hermite", "strain": [0, 0.04, 0.08], "value": [10, 200, 600]},
              "friction": {"law": "dahl", "a": 1.5, "b": 0, "tau": 0.004}},
    "bend.weft": {"stiffness": {"curve": "constant", "value": 5e-6}},
    "bend.warp": {"stiffness": {"curve": "constant", "value": 5e-6}},
    "bend.diagonal": {"stiffness": {"curve": "constant", "value": 5e-6}}
  }
})";

constexpr double kWidth = 0.04;  // m

std::string strip_text(const std::string& name, const std::string& direction, double length) {
  return fmt::format(
      "{{name: {0}, type: tensile-cycles, data: {0}.csv, direction: {1}, length: {2} mm, width: 40 "
      "mm, initial_friction: rest}}",
      name, direction, 1e3 * length);
}

std::string rows_text(const std::vector<double>& lengths, const std::vector<double>& forces) {
  std::string text = "force_N,length_mm\n";
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    text += fmt::format("{},{}\n", forces[i], 1e3 * lengths[i]);
  }
  return text;
}

/// What a tester would record of a strip of the sheet that is pulled by 2 and 4 %.
void pull(const test::StudyFolder& folder, const std::string& name, const std::string& direction,
          double length, double noise, RandomStream& random) {
  constexpr int kRows = 40;  // of a half cycle of the larger amplitude
  std::vector<double> lengths, forces;
  for (const double peak : {0.02, 0.04}) {
    const int half = static_cast<int>(kRows * peak / 0.04);
    for (int i = 0; i < half; ++i) lengths.push_back(length * (1 + peak * i / half));
    for (int i = half; i > 0; --i) lengths.push_back(length * (1 + peak * i / half));
  }
  // A line that rises: none of it is slack, and all rows become frames.
  for (const double now : lengths) forces.push_back(1 + now / length);
  folder.write(name + ".csv", rows_text(lengths, forces));
  const Study study = folder.study(strip_text(name, direction, length), "model: {strips: sheet}\n");
  const ExperimentSpec& spec = study.experiments.front();
  const SheetTest strip =
      std::move(sheets_of_strips(spec, DataRows(spec.data), study.model, 0).tests.front());
  const Material cloth = read_material(folder.write("sheet.json", kSheet));
  SheetPath path(strip.session(), cloth);
  const auto shapes = path.predict(path.parameters(), {}, 2, {});
  ASSERT_TRUE(shapes.has_value());
  lengths.clear();
  forces.clear();
  for (int frame = 0; frame < strip.frame_count(); ++frame) {
    const SheetShape& shape = (*shapes)[static_cast<std::size_t>(frame)];
    lengths.push_back(length + *clip_extension(strip.session(), frame));
    forces.push_back(strip.predicted(frame, shape)(0) + noise * random.normal());
  }
  folder.write(name + ".csv", rows_text(lengths, forces));
}

/// In % of the peaks.
void expect_long_met_and_short_predicted(const StudyResult& fit) {
  ASSERT_EQ(fit.experiments.size(), 6U);
  for (const ExperimentResult& experiment : fit.experiments) {
    std::printf("%s %.2f %%\n", experiment.name.c_str(), experiment.rms_percent);
    EXPECT_LT(experiment.rms_percent, experiment.role == ExperimentRole::fit ? 1 : 2)
        << experiment.name;
  }
}

TEST(SlowStiffWeave, SoftOnTheBiasTellsItsShortStripsByItsLongOnes) {
  const test::StudyFolder folder;
  RandomStream random(1);
  std::string strips;
  for (const char* direction : {"weft", "warp", "bias"}) {
    const double noise = direction == std::string("bias") ? 2e-3 : 50e-3;
    for (const int length : {80, 20}) {
      const std::string name = fmt::format("{}{}", direction, length);
      pull(folder, name, direction, 1e-3 * length, noise, random);
      strips += (strips.empty() ? "" : "\n  - ") + strip_text(name, direction, 1e-3 * length);
    }
  }
  const StudyResult fit = fit_study(
      folder.study(strips, "model: {strips: sheet}\nvalidate: [weft20, warp20, bias20]\n"), {},
      two_threads());
  expect_long_met_and_short_predicted(fit);
}

/// On the bias what strips of one dimension have.
constexpr const char* kStrips = R"({
  "pliant": "material/1", "name": "weave", "kind": "cloth", "density": 0.2, "membrane": "stvk",
  "components": {
    "stretch.weft": {"stiffness": {"curve": "hermite", "strain": [0, 0.02, 0.04], "value": [300, 12000, 30000]}},
    "stretch.warp": {"stiffness": {"curve": "hermite", "strain": [0, 0.02, 0.04], "value": [300, 20000, 40000]}},
    "stretch.bias": {"stiffness": {"curve": "hermite", "strain": [0, 0.02, 0.04], "value": [10, 400, 1000]},
                     "friction": {"law": "dahl", "a": 1.2, "b": 10, "tau": 0.004}}
  }
})";

TEST(StiffWeave, OfOneDimensionTellsItsShortStripsByItsLongOnes) {
  const test::TemporaryFolder lab;
  lab.write("weave.json", kStrips);
  std::string text =
      "pliant: lab/1\nname: weave\nmaterial: weave.json\nvalidate: [weft20, warp20, bias20]\n"
      "experiments:\n";
  for (const char* direction : {"weft", "warp", "bias"}) {
    for (const int length : {80, 20}) {
      text += fmt::format(
          "  - {{name: {0}{1}, type: tensile-cycles, direction: {0}, length: {1} mm, width: 40 mm, "
          "peaks: [2 %, 4 %], samples: 200, noise: {{force: {2} mN}}}}\n",
          direction, length, direction == std::string("bias") ? 2 : 50);
    }
  }
  test::LabFolder folder(test::measurements_of(read_lab(lab.write("lab.yaml", text)), 0));
  const StudyResult fit = fit_study(folder.study(), {}, two_threads());
  expect_long_met_and_short_predicted(fit);
}

}  // namespace
}  // namespace pliant
