// Strips that may come to rest in several shapes.

#include "pliant/experiment/profile/strip_rests.h"

#include <algorithm>
#include <array>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/quantity.h"

#include "support/virtual_strips.h"

namespace pliant {
namespace {

using test::published_bending_material;

constexpr double kLength = 0.1;  // m

/// A strip of a published fabric after its release.
class Released {
 public:
  Released(const std::string& name, double radius, bool with_derivatives = false)
      : fabric_(published_bending_material(name)),
        law_(*law_of(fabric_, "bend.warp")),
        weight_(fabric_.density * kStandardGravity),
        line_(kLength, 24),
        rests_(*hanging_strip({&line_}, law_, 1 / radius, weight_, with_derivatives), law_,
               1 / radius, weight_) {}
  StripRests& rests() { return rests_; }
  double weight() const { return weight_; }
  ComponentLaw law() const { return law_; }

  /// Points that are measured where it rests.
  ProfileRows measured(std::size_t rest) {
    ProfileRows rows;
    const StripProfile profile = rests_.profile(rest, false);
    for (int i = 0; i <= 20; ++i) rows.points.push_back(profile.at(kLength * i / 20).position);
    return rows;
  }

 private:
  Material fabric_;
  ComponentLaw law_;
  double weight_;
  Elastica line_;
  StripRests rests_;
};

TEST(StripRests, AreOneWhereATightCoilIsHeldByFriction) {
  for (const char* name : {"felt", "doublecloth", "paper"}) {
    EXPECT_TRUE(Released(name, 0.004).rests().others().empty()) << name;
  }
}

TEST(StripRests, OfASpiralThatStandsOnItsClampAreTwo) {
  Released felt("felt", 0.016);
  ASSERT_EQ(felt.rests().others().size(), 1u);
  const auto standing = felt.measured(0), fallen = felt.measured(1);
  EXPECT_EQ(felt.rests().nearest(standing), 0u);
  EXPECT_EQ(felt.rests().nearest(fallen), 1u);
  EXPECT_GT((standing.points.back() - fallen.points.back()).norm(), kLength / 2);
}

// Where it tips over on its way hangs on what its points remember.
TEST(StripRests, OfAStripThatTipsOverHangOnHowItIsLetGo) {
  Released doublecloth("doublecloth", 0.023);
  EXPECT_EQ(doublecloth.rests().others().size(), 1u);
}

TEST(StripRests, OfALawThatSnapsAreNotTold) {
  EXPECT_TRUE(Released("paper", 0.0275).rests().others().empty());
}

TEST(StripRests, HaveTheDerivativesOfTheShapeThatTheyAreIn) {
  constexpr double kStep = 1e-4, kTolerance = 1e-3;
  Released felt("felt", 0.016, /*with_derivatives=*/true);
  ASSERT_EQ(felt.rests().others().size(), 1u);
  const double end = kLength;
  const Eigen::MatrixXd by = felt.rests().profile(1, true).position_by_parameter(end);
  const Eigen::VectorXd parameters = felt.law().parameters();
  for (Eigen::Index i = 0; i < parameters.size(); ++i) {
    std::array<Eigen::Vector2d, 2> tips;
    for (const int side : {0, 1}) {
      Eigen::VectorXd moved = parameters;
      moved(i) *= 1 + (side == 0 ? -kStep : kStep);
      const ComponentLaw law = felt.law().with_parameters(moved);
      const Elastica line(kLength, 24);
      StripRests rests(*hanging_strip({&line}, law, 1 / 0.016, felt.weight(), false), law,
                       1 / 0.016, felt.weight());
      ASSERT_EQ(rests.others().size(), 1u);
      tips[static_cast<std::size_t>(side)] = rests.profile(1, false).at(end).position;
    }
    const Eigen::Vector2d difference = (tips[1] - tips[0]) / (2 * kStep);
    EXPECT_NEAR((by.col(i) * parameters(i) - difference).norm(), 0,
                kTolerance * std::max(difference.norm(), 1e-3))
        << i;
  }
}

}  // namespace
}  // namespace pliant
