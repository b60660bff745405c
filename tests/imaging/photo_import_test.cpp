// Photographs become a study whose fit finds the stiffness that bent the strip.

#include "pliant/imaging/photo_import.h"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/quantity.h"
#include "pliant/material/bending_strain.h"
#include "pliant/study/study.h"

#include "imaging/drawn_strip.h"
#include "io/temporary_folder.h"

namespace pliant {
namespace {

using test::draw_strips;
using test::DrawnStrip;
using test::elastic_profile;
using test::TemporaryFolder;
using ::testing::HasSubstr;

constexpr double kDensity = 0.2;  // kg/m^2

PhotoStudyOptions options() {
  PhotoStudyOptions options;
  options.name = "drawn";
  options.direction = "warp";
  options.density = kDensity;
  options.width = 0.025;
  options.photo.scale = 1.0 / 8000;
  return options;
}

/// A folder with photographs and the study that they were imported to.
class ImportFolder : public TemporaryFolder {
 public:
  std::filesystem::path draw(const std::string& name, double rigidity, double length,
                             const DrawnStrip& look = {}) const {
    const auto file = path() / name;
    draw_strips(file, {elastic_profile(rigidity, kDensity * kStandardGravity, length)}, look);
    return file;
  }

  Study import(const std::vector<std::filesystem::path>& photos) {
    imported = import_photos(photos, options());
    for (const auto& [name, content] : imported.files) write(name, content);
    return read_study(write("study.yaml", imported.study_yaml));
  }

  ImportedStudy imported;
};

// Least squares over the constant stiffness alone.
double fitted_stiffness(const ComponentExperiment& experiment, double start) {
  ComponentLaw law;
  law.stiffness = ScalarCurve::constant(start);
  for (int i = 0; i < 20; ++i) {
    const auto prediction = experiment.predict(law, {}, true);
    if (!prediction) return 0;
    const auto jacobian = prediction->jacobian.col(0);
    const double step = -jacobian.dot(prediction->value) / jacobian.squaredNorm();
    law.stiffness = ScalarCurve::constant(law.stiffness.value(0) + step);
  }
  return law.stiffness.value(0);
}

TEST(SlowPhotoImport, GivesTheStiffnessOfADrawnStripBack) {
  for (const double rigidity : {5e-6, 2e-5, 1e-4}) {
    for (const bool noisy : {false, true}) {
      ImportFolder folder;
      DrawnStrip look;
      if (noisy) look.noise = 0.04;
      const auto photo = folder.draw("strip.png", rigidity, 0.08, look);
      const Study study = folder.import({photo});
      const auto experiment = read_experiment(study.experiments.front(), study);
      const double k = rigidity / kStrainPerCurvature;
      EXPECT_NEAR(fitted_stiffness(*experiment, 0.8 * k), k, 0.02 * k) << rigidity << noisy;
    }
  }
}

TEST(PhotoImport, WritesAStudyThatSaysWhereItCameFrom) {
  ImportFolder folder;
  const auto first = folder.draw("a.png", 2e-5, 0.06), second = folder.draw("b.png", 2e-5, 0.09);
  const Study study = folder.import({first, second});
  EXPECT_EQ(study.name, "drawn");
  EXPECT_DOUBLE_EQ(study.density, kDensity);
  EXPECT_EQ(study.info.at("source"), "photographs a.png, b.png");
  ASSERT_EQ(study.experiments.size(), 1u);
  const ExperimentSpec& spec = study.experiments.front();
  EXPECT_EQ(spec.type, "cantilever");
  EXPECT_EQ(spec.direction, "warp");
  EXPECT_DOUBLE_EQ(spec.test->width, 0.025);
  const auto experiment = read_experiment(spec, study);
  EXPECT_EQ(experiment->rows(), 62);  // two profiles of 31 points
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "a-profile.png"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "b-profile.png"));
  EXPECT_THAT(folder.imported.notes.front(), HasSubstr("a.png: a strip brighter than its "));
}

TEST(PhotoImport, WarnsOfAClampThatIsNotLevel) {
  ImportFolder folder;
  std::vector<Eigen::Vector2d> straight;
  for (int i = 0; i <= 50; ++i) straight.emplace_back(0.0015 * i, -0.0003 * i);
  draw_strips(folder.path() / "tilted.png", {straight});
  folder.import({folder.path() / "tilted.png"});
  ASSERT_EQ(folder.imported.warnings.size(), 1u);
  EXPECT_THAT(folder.imported.warnings[0], HasSubstr("degrees below level"));
}

}  // namespace
}  // namespace pliant
