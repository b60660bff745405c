// What a fold is to an elastic sheet, to one with Dahl friction and to one that yields ([T] Fig.
// 2.2): moment over curvature of one material point, bent twice, further the second time.

#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/material/addend/plasticity.h"
#include "pliant/material/bending_strain.h"
#include "pliant/material/law_path.h"
#include "pliant/math/root.h"

namespace pliant {
namespace {

constexpr double kStiffness = 2e-5;                          // N m, of all at rest
constexpr double kFirstPeak = 60, kSecondPeak = 100;         // curvatures, 1/m
constexpr double kFriction = 9e-4, kTau = 24;                // N, 1/m
constexpr double kRange = 15e-6, kYield = 120, kLimit = 60;  // N m, 1/m, 1/m
constexpr double kSmall = 5;                                 // 1/m

ComponentLaw elastic() { return {ScalarCurve::constant(kStiffness)}; }
ComponentLaw dahl() {
  return {ScalarCurve::constant(kStiffness), FrictionLaw::dahl, {kFriction, 0, kTau}};
}
ComponentLaw plastic() {
  ComponentLaw law{ScalarCurve::constant(kStiffness - kRange)};
  law.addends = {{plasticity(), Eigen::Vector2d(kRange, kYield)}};
  return law;
}
ComponentLaw saturating() {
  ComponentLaw law{ScalarCurve::constant(kStiffness - kRange)};
  law.addends = {{saturating_plasticity(), Eigen::Vector3d(kRange, kYield, kLimit)}};
  return law;
}

/// A material point that is bent to and fro.
class Bend {
 public:
  explicit Bend(const ComponentLaw& law) : path_(law, {}) {}

  double curvature() const { return path_.start().strain / kStrainPerCurvature; }
  double moment() const { return moment_at(curvature()); }  ///< per width (N)
  double work() const { return work_; }                     ///< done by the load so far (J/m^2)

  void bend(double curvature) {
    constexpr int kSteps = 4000;  // of the trapezoidal rule
    const double from = this->curvature(), step = (curvature - from) / kSteps;
    double last = moment_at(from);
    for (int i = 1; i <= kSteps; ++i) {
      const double next = moment_at(from + i * step);
      work_ += (last + next) / 2 * step;
      last = next;
    }
    path_.turn_at(kStrainPerCurvature * curvature, {});
  }

  /// Bends on, or back, until it bears a moment.
  void load(double moment) {
    constexpr double kReach = 1000;  // 1/m
    bend(root_in_bracket([&](double curvature) { return moment_at(curvature) - moment; }, -kReach,
                         kReach));
  }
  void unload() { load(0); }

 private:
  double moment_at(double curvature) const {
    return path_.stress_at(kStrainPerCurvature * curvature);
  }

