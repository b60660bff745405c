#include "pliant/estimation/monotone_stress.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "pliant/study/study_fit.h"

#include "estimation/virtual_study.h"
#include "io/temporary_folder.h"
#include "support/virtual_sheets.h"

namespace pliant {
namespace {

/// The smallest slope of the elastic stress from rest to some strain, over the first stiffness.
double least_slope(const ScalarCurve& stiffness, double largest) {
  constexpr int kSteps = 1000;
  const auto stress = [&](int i) {
    const double strain = largest * i / kSteps;
    return stiffness.value(strain) * strain;
  };
  double least = INFINITY;
  for (int i = 0; i < kSteps; ++i) least = std::min(least, stress(i + 1) - stress(i));
  return least / (largest / kSteps) / stiffness.value(0);
}

// Between the sixteen strains of a span that are looked at, a slope of zero may fall below it by
// the square of their distance.
constexpr double kBetween = -0.01;

TEST(ElasticTangents, AreTheSlopesOfTheStress) {
  const ScalarCurve hermite = ScalarCurve::hermite({0, 0.1, 0.3}, {5, 1, 4}, true);
  const ScalarCurve affine = ScalarCurve::affine(3, -2);
  EXPECT_EQ(elastic_tangents(ScalarCurve::constant(2), 1).rows(), 0);
  EXPECT_EQ(elastic_tangents(ScalarCurve::hermite({0}, {2}), 1).rows(), 0);
  const Eigen::VectorXd ends = elastic_tangents(affine, 0.5) * Eigen::Vector2d(3, -2);
  EXPECT_NEAR((ends - Eigen::Vector2d(3, 1)).norm(), 0, 1e-14);
  const Eigen::VectorXd tangents = elastic_tangents(hermite, 0) * Eigen::Vector3d(5, 1, 4);
  ASSERT_EQ(tangents.size(), 33);
  const auto stress = [&](double strain) { return hermite.value(strain) * strain; };
  constexpr double kStep = 1e-7;
  for (int i = 1; i < 32; ++i) {
    const double strain = i <= 16 ? 0.1 * i / 16 : 0.1 + 0.2 * (i - 16) / 16;
    const double slope = (stress(strain + kStep) - stress(strain - kStep)) / (2 * kStep);
    EXPECT_NEAR(tangents(i), slope, 1e-5) << strain;
  }
  // At the last control point from inside: k + k' strain, k' being the slope of the last span.
  EXPECT_NEAR(tangents(32), 4 + 15 * 0.3, 1e-9);
}

TEST(MonotoneStress, HoldsOfStripsWhoseForceFalls) {
  const Material fabric = test::published_fabric("polyester");
  test::VirtualStudy strips(test::lab_of(fabric, test::strip_cycles({0.2})));
  strips.set_model("stiffness: hermite, friction: none");
  strips.edit_rows("cycles.csv", [](test::VirtualStudy::Rows& rows) {
    double longest = 0, shortest = INFINITY;
    for (const auto& row : rows) {
      longest = std::max(longest, row[1]);
      shortest = std::min(shortest, row[1]);
    }
    for (auto& row : rows) {
      const double share = (row[1] - shortest) / (longest - shortest);
      row[0] *= 1.6 - 1.3 * share * share;
    }
  });
  const auto fit = [&] {
    const StudyResult result = strips.fit();
    const MaterialComponent& warp = result.material.components.at("stretch.warp");
    return std::pair(least_slope(*warp.stiffness, 0.2), result.experiments.front().rms);
  };
  const auto [free_slope, free_rms] = fit();
  EXPECT_LT(free_slope, 10 * kBetween);
  strips.add("fit: {monotone_stress: true}");
  const auto [slope, rms] = fit();
  EXPECT_GT(slope, kBetween);
  EXPECT_GT(rms, free_rms);
}

TEST(MonotoneStress, ChangesNothingWhereItHoldsAnyway) {
  const Material fabric = test::published_fabric("polyester");
  test::VirtualStudy strips(test::lab_of(fabric, test::strip_cycles({0.2})));
  strips.set_model("stiffness: hermite");
  const StudyResult free = strips.fit();
  strips.add("fit: {monotone_stress: true}");
  const StudyResult bound = strips.fit();
  ASSERT_EQ(free.parameters.size(), bound.parameters.size());
  for (std::size_t i = 0; i < free.parameters.size(); ++i) {
    EXPECT_NEAR(bound.parameters[i].value, free.parameters[i].value,
                1e-6 * std::abs(free.parameters[i].value));
  }
}

/// A stretch along weft whose forces fall in the end.
Session falling_stretch() {
  Session session = test::virtual_stretch(test::sheet_cloth(false), 0, 6, 8);
  const int frames = session.frame_count();
  for (int f = 0; f < frames; ++f) {
    const double share = static_cast<double>(f) / (frames - 1);
    for (auto& cords : session.frames[static_cast<std::size_t>(f)].cords) {
      for (CordForce& cord : cords) cord.force *= 1.2 - 0.75 * share * share;
    }
  }
  return session;
}

TEST(SlowMonotoneStress, HoldsOfSheets) {
  const test::TemporaryFolder folder;
  write_session(folder.path() / "weft", falling_stretch());
  folder.write("study.yaml",
               "pliant: study/1\nname: falling\n"
               "experiments: [{name: weft, type: session, data: weft}]\n"
               "model: {mesh: measured}\nfit: {monotone_stress: true, control_points: 4}\n");
  const StudyResult result = fit_study(read_study(folder.path() / "study.yaml"), {}, {});
  const MaterialComponent& weft = result.material.components.at("stretch.weft");
  ASSERT_GT(weft.stiffness->size(), 1);
  EXPECT_GT(least_slope(*weft.stiffness, weft.stiffness->knots().back()), kBetween);
  // The stress cannot follow the forces down.
  EXPECT_GT(result.experiments.front().rms_percent, 1);
}

}  // namespace
}  // namespace pliant
