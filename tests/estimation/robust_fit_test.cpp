// Rows far off count less where a study asks for it (`fit.loss`).

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "pliant/base/random.h"

#include "estimation/virtual_study.h"
#include "io/input_error_of.h"

namespace pliant {
namespace {

using test::estimate_named;
using test::relative_error;
using test::VirtualStudy;

constexpr double kNoise = 5e-3;  // N

/// Cycles of a cloth with friction, of which one row in 25 is off by up to 2 N, always to one side:
/// the strip touched its frame.
StudyResult fit_touched(const Material& fabric, const std::string& options) {
  auto cycles = test::strip_cycles({0.2, 0.4, 0.6});
  cycles.instrument.force_noise = kNoise;
  VirtualStudy study(test::lab_of(fabric, cycles));
  study.edit_rows("cycles.csv", [](VirtualStudy::Rows& rows) {
    RandomStream random(7);
    for (std::size_t i = 10; i < rows.size(); i += 25) {
      rows[i][0] += 0.5 + 1.5 * std::abs(random.normal());
    }
  });
  study.set_model("stiffness: affine");
  return study.add("fit: {" + options + "}").fit();
}

class RobustFit : public ::testing::TestWithParam<const char*> {};

TEST_P(RobustFit, MeetsTheTruthThatSquaresMiss) {
  const Material fabric = test::published_fabric("spandex");
  const StudyResult squares = fit_touched(fabric, "loss: none");
  const StudyResult robust = fit_touched(fabric, std::string("loss: ") + GetParam());
  double by_squares = 0, by_loss = 0;
  for (const std::string& name : test::names_of(fabric, "stretch.warp")) {
    by_squares = std::max(by_squares, std::abs(relative_error(squares, fabric, name)));
    by_loss = std::max(by_loss, std::abs(relative_error(robust, fabric, name)));
    const ParameterEstimate estimate = estimate_named(robust, name);
    ASSERT_TRUE(estimate.std_error.has_value()) << name;
    EXPECT_LT(std::abs(estimate.value - test::truth_of(fabric, name)), 4 * *estimate.std_error)
        << name;
  }
  EXPECT_LT(by_loss, 0.2 * by_squares);
  // The noise is that of the rows that are not off, and those that are are listed.
  EXPECT_NEAR(robust.experiments.front().noise, kNoise, 0.25 * kNoise);
  EXPECT_GT(robust.experiments.front().outliers.size(), 10u);
}

TEST_P(RobustFit, LosesLittleWhereNoRowIsOff) {
  const Material fabric = test::published_fabric("spandex");
  auto cycles = test::strip_cycles({0.2, 0.4, 0.6});
  cycles.instrument.force_noise = kNoise;
  const VirtualStudy plain(test::lab_of(fabric, cycles));
  VirtualStudy asked(test::lab_of(fabric, cycles));
  const StudyResult squares = plain.fit();
  const StudyResult robust = asked.add(std::string("fit: {loss: ") + GetParam() + "}").fit();
  ASSERT_EQ(robust.parameters.size(), squares.parameters.size());
  for (std::size_t i = 0; i < squares.parameters.size(); ++i) {
    const ParameterEstimate &one = squares.parameters[i], &other = robust.parameters[i];
    if (!one.std_error || !other.std_error) continue;
    EXPECT_LT(std::abs(other.value - one.value), *one.std_error) << one.name;
    EXPECT_LT(*other.std_error, 1.3 * *one.std_error) << one.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Losses, RobustFit, ::testing::Values("huber", "cauchy"),
                         [](const auto& loss) { return std::string(loss.param); });

TEST(RobustLossOfAStudy, IsNotThereForThePublishedEstimator) {
  VirtualStudy study(test::lab_of(test::published_fabric("spandex"), test::hung_weights()));
  study.add("fit: {estimator: anchor, loss: huber}");
  EXPECT_EQ(test::input_error_of([&] { study.fit(); }).where().field, "fit.estimator");
}

}  // namespace
}  // namespace pliant
