#include "pliant/experiment/buckling/buckling_bend.h"

#include <cmath>
#include <memory>
#include <numbers>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/experiment/buckling/buckling_bend_type.h"
#include "pliant/experiment/buckling/catenary.h"
#include "pliant/experiment/loop_metrics.h"

#include "io/input_error_of.h"
#include "io/temporary_folder.h"

namespace pliant {
namespace {

using Side = BucklingSide;
using ::testing::HasSubstr;

constexpr double kWidth = 0.04, kDensity = 0.3;
constexpr int kOffset = 0, kDrift = 1, kLength = 2;  // among the nuisance parameters

/// Clamps that come nearer and go back, twice, the second time further; the forces are not looked
/// at but for their size.
BucklingBend measured(Side side, const std::string& distances = "", double density = kDensity) {
  std::string rows = "force_N,distance_mm\n" + distances;
  if (distances.empty()) {
    const auto half_cycle = [&](double from, double to) {
      for (int i = 0; i < 8; ++i) {
        const double distance = from + (to - from) * i / 8;
        rows += fmt::format("{},{}\n", -1e-3 * (19.6 - distance), distance);
      }
    };
    half_cycle(19.6, 17);
    half_cycle(17, 19.6);
    half_cycle(19.6, 14);
    half_cycle(14, 19.6);
  }
  const test::TemporaryFolder folder;
  ExperimentSpec spec;
  spec.name = "bend";
  spec.type = "buckling-bend";
  spec.direction = "warp";
  auto own = std::make_shared<BucklingBendSpec>();
  own->length = 0.02;
  own->width = kWidth;
  own->side = side;
  own->rest_length = RestLength::unknown;
  spec.test = own;
  spec.data.files = {folder.write("bend.csv", rows)};
  return BucklingBend(spec, DataRows(spec.data), {density, MembraneMeasure::stvk});
}

ComponentLaw knit() {
  ComponentLaw law;
  law.stiffness = ScalarCurve::affine(2e-6, 1e-10);
  law.friction_law = FrictionLaw::dahl;
  law.friction = {3e-5, 1e-9, 40};
  return law;
}

Eigen::Vector3d apparatus() { return {0.02, 0.002, -0.1e-3}; }

TEST(BucklingBend, PushesLessOnTheWayBack) {
  const BucklingBend bend = measured(Side::down);
  const auto prediction = bend.predict(knit(), apparatus(), false);
  ASSERT_TRUE(prediction);
  // Rows 18 and 30 stand at one distance, on the way there and back.
  EXPECT_LT(prediction->value(18), prediction->value(30) - 1e-3);
}

TEST(BucklingBend, OfAnElasticStripWithoutFrictionIsOneCurve) {
  ComponentLaw law = knit();
  law.friction_law = FrictionLaw::none;
  const auto prediction = measured(Side::down).predict(law, Eigen::Vector3d(0, 0, -0.1e-3), false);
  ASSERT_TRUE(prediction);
  EXPECT_NEAR(prediction->value(18), prediction->value(30), 1e-9);
  // A wave of a length that has hardly buckled: Euler's load and what the weight adds.
  const double euler = 3 * 2e-6 * std::pow(2 * std::numbers::pi / 0.0199, 2) * kWidth;
  EXPECT_NEAR(prediction->value(0), -euler, 0.5 * euler);
}

TEST(BucklingBend, AddsOffsetAndDriftOfTheForce) {
  const BucklingBend bend = measured(Side::up);
  const auto plain = bend.predict(knit(), Eigen::Vector3d(0, 0, -0.1e-3), false);
  const auto shifted = bend.predict(knit(), apparatus(), false);
  ASSERT_TRUE(plain && shifted);
  const int last = bend.rows() - 1;
  EXPECT_NEAR(shifted->value(0) - plain->value(0), 0.02, 1e-12);
  EXPECT_NEAR(shifted->value(last) - plain->value(last), 0.022, 1e-12);
}

TEST(BucklingBend, IsEasierWithItsWeightThanAgainstIt) {
  ComponentLaw law = knit();
  law.friction_law = FrictionLaw::none;
  const auto down = measured(Side::down).predict(law, apparatus(), false);
  const auto up = measured(Side::up).predict(law, apparatus(), false);
  ASSERT_TRUE(down && up);
  EXPECT_GT(down->value(5), up->value(5) + 1e-4);
}

/// A strip of hardly any stiffness, twenty centimetres long between clamps that come nearer.
Eigen::VectorXd nearly_limp(Side side, const SampledPath& path, double stiffness) {
  ComponentLaw law;
  law.stiffness = ScalarCurve::constant(stiffness);
  const BucklingBend bend({0.2, kWidth, kDensity, side, 40}, path);
  return bend.predict(law, Eigen::Vector2d::Zero(), false)->value;
}

// The boundary layer at the clamps, sqrt(k / H) wide, shortens what hangs: it goes with the root of
// the stiffness, so that the limit is that of twice the smaller difference.
TEST(BucklingBend, OfAStripThatHangsComesToACatenary) {
  SampledPath path;
  for (int i = 0; i < 6; ++i) path.value.push_back(0.19 - 0.004 * i);
  path.half_cycles = {{0, 5, -1, 0.17}};
  Eigen::VectorXd catenary(6);
  for (int i = 0; i < 6; ++i) {
    catenary(i) =
        kWidth * catenary_pull(kDensity * 9.80665, 0.2, path.value[static_cast<size_t>(i)]);
  }
  const Eigen::VectorXd stiff = nearly_limp(Side::down, path, 4e-6);
  const Eigen::VectorXd limp = nearly_limp(Side::down, path, 1e-6);
  EXPECT_LT((limp - catenary).norm(), 0.6 * (stiff - catenary).norm());
  EXPECT_LT((2 * limp - stiff - catenary).norm(), 0.01 * catenary.norm());
}

TEST(BucklingBend, KnowsWhatAStripWithoutStiffnessWouldShow) {
  const BucklingBend down = measured(Side::down), up = measured(Side::up);
  const auto limp = down.limp();
  ASSERT_TRUE(limp);
  // Offset and drift are those that fit best: what is left goes with neither.
  const Eigen::VectorXd left = down.measured() - *limp;
  EXPECT_NEAR(left.sum(), 0, 1e-12);
  EXPECT_NEAR(left.dot(Eigen::VectorXd::LinSpaced(down.rows(), 0, 1)), 0, 1e-12);
  // Standing, it pushes as much as it pulls hanging.
  const auto standing = up.limp();
  ASSERT_TRUE(standing);
  const double hangs = (*limp)(8) - (*limp)(4), stands = (*standing)(8) - (*standing)(4);
  EXPECT_LT(hangs * stands, 0);
}

TEST(BucklingBend, KnowsItsDerivatives) {
  const BucklingBend bend = measured(Side::down);
  const ComponentLaw law = knit();
  const auto at = bend.predict(law, apparatus(), true);
  ASSERT_TRUE(at);
  const int law_count = law.parameter_count();
  ASSERT_EQ(at->jacobian.cols(), law_count + 3);
  Eigen::VectorXd p(law_count + 3);
  p << law.parameters(), apparatus();
  for (int k = 0; k < p.size(); ++k) {
    const double step = 1e-5 * std::abs(p(k));
    const auto value = [&](double change) {
      Eigen::VectorXd q = p;
      q(k) += change;
      return bend.predict(law.with_parameters(q), q.tail(3), false)->value;
    };
    const Eigen::VectorXd difference = (value(step) - value(-step)) / (2 * step);
    EXPECT_LT((difference - at->jacobian.col(k)).norm(), 1e-3 * difference.norm()) << k;
  }
}

TEST(BucklingBend, NamesWhatItEstimatesAlong) {
  const BucklingBend bend = measured(Side::down);
  EXPECT_EQ(bend.info().component, "bend.warp");
  ASSERT_EQ(bend.nuisance().size(), 3u);
  EXPECT_EQ(bend.nuisance()[kOffset].name, "bend.force_offset");
  EXPECT_EQ(bend.nuisance()[kDrift].name, "bend.force_drift");
  EXPECT_EQ(bend.nuisance()[kLength].name, "bend.rest_length_change");
  // The strip is longer than the clamps are apart.
  EXPECT_GT(bend.nuisance()[kLength].lower, -0.4e-3);
}

TEST(BucklingBend, NearingClampsLoadTheMaterialAndPartingOnesUnloadIt) {
  const BucklingBend bend = measured(Side::down);
  const MeasuredPath& path = bend.path();
  EXPECT_EQ(path.direction[4], 1);
  EXPECT_EQ(path.direction[12], -1);
  EXPECT_GT(path.strain[7], path.strain[1]);
  EXPECT_TRUE(unloads(path));
  // The zero of the force is not known, so that no figures are read off its loop.
  EXPECT_FALSE(bend.loop(bend.measured()));
  EXPECT_NEAR(bend.reference(), 5.6e-3 * 15 / 16, 0.4e-3);
}

TEST(BucklingBend, TellsHowTheForceChangesWithTheDistance) {
  ComponentLaw law = knit();
  law.friction_law = FrictionLaw::none;
  const BucklingBend bend = measured(Side::down);
  const auto prediction = bend.predict(law, apparatus(), false);
  ASSERT_TRUE(prediction);
  // Elastic: the slope between the neighbours, less the drift of two rows.
  const double drift = apparatus()(kDrift) * 2 / (bend.rows() - 1);
  const double change = prediction->value(6) - prediction->value(4) - drift;
  EXPECT_NEAR(prediction->length_gain(5), std::abs(change / (2 * 2.6e-3 / 8)), 1e-9);
}

std::string refusal(const std::string& rows, double density = kDensity) {
  const InputError error = test::input_error_of([&] { measured(Side::down, rows, density); });
  return error.where().field + ": " + error.problem();
}

TEST(BucklingBend, RefusesWhatIsNoBuckledStrip) {
  EXPECT_THAT(refusal("0,19\n0,18\n1,-17\n"), HasSubstr("distance: is not positive"));
  EXPECT_THAT(refusal("0,19\n1,18\n0,20.5\n"),
              HasSubstr("20.5 mm is not below the strip's length, 20 mm"));
  EXPECT_THAT(refusal("0,19\n1,18\n2,17\n"), HasSubstr("the clamps move one way only"));
  EXPECT_THAT(refusal("0,19\n0,18\n0,19\n"), HasSubstr("force: is the same in every row"));
  EXPECT_THAT(refusal("", 0), HasSubstr("states no density"));
}

}  // namespace
}  // namespace pliant
