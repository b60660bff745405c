#include <algorithm>
#include <cstdint>
#include <cstring>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/io/base64.h"
#include "pliant/material/material_samples.h"
#include "pliant/material/solid/standard_solids.h"
#include "pliant/study/body_map.h"

#include "io/input_error_of.h"
#include "solids/bodies.h"
#include "solids/solid_labs.h"

namespace pliant {
namespace {

using test::content_of;
using test::fit_on_its_mesh;
using test::LabFolder;
using test::moved_block;
using test::solid_study;
using test::value_of;
using ::testing::Contains;
using ::testing::HasSubstr;

constexpr const char* kSampled = "law: neo-hookean, samples: {grid: [2, 1, 1], of: [I1-bar]}";

LabFolder measured(const Material& material, const VirtualMovedBody& body, std::uint64_t seed = 1) {
  return LabFolder(test::measurements_of(test::lab_of(material, {body}), seed));
}

/// A block whose halves resist shear by different C10, by Gaussians that meet in the middle.
Material two_halves(double first, double second) {
  Material material = neo_hookean_solid(first, 60e3);
  material.samples.width = 0.02;
  for (const double c : {first, second}) {
    SampledComponents sample{{c == first ? 0.01 : 0.03, 0.01, 0.01}, {}};
    sample.components["I1-bar"] = neo_hookean_solid(c, 60e3).components.at("I1-bar");
    material.samples.at.push_back(sample);
  }
  take_means(material);
  return material;
}

/// C10 at a place.
double number_at(const Material& material, const Eigen::Vector3d& place) {
  const Eigen::VectorXd weights = weights_at(material.samples, place);
  double sum = 0;
  for (std::size_t k = 0; k < material.samples.at.size(); ++k) {
    const ComponentLaw law = law_of(material.samples.at[k].components.at("I1-bar"));
    sum += weights(static_cast<Eigen::Index>(k)) * law.parameters()(0);
  }
  return sum;
}

TEST(SlowMovedBodyStudy, FindsTheNumbersOfSamplesAndOfWhatTheyShare) {
  const LabFolder folder = measured(two_halves(5e3, 15e3), moved_block());
  const StudyResult result = fit_study(solid_study(folder, kSampled), {}, {});
  EXPECT_NEAR(value_of(result, "samples[0].I1-bar.linear.c"), 5e3, 1e-4 * 5e3);
  EXPECT_NEAR(value_of(result, "samples[1].I1-bar.linear.c"), 15e3, 1e-4 * 15e3);
  EXPECT_NEAR(value_of(result, "J.k"), 60e3, 1e-3 * 60e3);
  ASSERT_EQ(result.material.samples.at.size(), 2U);
  EXPECT_DOUBLE_EQ(result.material.samples.width, 0.02);
  const MaterialComponent& sampled = result.material.samples.at[1].components.at("I1-bar");
  EXPECT_GT(sampled.errors.at("linear.c").std_error.value_or(0), 0);
  EXPECT_THAT(result.experiments.front().handled, Contains(HasSubstr("ways of marks off by")));
}

/// A field of a .vtu file whose blocks are base64 text: their size, then their numbers.
std::vector<double> field_of(const std::string& vtu, const std::string& name) {
  const std::size_t at = vtu.find("Name=\"" + name + "\"");
  EXPECT_NE(at, std::string::npos) << name;
  const std::size_t first = vtu.find('>', at) + 1;
  const std::string bytes = *bytes_of_base64(vtu.substr(first, vtu.find('<', first) - first));
  std::uint64_t size = 0;
  std::memcpy(&size, bytes.data(), sizeof size);
  std::vector<double> numbers(size / sizeof(double));
  std::memcpy(numbers.data(), bytes.data() + sizeof size, size);
  return numbers;
}

// [T] 4.2.4: the body's numbers and how well they are known, in each element.
TEST(SlowMovedBodyStudy, MapsTheNumbersOfTheBodyAndTheirErrors) {
  const Material truth = two_halves(5e3, 15e3);
  VirtualMovedBody body = moved_block();
  body.force_noise = 5e-3;
  body.length_noise = 1e-4;
  const StudyResult result = fit_study(solid_study(measured(truth, body), kSampled), {}, {});
  const std::string map = body_map(result);
  const std::vector<double> c = field_of(map, "I1-bar.linear.c"),
                            error = field_of(map, "I1-bar.linear.c.std_error");
  const VtuCells& cells = result.body->cells.front();
  ASSERT_EQ(c.size(), cells.count());
  ASSERT_EQ(error.size(), c.size());
  const std::size_t corners = cells.corners.size() / cells.count();
  double largest = 0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    Eigen::Vector3d middle(0, 0, 0);
    for (std::size_t k = corners * i; k < corners * (i + 1); ++k) {
      const Point3& corner = result.body->points[static_cast<std::size_t>(cells.corners[k])];
      middle += Eigen::Vector3d(corner[0], corner[1], corner[2]) / static_cast<double>(corners);
    }
    EXPECT_NEAR(c[i], number_at(result.material, middle), 1e-9 * c[i]);
    EXPECT_NEAR(c[i], number_at(truth, middle), 4 * error[i]);
    largest = std::max(largest, error[i] / c[i]);
  }
  EXPECT_GT(largest, 1e-3);
  EXPECT_LT(largest, 0.2);
}

TEST(SlowMovedBodyStudy, SaysWhereSamplesExplainNothing) {
  VirtualMovedBody body = moved_block();
  body.force_noise = 5e-3;
  body.length_noise = 1e-4;
  const LabFolder folder = measured(neo_hookean_solid(15e3, 60e3), body);
  const StudyResult result = fit_on_its_mesh(solid_study(folder, kSampled));
  EXPECT_THAT(result.warnings, Contains(HasSubstr("do not show that the body is heterogeneous")));
}

// The places are nodes, so that the samples stand near those of the truth and not at them.
TEST(SlowMovedBodyStudy, GrowsSamplesWhereTheBodyDiffers) {
  VirtualMovedBody body = moved_block();
  body.force_noise = 5e-3;
  body.length_noise = 1e-4;
  const std::string model = "law: neo-hookean, samples: {grown: 5, of: [I1-bar]}";
  const Material truth = two_halves(5e3, 15e3);
  const StudyResult found = fit_on_its_mesh(solid_study(measured(truth, body), model));
  ASSERT_GE(found.material.samples.at.size(), 2U);
  EXPECT_LE(found.material.samples.at.size(), 3U);
  for (const double x : {0.0, 0.01, 0.03, 0.04}) {
    const Eigen::Vector3d place(x, 0.01, 0.01);
    const double expected = number_at(truth, place);
    EXPECT_NEAR(number_at(found.material, place), expected, 0.1 * expected) << x;
  }
  const StudyResult none =
      fit_on_its_mesh(solid_study(measured(neo_hookean_solid(15e3, 60e3), body), model));
  EXPECT_FALSE(is_heterogeneous(none.material));
  EXPECT_THAT(none.warnings, Contains(HasSubstr("do not show that the body is heterogeneous")));
}

// Of the noise that was drawn: two numbers, three seeds.
TEST(SlowMovedBodyStudy, IntervalsOfSamplesHoldTheTruth) {
  VirtualMovedBody body = moved_block();
  body.force_noise = 5e-3;
  body.length_noise = 1e-4;
  const Material truth = two_halves(5e3, 15e3);
  int held = 0, all = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const LabFolder folder = measured(truth, body, seed);
    const StudyResult result = fit_study(solid_study(folder, kSampled), {}, {});
    for (std::size_t k = 0; k < 2; ++k) {
      const std::string name = fmt::format("samples[{}].I1-bar.linear.c", k);
      const auto estimate = std::ranges::find(result.parameters, name, &ParameterEstimate::name);
      ASSERT_NE(estimate, result.parameters.end());
      const double truth_of_sample = k == 0 ? 5e3 : 15e3;
      ASSERT_TRUE(estimate->lower && estimate->upper);
      held += *estimate->lower < truth_of_sample && truth_of_sample < *estimate->upper ? 1 : 0;
      ++all;
    }
  }
  fmt::print("{} of {}\n", held, all);
  EXPECT_GE(held, all - 1);
}

