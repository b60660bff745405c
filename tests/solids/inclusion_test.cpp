#include <numeric>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/base/stopwatch.h"
#include "pliant/estimation/least_squares.h"
#include "pliant/estimation/solid/solid_problem.h"
#include "pliant/experiment/moved_body/moved_body_type.h"
#include "pliant/experiment/stored_rows.h"
#include "pliant/geometry/block_mesh.h"
#include "pliant/material/material_samples.h"
#include "pliant/material/solid/standard_solids.h"
#include "pliant/study/body_samples.h"

#include "solids/solid_labs.h"
#include "support/asked_for.h"

namespace pliant {
namespace {

using test::LabFolder;
using test::solid_study;

constexpr double kSoft = 5e3, kStiff = 50e3;  // C10 (Pa)

struct Inclusion {
  const char* name;
  double (*number)(double radius);  // C10 at a distance from its middle
  const char* width;                // of the samples that look for it
};

constexpr Inclusion kSoftEdged{
    "a Gaussian of 10 mm",
    [](double r) { return kSoft + (kStiff - kSoft) * std::exp(-r * r / (2 * 0.01 * 0.01)); },
    "10 mm"};
constexpr Inclusion kBall{"a ball of 14 mm", [](double r) { return r < 0.014 ? kStiff : kSoft; },
                          "8 mm"};

/// A block of 80 x 40 x 40 mm with something ten times as stiff in it, known at the middles of the
/// cells of a mesh that no fit knows.
class StiffPlace {
 public:
  explicit StiffPlace(const Inclusion& inclusion) {
    const Eigen::Array3d cell = kSize / kCells.cast<double>();
    numbers_.resize(kCells.prod());
    for (int z = 0, i = 0; z < kCells.z(); ++z) {
      for (int y = 0; y < kCells.y(); ++y) {
        for (int x = 0; x < kCells.x(); ++x, ++i) {
          places_.emplace_back(((Eigen::Array3d(x, y, z) + 0.5) * cell).matrix());
          numbers_(i) = inclusion.number((places_.back() - kMiddle).norm());
        }
      }
    }
  }

  const Eigen::VectorXd& numbers() const { return numbers_; }

  Material material() const {
    Material material = neo_hookean_solid(kSoft, 10 * kSoft);
    material.samples.width = 0.1 * kSize.x() / kCells.x();  // each cell has its own number
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const double c = numbers_(static_cast<Eigen::Index>(i));
      material.samples.at.push_back(
          {places_[i], {{"I1-bar", neo_hookean_solid(c, 10 * kSoft).components.at("I1-bar")}}});
    }
    take_means(material);
    return material;
  }

  /// Pulled, and pushed to three sides; 300 marks, +- 0.1 mm.
  static VirtualMovedBody body() {
    VirtualMovedBody test;
    test.name = "block";
    test.setup.mesh = block_of_hexahedra(kSize.matrix(), {kCells.x(), kCells.y(), kCells.z()});
    test.setup.held = nodes_at(test.setup.mesh, 0, 0);
    test.setup.moved = nodes_at(test.setup.mesh, 0, kSize.x());
    test.study_mesh = block_of_hexahedra(kSize.matrix(), {10, 5, 5});
    test.fixed = "-x";
    test.moved = "+x";
    test.shifts = {{0.008, 0, 0}, {0, 0.01, 0}, {0, 0, 0.01}, {0, -0.007, 0.007}};
    test.marks = 300;
    test.length_noise = 1e-4;
    test.force_noise = 5e-3;
    return test;
  }

  /// What samples weigh at the places, a row each.
  Eigen::MatrixXd weights(const MaterialSamples& samples) const {
    Eigen::MatrixXd weights(std::ssize(places_), std::ssize(samples.at));
    for (std::size_t i = 0; i < places_.size(); ++i) {
      weights.row(static_cast<Eigen::Index>(i)) = weights_at(samples, places_[i]).transpose();
    }
    return weights;
  }

