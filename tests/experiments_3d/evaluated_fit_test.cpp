// `evaluate` predicts with a fitted material what the fit itself predicted: it finds what the fit
// told of cords and offsets beside the material.

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/material/material_file.h"
#include "pliant/study/result_files.h"
#include "pliant/study/study_evaluation.h"
#include "pliant/study/study_fit.h"

#include "support/virtual_lab.h"

namespace pliant {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr const char* kCloth = R"({
  "pliant": "material/1", "name": "cloth", "kind": "cloth", "density": 0.15, "membrane": "stvk",
  "bending": "discrete-shells", "bending_of": "sheet",
  "components": {
    "stretch.weft": {"stiffness": {"curve": "constant", "value": 120}},
    "stretch.warp": {"stiffness": {"curve": "constant", "value": 200}},
    "shear": {"stiffness": {"curve": "constant", "value": 20}},
    "bend.weft": {"stiffness": {"curve": "constant", "value": 5e-6}},
    "bend.warp": {"stiffness": {"curve": "constant", "value": 8e-6}},
    "bend.diagonal": {"stiffness": {"curve": "constant", "value": 6e-6}}
  }
})";

constexpr const char* kLab = R"(pliant: lab/1
name: cloth
material: cloth.json
experiments:
  - {name: stretch, type: session, test: stretch-warp, strain: 3 %, frames: 16, mesh: {nodes: 7x7},
     noise: {position: 0.02 mm, force: 3 mN}, cord_friction: 0.3 N}
)";

const std::string kDigest(64, 'a');

/// A stretch over cords that rub, fitted; its results stand in the folder.
class EvaluatedFit : public ::testing::Test {
 protected:
  EvaluatedFit() : folder_(measured()) {
    folder_.set_model("mesh: measured, friction: none");
    fit_ = fit_study(folder_.study(), {}, {});
    const RunFacts facts{"", "2020-01-02T03:04:05Z", "1", "study.yaml", kDigest, ""};
    for (const auto& [name, content] : fit_files(fit_, facts)) folder_.write(name, content);
  }

  static test::MeasuredFiles measured() {
    const test::TemporaryFolder lab;
    lab.write("cloth.json", kCloth);
    return test::measurements_of(read_lab(lab.write("lab.yaml", kLab)), 0);
  }

  StudyResult evaluate(bool with_nuisance) const {
    const std::filesystem::path file = folder_.path() / "material.json";
    const Material material = read_material(file);
    FoundNuisance found;
    if (with_nuisance) found = nuisance_beside(file, material, kDigest);
    return evaluate_study(folder_.study(), material, {}, found);
  }

  test::LabFolder folder_;
  StudyResult fit_;
};

TEST_F(EvaluatedFit, IsPredictedAsTheFitPredictsIt) {
  const StudyResult result = evaluate(true);
  const double fitted = fit_.experiments.front().rms;
  EXPECT_NEAR(result.experiments.front().rms, fitted, 1e-3 * fitted);
  EXPECT_THAT(result.questions, IsEmpty());
}

TEST_F(EvaluatedFit, AsksForTheFrictionOfCordsThatIsNotKnown) {
  const StudyResult result = evaluate(false);
  EXPECT_GT(result.experiments.front().rms, 2 * fit_.experiments.front().rms);
  EXPECT_THAT(result.questions, Contains(HasSubstr("the friction of the cords of stretch")));
}

TEST_F(EvaluatedFit, OfAnotherFitTellsNothing) {
  const std::filesystem::path file = folder_.path() / "material.json";
  Material material = read_material(file);
  EXPECT_FALSE(nuisance_beside(file, material, kDigest).cords.empty());
  material.provenance["created"] = "2021-01-02T03:04:05Z";
  EXPECT_TRUE(nuisance_beside(file, material, kDigest).cords.empty());
}

}  // namespace
}  // namespace pliant