/// What is wrong with a study some text of which was replaced.
InputError refusal(const std::string& what, const std::string& by,
                   const std::string& model = "law: neo-hookean") {
  const LabFolder folder = measured(neo_hookean_solid(15e3, 60e3), moved_block({4, 2, 2}));
  for (const char* file : {"study.yaml", "block-points.csv", "block.csv"}) {
    std::string text = content_of(folder.path() / file);
    const auto at = text.find(what);
    if (at == std::string::npos) continue;
    text.replace(at, what.size(), by);
    folder.write(file, text);
    return test::input_error_of([&] { fit_study(solid_study(folder, model), {}, {}); });
  }
  ADD_FAILURE() << what << " is nowhere";
  return {{}, "", ""};
}

TEST(MovedBodyStudy, RefusesWhatIsNoMovedBody) {
  EXPECT_THAT(refusal("moved: +x", "moved: -x").problem(), HasSubstr("that are fixed"));
  EXPECT_THAT(refusal("noise: {force: 1e-06 N, length", "noise: {length").problem(),
              HasSubstr("no noise of the force"));
  EXPECT_THAT(refusal("\n0,1,", "\n0,1,9").problem(), HasSubstr("off the surface"));
  EXPECT_THAT(refusal("\n1,1,", "\n7,1,").problem(), HasSubstr("7 is no row of `data`"));
  EXPECT_THAT(refusal("\n0,1,", "\n0,77,").problem(), HasSubstr("\"1\" is nowhere at rest"));
}