 private:
  inline static const Eigen::Array3d kSize{0.08, 0.04, 0.04};
  inline static const Eigen::Vector3d kMiddle{0.05, 0.01, 0.01};
  inline static const Eigen::Array3i kCells{16, 8, 8};
  std::vector<Eigen::Vector3d> places_;
  Eigen::VectorXd numbers_;
};

/// The least error that numbers of samples, none negative, can have.
double least_error(const Eigen::MatrixXd& weights, const Eigen::VectorXd& truth) {
  LeastSquaresProblem problem;
  problem.residuals = static_cast<int>(truth.size());
  problem.lower = Eigen::VectorXd::Zero(weights.cols());
  problem.upper = Eigen::VectorXd::Constant(weights.cols(), 1e9);
  problem.scale = Eigen::VectorXd::Constant(weights.cols(), kSoft);
  problem.evaluate = [&](const Eigen::VectorXd& numbers, Eigen::VectorXd& residual,
                         Eigen::MatrixXd* jacobian) {
    residual = weights * numbers - truth;
    if (jacobian) *jacobian = weights;
    return true;
  };
  return std::sqrt(2 * solve_least_squares(problem, problem.scale, {}, {}).cost);
}

struct Seen {
  double field, best, one;  // errors over the size of the field
  std::size_t samples;
};

Study sampled(const LabFolder& folder, const Inclusion& inclusion, const std::string& where) {
  const std::string samples =
      fmt::format("{{{}, width: {}, of: [I1-bar]}}", where, inclusion.width);
  return solid_study(folder, "law: neo-hookean, samples: " + samples);
}

/// @param where  the samples are, as a study says it
Seen see(const Inclusion& inclusion, const std::string& where = "grid: [4, 2, 2]") {
  const StiffPlace truth(inclusion);
  const LabFolder folder(
      test::measurements_of(test::lab_of(truth.material(), {StiffPlace::body()}), 1));
  const StudyResult result = test::fit_on_its_mesh(sampled(folder, inclusion, where));
  const MaterialSamples& samples = result.material.samples;
  Eigen::VectorXd found(std::ssize(samples.at));
  for (std::size_t k = 0; k < samples.at.size(); ++k) {
    found(static_cast<Eigen::Index>(k)) =
        test::value_of(result, name_in_sample(k, "I1-bar.linear.c"));
  }
  const Eigen::MatrixXd weights = truth.weights(samples);
  const Eigen::VectorXd& c = truth.numbers();
  const Seen seen{(weights * found - c).norm() / c.norm(), least_error(weights, c) / c.norm(),
                  (c.array() - c.mean()).matrix().norm() / c.norm(), samples.at.size()};
  fmt::print("{:<18} {:<16} {:>2} {:>6} {:8.3f} {:8.3f} {:8.3f} {:8.2f}\n", inclusion.name, where,
             seen.samples, inclusion.width, seen.field, seen.best, seen.one,
             seen.field / seen.best);
  return seen;
}

TEST(SlowInclusion, IsSeenFromOutside) {
  fmt::print("{:<18} {:<16} {:>2} {:>6} {:>8} {:>8} {:>8} {:>8}\n", "ten times as stiff", "samples",
             "", "width", "error", "best", "one", "ratio");
  const Seen seen = see(kSoftEdged);
  EXPECT_EQ(seen.samples, 16U);
  EXPECT_LT(seen.field, 1.3 * seen.best);
  EXPECT_LT(seen.field, 0.4 * seen.one);
  if (!test::makes_figures()) return;
  EXPECT_EQ(see(kBall).samples, 16U);
  for (const char* where : {"spread: 8", "grown: 8", "grown: 16"}) see(kSoftEdged, where);
}

/// What was measured of the block with something stiff in it, and where its fit with 16 samples
/// begins: soft everywhere.
struct SixteenSamples {
  LabFolder folder;
  Study study = solid_study(
      folder, "law: neo-hookean, samples: {grid: [4, 2, 2], width: 10 mm, of: [I1-bar]}");
  std::unique_ptr<Experiment> experiment = study.experiments.front().test->type().make_solid(
      study.experiments.front(), DataRows(study.experiments.front().data));
  Material material = neo_hookean_solid(kSoft, 10 * kSoft);

