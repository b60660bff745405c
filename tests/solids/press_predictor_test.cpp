#include "pliant/experiment/press/press_predictor.h"

#include <gtest/gtest.h>

#include "pliant/experiment/indentation/indentation_type.h"
#include "pliant/experiment/stored_rows.h"
#include "pliant/material/solid/standard_solids.h"

#include "solids/bodies.h"
#include "solids/solid_labs.h"

namespace pliant {
namespace {

const std::vector<int> kBoth{0, 1};

/// A sphere pressed into a block and led back, as rows of areas or depths of one specimen.
class Pressed {
 public:
  explicit Pressed(const TestType& kind)
      : folder_(test::measurements_of(
            test::lab_of(solid(), {test::pressed_block(kind, {4, 4, 2}, 5)}), 1)),
        study_(test::solid_study(folder_, "law: neo-hookean")),
        experiment_(study_.experiments.front(), DataRows(study_.experiments.front().data)) {}

  const PressTest& experiment() const { return experiment_; }
  static Material solid() { return neo_hookean_solid(15e3, 300e3); }

  PredictedRows rows(PressPredictor& predictor, const Eigen::Vector2d& numbers,
                     const std::vector<int>& by = kBoth, int threads = 1) const {
    StoredRows rows(experiment_, std::ssize(by));
    EXPECT_TRUE(predictor.predict(numbers, by, {threads, {}}, rows));
    return std::move(rows).rows();
  }

 private:
  test::LabFolder folder_;
  Study study_;
  PressTest experiment_;
};

class PressPredictorOf : public ::testing::TestWithParam<const TestType*> {};

// Within what equilibria are found to: 1e-8 of the stiffness, of which forces are some hundredths.
TEST_P(PressPredictorOf, FindsBesideOtherNumbersWhatAWalkFromRestFinds) {
  const Pressed pressed(*GetParam());
  PressPredictor one(pressed.experiment(), Pressed::solid());
  for (const Eigen::Vector2d& numbers :
       {Eigen::Vector2d{7.5e3, 300e3}, {8e3, 250e3}, {4e3, 100e3}, {5e3, 3e6}, {7.5e3, 290e3}}) {
    PressPredictor fresh(pressed.experiment(), Pressed::solid());
    const PredictedRows beside = pressed.rows(one, numbers), walked = pressed.rows(fresh, numbers);
    const double largest = walked.value.maxCoeff();
    EXPECT_LT((beside.value - walked.value).cwiseAbs().maxCoeff(), 1e-5 * largest);
    EXPECT_LT((beside.by - walked.by).cwiseAbs().maxCoeff(),
              1e-4 * walked.by.cwiseAbs().maxCoeff());
  }
}

TEST_P(PressPredictorOf, SearchesAThirdAsLongBesideNumbersThatAreNear) {
  const Pressed pressed(*GetParam());
  PressPredictor one(pressed.experiment(), Pressed::solid());
  pressed.rows(one, {7.5e3, 300e3});
  const int walk = one.work().counts.iterations;
  pressed.rows(one, {7.51e3, 301e3});
  EXPECT_LT(3 * (one.work().counts.iterations - walk), walk);
  const EquilibriumCounts before = one.work().counts;
  pressed.rows(one, {7.51e3, 301e3});
  EXPECT_EQ(one.work().counts.iterations, before.iterations);
}

TEST_P(PressPredictorOf, FindsTheSameBitsOnAnyThreads) {
  const Pressed pressed(*GetParam());
  PressPredictor one(pressed.experiment(), Pressed::solid());
  PressPredictor two(pressed.experiment(), Pressed::solid());
  for (const Eigen::Vector2d& numbers :
       {Eigen::Vector2d{7.5e3, 300e3}, {8e3, 250e3}, {4e3, 100e3}}) {
    EXPECT_EQ(pressed.rows(one, numbers, kBoth, 1).value,
              pressed.rows(two, numbers, kBoth, 2).value);
  }
}

INSTANTIATE_TEST_SUITE_P(Press, PressPredictorOf,
                         ::testing::Values(&press_type(), &indentation_type()),
                         [](const auto& of) { return std::string(of.param->name); });

}  // namespace
}  // namespace pliant