TEST(MovedBodyStudy, RefusesSamplesThatCannotBe) {
  const auto of_samples = [](const std::string& samples) {
    return refusal("", "", "law: neo-hookean, samples: {" + samples + "}").problem();
  };
  EXPECT_THAT(of_samples("at: [[0.05, 0.01, 0.01]]"), HasSubstr("sample 0 lies outside"));
  EXPECT_THAT(of_samples("at: [[0.01, 0.01, 0.01], [0.01, 0.01, 0.01]]"),
              HasSubstr("a second one at its place"));
  EXPECT_THAT(of_samples("spread: 4, grid: [2, 1, 1]"), HasSubstr("in several"));
  EXPECT_THAT(of_samples("spread: 5000"), HasSubstr("asks for 5000 places"));
  EXPECT_THAT(of_samples("spread: 4, of: [I2-bar]"), HasSubstr("no component of the model"));
  EXPECT_THAT(refusal("", "",
                      "components: {I1-bar: {friction: dahl}, J: {stiffness: constant}}, "
                      "samples: {spread: 4}")
                  .problem(),
              HasSubstr("remembers"));
}

// What no repetition shows: the study knows the body by a coarse mesh alone.
TEST(SlowMovedBodyStudy, KnowsTheErrorOfItsMesh) {
  VirtualMovedBody body = moved_block({16, 8, 8});
  body.study_mesh = block_of_hexahedra({0.04, 0.02, 0.02}, {4, 2, 2});
  body.force_noise = 1e-4;
  body.length_noise = 1e-6;
  const LabFolder folder = measured(neo_hookean_solid(10e3, 60e3), body);
  const StudyResult result = fit_study(solid_study(folder, "law: neo-hookean"), {}, {});
  EXPECT_THAT(result.assumptions, Contains(HasSubstr("standard errors contain that of the mesh")));
  for (const auto& [name, truth] : {std::pair("I1-bar.linear.c", 10e3), std::pair("J.k", 60e3)}) {
    const ParameterEstimate& found =
        *std::ranges::find(result.parameters, name, &ParameterEstimate::name);
    const double off = std::abs(found.value - truth);
    EXPECT_THAT(found.note, HasSubstr("of the error by the mesh")) << name;
    EXPECT_LT(off, 2 * *found.std_error) << name;
    if (name == std::string("J.k")) continue;  // which this test tells little of
    EXPECT_GT(off, 0.01 * truth);              // far more than the noise makes
    EXPECT_LT(*found.std_error, 3 * off);
  }
}

// Nine numbers from one body that is pulled, pressed and sheared along its axes.
TEST(SlowMovedBodyStudy, FindsOrthotropicStVK) {
  Eigen::Matrix3d normal;
  normal << 90e3, 20e3, 15e3, 20e3, 60e3, 10e3, 15e3, 10e3, 40e3;
  const Material truth = orthotropic_stvk_solid(normal, {11e3, 14e3, 9e3});
  VirtualMovedBody body = moved_block();
  body.shifts = {{0.004, 0, 0}, {0, 0.004, 0}, {0, 0, 0.004}, {-0.003, 0, 0}};
  const LabFolder folder = measured(truth, body);
  const StudyResult result = fit_on_its_mesh(solid_study(folder, "law: orthotropic-stvk"));
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.parameters.size(), 9u);
  for (const auto& [name, component] : truth.components) {
    const double k = law_of(component).parameters()(0);
    const std::string number = component.addends.empty() ? ".k" : ".linear.c";
    EXPECT_NEAR(value_of(result, name + number), k, 0.01 * k) << name;
  }
}

}  // namespace
}  // namespace pliant