  explicit SixteenSamples(const VirtualMovedBody& body)
      : folder(test::measurements_of(test::lab_of(StiffPlace(kSoftEdged).material(), {body}), 1)) {
    material.samples = body_samples(study);
    for (SampledComponents& sample : material.samples.at) {
      sample.components["I1-bar"] = material.components.at("I1-bar");
    }
  }
};

// [T] 4.3 takes differences: an equilibrium of all frames for each number, here each from where the
// one before it was found.
TEST(SlowInclusion, IsDifferentiatedFasterThanByDifferences) {
  VirtualMovedBody block = StiffPlace::body();
  block.setup.mesh = *block.study_mesh;  // what was measured does not matter
  block.setup.held = nodes_at(block.setup.mesh, 0, 0);
  block.setup.moved = nodes_at(block.setup.mesh, 0, 0.08);
  const SixteenSamples begun(block);
  const auto predictor = begun.experiment->predictor(begun.material);
  const Eigen::VectorXd values = predictor->values();
  std::vector<int> by(static_cast<std::size_t>(values.size()));
  std::iota(by.begin(), by.end(), 0);
  StoredRows first(*begun.experiment), analytic(*begun.experiment, std::ssize(by)),
      changed(*begun.experiment);
  ASSERT_TRUE(predictor->predict(values, {}, {}, first));
  const Stopwatch of_derivatives;
  ASSERT_TRUE(predictor->predict(values, by, {}, analytic));
  const double seconds = of_derivatives.seconds();
  const Stopwatch of_differences;
  constexpr int kUnknowns = 17;  // sixteen numbers, and one that all share
  constexpr int kTried = 4;
  for (int k = 0; k < kTried; ++k) {
    Eigen::VectorXd more = values;
    more(k) *= 1.0001;
    ASSERT_TRUE(predictor->predict(more, {}, {}, changed));
  }
  const double ratio = of_differences.seconds() / kTried * kUnknowns / seconds;
  fmt::print("derivatives in {:.3f} s, by differences {:.1f} times as long\n", seconds, ratio);
  EXPECT_GT(ratio, 5);
}

/// The same problem with a residual more for each number, in place of derivatives.
LeastSquaresProblem by_differences(LeastSquaresProblem problem) {
  problem.evaluate = [exact = problem.evaluate](const Eigen::VectorXd& p, Eigen::VectorXd& residual,
                                                Eigen::MatrixXd* jacobian) {
    if (!exact(p, residual, nullptr)) return false;
    Eigen::VectorXd changed(residual.size());
    if (jacobian) jacobian->resize(residual.size(), p.size());
    for (Eigen::Index k = 0; jacobian && k < p.size(); ++k) {
      const double step = 1e-4 * p(k);
      if (!exact(p + step * Eigen::VectorXd::Unit(p.size(), k), changed, nullptr)) return false;
      jacobian->col(k) = (changed - residual) / step;
    }
    return true;
  };
  return problem;
}

TEST(SlowInclusion, IsFittedFasterThanByDifferences) {
  if (!test::makes_figures()) GTEST_SKIP() << "a table of docs/figures";
  const SixteenSamples begun(StiffPlace::body());
  SolidProblem problems(begun.study, {begun.experiment.get()}, {});
  const auto solved = [&](bool differences) {
    const Problem problem = problems.problem(begun.material);
    const LeastSquaresProblem search = problem.least_squares();
    const Stopwatch watch;
    const LeastSquaresSummary end =
        solve_least_squares(differences ? by_differences(search) : search,
                            starts_of(problem.unknowns()), {.function_tolerance = 1e-8}, {});
    fmt::print("{}: {} iterations, {:.1f} s, cost {:.6g}\n",
               differences ? "by differences" : "by derivatives", end.iterations, watch.seconds(),
               end.cost);
    return std::pair(watch.seconds(), end.cost);
  };
  const auto [own, cost] = solved(false);
  const auto [published, same] = solved(true);
  EXPECT_NEAR(cost, same, 1e-3 * cost);
  fmt::print("the fit by differences takes {:.1f} times as long\n", published / own);
}

/// A body that 16 samples can be, much as the one with something stiff in it.
Material of_samples() {
  Material material = neo_hookean_solid(kSoft, 10 * kSoft);
  material.samples.width = 0.01;
  for (const double z : {0.01, 0.03}) {
    for (const double y : {0.01, 0.03}) {
      for (const double x : {0.01, 0.03, 0.05, 0.07}) {
        const Eigen::Vector3d place(x, y, z);
        const double c = kSoftEdged.number((place - Eigen::Vector3d(0.05, 0.01, 0.01)).norm());
        material.samples.at.push_back(
            {place, {{"I1-bar", neo_hookean_solid(c, 10 * kSoft).components.at("I1-bar")}}});
      }
    }
  }
  take_means(material);
  return material;
}

TEST(SlowInclusion, HasIntervalsThatHoldTheTruth) {
  if (!test::makes_figures()) GTEST_SKIP() << "a table of docs/figures";
  const Material truth = of_samples();
  constexpr std::uint64_t kSeeds = 6;
  int covered = 0, all = 0;
  double squares = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const LabFolder folder(test::measurements_of(test::lab_of(truth, {StiffPlace::body()}), seed));
    const StudyResult result = fit_study(sampled(folder, kSoftEdged, "grid: [4, 2, 2]"), {}, {});
    for (std::size_t k = 0; k < truth.samples.at.size(); ++k) {
      const std::string name = name_in_sample(k, "I1-bar.linear.c");
      const ParameterEstimate& found =
          *std::ranges::find(result.parameters, name, &ParameterEstimate::name);
      const double c = law_of(truth.samples.at[k].components.at("I1-bar")).parameters()(0);
      covered += *found.lower <= c && c <= *found.upper;
      squares += std::pow((found.value - c) / *found.std_error, 2);
      ++all;
    }
  }
  fmt::print("95 % intervals hold {} of {} numbers; errors are {:.2f} standard errors (rms)\n",
             covered, all, std::sqrt(squares / all));
  EXPECT_GT(covered, 0.85 * all);
}

}  // namespace
}  // namespace pliant