  LawPath path_;
  double work_ = 0;
};

struct Cycle {
  double peak = 0;  // moment (N)
  double left = 0;  // curvature (1/m)
  double lost = 0;  // work that the load does not get back (J/m^2)
};

Cycle cycle(Bend& bend, double curvature) {
  const double before = bend.work();
  bend.bend(curvature);
  const double peak = bend.moment();
  bend.unload();
  return {peak, bend.curvature(), bend.work() - before};
}

/// The moment that leaves a point flat when it is taken away.
double undoing_moment(const Bend& left) {
  const auto flatness = [&](double curvature) {
    Bend bent = left;
    bent.bend(curvature);
    bent.unload();
    return bent.curvature();
  };
  Bend bent = left;
  bent.bend(root_in_bracket(flatness, -kSecondPeak, left.curvature()));
  return bent.moment();
}

/// What a small loop of curvature takes, the first ones left out (J/m^2).
double small_loss(Bend bend) {
  constexpr int kFirst = 20;
  const double middle = bend.curvature();
  double before = 0;
  for (int i = 0; i <= kFirst; ++i) {
    bend.bend(middle + kSmall);
    if (i == kFirst) break;
    before = bend.work();
    bend.bend(middle - kSmall);
  }
  return bend.work() - before;
}

/// What is left after cycles of a small moment to both sides (1/m).
double left_after(Bend bend, double moment, int cycles) {
  for (int i = 0; i < cycles; ++i) {
    bend.load(-moment);
    bend.load(moment);
  }
  bend.unload();
  return bend.curvature();
}

constexpr double kSmallMoment = 4.5e-4;  // N, a tenth of what Dahl's fold took

struct Story {
  Cycle first, second;
  double undone = 0, small_loss = 0, after_ten = 0;
};

Story story_of(const ComponentLaw& law) {
  Story story;
  Bend bend(law);
  story.first = cycle(bend, kFirstPeak);
  story.undone = story.first.left > 1e-9 ? undoing_moment(bend) : 0;
  story.small_loss = small_loss(bend);
  story.after_ten = left_after(bend, kSmallMoment, 10);
  story.second = cycle(bend, kSecondPeak);
  return story;
}

TEST(FoldLaws, TellFrictionFromPlasticity) {
  std::cout << fmt::format("{:40} {:>9} {:>9} {:>9} {:>9}\n", "", "elastic", "Dahl", "plastic",
                           "saturating");
  const std::vector<Story> stories{story_of(elastic()), story_of(dahl()), story_of(plastic()),
                                   story_of(saturating())};
  const auto row = [&](const std::string& what, double unit, auto value) {
    std::string line = fmt::format("{:40}", what);
    for (const Story& story : stories) {
      const double rounded = std::round(1e3 * value(story) / unit) / 1e3;
      line += fmt::format(" {:9.3f}", rounded + 0.0);  // no -0
    }
    std::cout << line << "\n";
  };
  row("moment at 60 /m, mN", 1e-3, [](const Story& s) { return s.first.peak; });
  row("left after it, 1/m", 1, [](const Story& s) { return s.first.left; });
  row("lost, mJ/m^2", 1e-3, [](const Story& s) { return s.first.lost; });
  row("moment that undoes it, mN", 1e-3, [](const Story& s) { return s.undone; });
  row("lost on a loop of 5 /m about it, mJ/m^2", 1e-3, [](const Story& s) { return s.small_loss; });
  row("left after 10 cycles of 0.45 mN, 1/m", 1, [](const Story& s) { return s.after_ten; });
  row("moment at 100 /m, mN", 1e-3, [](const Story& s) { return s.second.peak; });
  row("left after it, 1/m", 1, [](const Story& s) { return s.second.left; });
  row("lost, mJ/m^2", 1e-3, [](const Story& s) { return s.second.lost; });
}

constexpr double kRounding = 1e-12;

TEST(FoldLaws, OfAnElasticSheetLeaveAndTakeNothing) {
  const Story story = story_of(elastic());
  for (const Cycle& cycle : {story.first, story.second}) {
    EXPECT_NEAR(cycle.left, 0, kRounding);
    EXPECT_NEAR(cycle.lost, 0, kRounding);
  }
}

// Saturated friction holds a / k of strain, whatever the fold was; yield leaves more of a larger
// one: of the strain beyond it the part that its elastic range has of the stiffness.
TEST(FoldLaws, OfFrictionDoNotGrowWithTheFoldAndThoseOfYieldDo) {
  const Story rubbing = story_of(dahl()), yielding = story_of(plastic());
  const double held = kFriction / kStiffness / kStrainPerCurvature;
  EXPECT_NEAR(rubbing.first.left, held, 0.01 * held);  // not quite saturated: exp(-135 / 24)
  EXPECT_NEAR(rubbing.second.left, held, 0.01 * held);
  for (const auto& [cycle, peak] :
       {std::pair(yielding.first, kFirstPeak), std::pair(yielding.second, kSecondPeak)}) {
    EXPECT_NEAR(cycle.left, kRange / kStiffness * (peak - kYield / kStrainPerCurvature), 1e-9);
  }
  EXPECT_NEAR(yielding.first.left, rubbing.first.left, 0.01 * held);
}

TEST(FoldLaws, OfSaturatedYieldAreNoLargerAfterALargerFold) {
  const Story story = story_of(saturating());
  EXPECT_NEAR(story.first.left, 15, 1e-9);
  EXPECT_NEAR(story.second.left, 15, 1e-9);
  EXPECT_GT(story.second.peak, story_of(plastic()).second.peak);
}

// Friction that was saturated one way needs tau ln 2 of strain beyond flat, and a to get there;
// yield all of its elastic range.
TEST(FoldLaws, OfFrictionAreUndoneByASmallerMomentThanThoseOfYield) {
  const double friction = -(kFriction + kStiffness * kTau * std::log(2));
  EXPECT_NEAR(story_of(dahl()).undone, friction, -0.02 * friction);
  const double yield = -kStiffness * kYield;
  EXPECT_NEAR(story_of(plastic()).undone, yield, -1e-9 * yield);
  EXPECT_LT(yield, 1.8 * friction);
}

TEST(FoldLaws, OfFrictionLoseInEverySmallCycleAndThoseOfYieldInNone) {
  const double strain = kStrainPerCurvature * kSmall;
  const double loss =
      4 * kFriction * (strain - kTau * std::tanh(strain / kTau)) / kStrainPerCurvature;
  EXPECT_NEAR(story_of(dahl()).small_loss, loss, 1e-5 * loss);  // the trapezoidal rule's
  EXPECT_NEAR(story_of(plastic()).small_loss, 0, kRounding);
}

TEST(FoldLaws, OfFrictionComeUndoneUnderSmallLoadsAndThoseOfYieldDoNot) {
  const Story rubbing = story_of(dahl()), yielding = story_of(plastic());
  EXPECT_LT(rubbing.after_ten, rubbing.first.left / 2);
  EXPECT_NEAR(yielding.after_ten, yielding.first.left, 1e-9);
}

}  // namespace
}  // namespace pliant
