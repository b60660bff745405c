#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/QR>

#include "pliant/geometry/hexahedron_shape.h"
#include "pliant/material/material_samples.h"
#include "pliant/material/solid/standard_solids.h"
#include "pliant/mechanics/solid_field.h"

#include "io/input_error_of.h"
#include "solids/bodies.h"
#include "solids/solid_labs.h"

namespace pliant {
namespace {

using test::content_of;
using test::LabFolder;
using test::moved_block;
using test::solid_study;
using test::value_of;
using ::testing::Contains;
using ::testing::HasSubstr;

constexpr const char* kSampled = "law: neo-hookean, samples: {grid: [2, 1, 1], of: [I1-bar]}";

LabFolder measured(const Material& material, const VirtualMovedBody& body,
                   std::uint64_t seed = 1) {
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

TEST(MovedBodyStudy, FindsTheNumbersOfSamplesAndOfWhatTheyShare) {
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

TEST(MovedBodyStudy, SaysWhereSamplesExplainNothing) {
  VirtualMovedBody body = moved_block();
  body.force_noise = 5e-3;
  body.length_noise = 1e-4;
  const LabFolder folder = measured(neo_hookean_solid(15e3, 60e3), body);
  const StudyResult result = fit_study(solid_study(folder, kSampled), {}, {});
  EXPECT_THAT(result.warnings, Contains(HasSubstr("do not show that the body is heterogeneous")));
}

// Of the noise that was drawn: two numbers, ten seeds.
TEST(SlowMovedBodyStudy, IntervalsOfSamplesHoldTheTruth) {
  VirtualMovedBody body = moved_block();
  body.force_noise = 5e-3;
  body.length_noise = 1e-4;
  const Material truth = two_halves(5e3, 15e3);
  int held = 0, all = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
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
  EXPECT_GE(held, all - 3);
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

/// A block of 80 x 40 x 40 mm with a ball ten times as stiff in it: C10 at the middles of the cells
/// of a grid.
class Inclusion {
 public:
  explicit Inclusion(const Eigen::Array3i& cells) : cells_(cells) {
    const Eigen::Array3d cell = size_ / cells.cast<double>();
    for (int z = 0; z < cells.z(); ++z) {
      for (int y = 0; y < cells.y(); ++y) {
        for (int x = 0; x < cells.x(); ++x) {
          places_.emplace_back(((Eigen::Array3d(x, y, z) + 0.5) * cell).matrix());
        }
      }
    }
  }

  const std::vector<Eigen::Vector3d>& places() const { return places_; }

  static double number(const Eigen::Vector3d& place) {
    return (place - Eigen::Vector3d(0.05, 0.01, 0.01)).norm() < 0.014 ? 50e3 : 5e3;
  }

  Material material() const {
    Material material = neo_hookean_solid(5e3, 50e3);
    material.samples.width = 0.1 * size_.x() / cells_.x();  // each cell has its own number
    for (const Eigen::Vector3d& place : places_) {
      SampledComponents sample{place, {}};
      sample.components["I1-bar"] =
          neo_hookean_solid(number(place), 50e3).components.at("I1-bar");
      material.samples.at.push_back(sample);
    }
    take_means(material);
    return material;
  }

  /// Pulled, and pushed to both sides; marks with a noise of 0.1 mm.
  VirtualMovedBody body(const std::array<int, 3>& study_cells) const {
    VirtualMovedBody test;
    test.name = "block";
    test.setup.mesh = block_of_hexahedra(size_.matrix(), {cells_.x(), cells_.y(), cells_.z()});
    test.setup.held = nodes_at(test.setup.mesh, 0, 0);
    test.setup.moved = nodes_at(test.setup.mesh, 0, size_.x());
    test.study_mesh = block_of_hexahedra(size_.matrix(), study_cells);
    test.fixed = "-x";
    test.moved = "+x";
    test.shifts = {{0.008, 0, 0}, {0, 0.01, 0}, {0, 0, 0.01}, {0, -0.007, 0.007}};
    test.marks = 300;
    test.length_noise = 1e-4;
    test.force_noise = 5e-3;
    return test;
  }

 private:
  Eigen::Array3d size_{0.08, 0.04, 0.04};
  Eigen::Array3i cells_;
  std::vector<Eigen::Vector3d> places_;
};

/// Numbers of samples blended at places, a row each.
Eigen::MatrixXd weights_at(const MaterialSamples& samples,
                           const std::vector<Eigen::Vector3d>& places) {
  SolidField field;
  for (const SampledComponents& sample : samples.at) field.samples.push_back({sample.place, {}});
  field.width = samples.width;
  Eigen::MatrixXd weights(std::ssize(places), std::ssize(samples.at));
  for (std::size_t i = 0; i < places.size(); ++i) {
    weights.row(static_cast<Eigen::Index>(i)) = field.weights_at(places[i]).transpose();
  }
  return weights;
}

TEST(SlowInclusion, IsSeenFromOutside) {
  const Inclusion inclusion({16, 8, 8});
  const LabFolder folder = measured(inclusion.material(), inclusion.body({10, 5, 5}));
  const StudyResult result = fit_study(
      solid_study(folder, "law: neo-hookean, samples: {grid: [4, 2, 2], width: 8 mm, of: [I1-bar]}"), {}, {});
  const MaterialSamples& samples = result.material.samples;
  ASSERT_EQ(samples.at.size(), 16U);
  const Eigen::MatrixXd weights = weights_at(samples, inclusion.places());
  Eigen::VectorXd truth(std::ssize(inclusion.places())), found(16);
  for (std::size_t i = 0; i < inclusion.places().size(); ++i) {
    truth(static_cast<Eigen::Index>(i)) = Inclusion::number(inclusion.places()[i]);
  }
  for (std::size_t k = 0; k < 16; ++k) {
    found(static_cast<Eigen::Index>(k)) =
        value_of(result, fmt::format("samples[{}].I1-bar.linear.c", k));
  }
  const Eigen::VectorXd best = weights.colPivHouseholderQr().solve(truth);
  const double off = (weights * found - truth).norm() / truth.norm();
  const double least = (weights * best - truth).norm() / truth.norm();
  const double none = (Eigen::VectorXd::Constant(truth.size(), truth.mean()) - truth).norm() / truth.norm();
  fmt::print("off by {:.3f}, the best that 16 samples can {:.3f}, one material {:.3f}; {:.1f} s\n", off,
             least, none, result.seconds);
  for (std::size_t k = 0; k < 16; ++k) {
    fmt::print("{:.0f} ({:.0f}) +- {:.0f}\n", found(static_cast<Eigen::Index>(k)), best(static_cast<Eigen::Index>(k)),
               std::ranges::find(result.parameters, fmt::format("samples[{}].I1-bar.linear.c", k), &ParameterEstimate::name)->std_error.value_or(NAN));
  }
  for (const auto& text : result.experiments.front().handled) fmt::print("{}\n", text);
  for (const auto& text : result.warnings) fmt::print("{}\n", text);
  EXPECT_LT(off, 1.3 * least);
}

}  // namespace
}  // namespace pliant
