#include "pliant/experiment/moved_body/moved_body.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/experiment/stored_rows.h"
#include "pliant/geometry/block_mesh.h"
#include "pliant/material/material_file.h"
#include "pliant/material/material_samples.h"
#include "pliant/material/solid/standard_solids.h"

#include "io/input_error_of.h"
#include "solids/bodies.h"
#include "solids/solid_labs.h"

namespace pliant {
namespace {

using test::LabFolder;
using ::testing::HasSubstr;

/// Neo-Hookean along x, twice as stiff at one end as at the other; the volume alike everywhere.
Material graded_block() {
  Material material = neo_hookean_solid(15e3, 60e3);
  material.samples.width = 0.015;
  for (const double share : {0.0, 1.0}) {
    SampledComponents sample{{0.04 * share, 0.01, 0.01}, {}};
    sample.components["I1-bar"] = scaled(material.components.at("I1-bar"), 1 + share);
    material.samples.at.push_back(sample);
  }
  take_means(material);
  return material;
}

std::unique_ptr<Experiment> experiment_of(const Study& study) {
  const ExperimentSpec& spec = study.experiments.front();
  return spec.test->type().make_solid(spec, DataRows(spec.data));
}

LabFolder measured(const Material& material, VirtualMovedBody body) {
  return LabFolder(test::measurements_of(test::lab_of(material, {std::move(body)}), 1));
}

StoredRows predicted(const Experiment& experiment, Predictor& predictor,
                     const Eigen::VectorXd& values, const std::vector<int>& by) {
  StoredRows rows(experiment, std::ssize(by));
  EXPECT_TRUE(predictor.predict(values, by, {}, rows));
  return rows;
}

TEST(MovedBody, IsDifferentiatedByTheNumbersOfItsSamples) {
  const Material material = graded_block();
  const LabFolder folder = measured(material, test::moved_block());
  const auto experiment = experiment_of(test::solid_study(folder, "law: neo-hookean"));
  const auto predictor = experiment->predictor(material);
  EXPECT_THAT(predictor->parameters(),
              ::testing::UnorderedElementsAre("samples[0].I1-bar.linear.c",
                                              "samples[1].I1-bar.linear.c", "J.k"));
  const Eigen::VectorXd values = predictor->values();
  const std::vector<int> all{0, 1, 2};
  const Eigen::MatrixXd by = predicted(*experiment, *predictor, values, all).rows().by;
  for (const int p : all) {
    const double change = 1e-4 * values(p);
    Eigen::VectorXd more = values, less = values;
    more(p) += change;
    less(p) -= change;
    const Eigen::VectorXd difference = (predicted(*experiment, *predictor, more, {}).rows().value -
                                        predicted(*experiment, *predictor, less, {}).rows().value) /
                                       (2 * change);
    EXPECT_LT((by.col(p) - difference).norm(), 1e-4 * difference.norm()) << p;
  }
}

// Of a bar without Poisson effect whose stiffness is the mean of two samples far away.
TEST(MovedBody, IsPulledByTheForceOfItsLaw) {
  Material material = stvk_solid(0, 10e3);
  VirtualMovedBody bar = test::moved_block();
  bar.shifts = {{0.004, 0, 0}};
  const LabFolder folder = measured(material, bar);
  const auto experiment = experiment_of(test::solid_study(folder, "law: stvk"));
  const double stretch = 1.1, strain = (stretch * stretch - 1) / 2;
  const double force = 0.02 * 0.02 * stretch * 2 * 10e3 * strain;
  const auto& test = dynamic_cast<const MovedBodyTest&>(*experiment);
  EXPECT_NEAR(test.measured()(0) * test.readings()[0].noise, force, 1e-4 * force);
}

TEST(MovedBody, FollowsFrictionThroughItsFrames) {
  Material material = neo_hookean_solid(15e3, 60e3);
  material.components["green.xx"].stiffness = ScalarCurve::constant(0);
  material.components["green.xx"].friction = ComponentFriction{{500, 0, 0.01}, {}};
  VirtualMovedBody body = test::moved_block();
  body.shifts = {{0.002, 0, 0}, {0.004, 0, 0}, {0.002, 0, 0}};
  const LabFolder folder = measured(material, body);
  const auto experiment = experiment_of(test::solid_study(folder, "law: neo-hookean"));
  const auto& test = dynamic_cast<const MovedBodyTest&>(*experiment);
  const std::vector<Frame> frames = test.frames();
  const auto pull = [&](std::size_t frame) { return test.measured()(frames[frame].first); };
  EXPECT_GT(pull(0), 1.05 * pull(2)) << "on the way back it pulls less";
}

TEST(HeterogeneousMaterial, IsReadAsItWasWritten) {
  const Material material = graded_block();
  const LabFolder folder({{"graded.json", material_text(material)}});
  const Material read = read_material(folder.path() / "graded.json");
  ASSERT_EQ(read.samples.at.size(), 2U);
  EXPECT_EQ(read.samples.width, material.samples.width);
  EXPECT_EQ(material_text(read), material_text(material));
  EXPECT_DOUBLE_EQ(law_of(read, "I1-bar")->parameters()(0), 1.5 * 15e3);
}

TEST(HeterogeneousMaterial, IsNoPieceThatIsTheSameEverywhere) {
  const VirtualHomogeneous pull = test::homogeneous(HomogeneousMode::uniaxial, {1.5});
  const InputError error = test::input_error_of([&] { pull.require(graded_block()); });
  EXPECT_THAT(error.problem(), HasSubstr("differs from place to place"));
}

/// What is wrong with the material file of a graded block in which something was replaced.
InputError refusal(const std::string& what, const std::string& by) {
  std::string text = material_text(graded_block());
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  text.replace(at, what.size(), by);
  const LabFolder folder({{"graded.json", text}});
  return test::input_error_of([&] { read_material(folder.path() / "graded.json"); });
}

TEST(HeterogeneousMaterial, HasSamplesThatDifferInNumbersAlone) {
  EXPECT_THAT(refusal("\"I1-bar\": {", "\"I2-bar\": {").problem(), HasSubstr("more than numbers"));
  EXPECT_THAT(refusal("\"components\": {\n    \"J\"",
                      "\"components\": {\n    \"I1-bar\": {\"stiffness\": "
                      "{\"curve\": \"constant\", \"value\": 1}}, \"J\"")
                  .problem(),
              HasSubstr("under `components` too"));
  EXPECT_THAT(refusal("\"width\": 0.015", "\"width\": 0").problem(), HasSubstr("not positive"));
}

}  // namespace
}  // namespace pliant
