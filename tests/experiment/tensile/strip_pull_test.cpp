#include "pliant/experiment/tensile/strip_pull.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "pliant/base/random.h"
#include "pliant/material/addend/addend_registry.h"
#include "pliant/math/check_derivatives.h"

#include "support/random_laws.h"

namespace pliant {
namespace {

using test::parameter_scales;
using test::random_law;

constexpr UniaxialGeometry kStrip{0.08, 0.04, MembraneMeasure::stvk};
constexpr double kRounding = 1e-12;  // N: some dozens of operations on forces of order ten

/// Rows between turning lengths, the turning lengths among them.
std::vector<double> lengths_between(const std::vector<double>& turns, int rows_a_leg) {
  std::vector<double> lengths{turns.front()};
  for (size_t leg = 1; leg < turns.size(); ++leg) {
    for (int i = 1; i <= rows_a_leg; ++i) {
      lengths.push_back(turns[leg - 1] + (turns[leg] - turns[leg - 1]) * i / rows_a_leg);
    }
  }
  return lengths;
}

StripForces pull(const ComponentLaw& law, const std::vector<double>& lengths,
                 const StripSetup& setup = {}) {
  const auto forces = pull_strip(law, kStrip, setup, {}, lengths, half_cycles_of(lengths, 1e-6), 0);
  EXPECT_TRUE(forces);
  return forces.value_or(StripForces{});
}

/// Constant stiffness and constant maximum stress: everything in closed form.
ComponentLaw simple_law() {
  ComponentLaw law;
  law.stiffness = ScalarCurve::constant(60);
  law.friction_law = FrictionLaw::dahl;
  law.friction = {1.5, 0, 0.01};
  return law;
}

double length_of(double strain) { return length_at(kStrip, strain); }

TEST(StripPull, ForceIsStressTimesTheForceFactorPlusWhatTheApparatusAdds) {
  const ComponentLaw law = simple_law();
  const std::vector<double> lengths{0.08, 0.085, 0.09, 0.087};
  const StripForces forces = pull(law, lengths, {.force_offset = 0.3, .apparatus_friction = 0.1});
  const auto strain = [](double length) { return (length * length / (0.08 * 0.08) - 1) / 2; };
  const auto loading = [&](double e) { return 60 * e + 1.5 * (1 - std::exp(-e / 0.01)); };
  const double peak = strain(0.09), back = strain(0.087);
  const double at_peak = 1.5 * (1 - std::exp(-peak / 0.01));
  const double unloading = 60 * back - 1.5 + (at_peak + 1.5) * std::exp((back - peak) / 0.01);
  const auto factor = [](double length) { return 0.04 * length / 0.08; };
  EXPECT_NEAR(forces.force(1), factor(0.085) * loading(strain(0.085)) + 0.4, kRounding);
  EXPECT_NEAR(forces.force(2), factor(0.09) * loading(peak) + 0.4, kRounding);
  EXPECT_NEAR(forces.force(3), factor(0.087) * unloading + 0.2, kRounding);
  EXPECT_NEAR(forces.strain(3), back, 1e-15);
}

TEST(StripPull, RestLengthIsGaugeLengthPlusChange) {
  const ComponentLaw law = simple_law();
  const std::vector<double> lengths = lengths_between({0.085, 0.095, 0.088}, 5);
  const StripForces changed = pull(law, lengths, {.rest_length_change = 0.002});
  const UniaxialGeometry longer{0.082, 0.04, MembraneMeasure::stvk};
  const auto half_cycles = half_cycles_of(lengths, 1e-6);
  const auto expected = pull_strip(law, longer, {}, {}, lengths, half_cycles, 0);
  EXPECT_LT((changed.force - expected->force).cwiseAbs().maxCoeff(), kRounding);
}

TEST(StripPull, ASlackStripCarriesNoForce) {
  const std::vector<double> lengths = lengths_between({0.078, 0.0799, 0.0785, 0.0795}, 7);
  const StripForces forces = pull(simple_law(), lengths, {.force_offset = 0.05});
  for (const double force : forces.force) EXPECT_DOUBLE_EQ(force, 0.05);
  EXPECT_EQ(forces.strain.maxCoeff(), 0);  // the material has not moved
  EXPECT_EQ(forces.length_gain.maxCoeff(), 0);
}

// The apparatus takes its part of the distance; the strip does what it does at what is left.
TEST(StripPull, GivesWayByTheComplianceOfItsApparatus) {
  constexpr double kCompliance = 2e-4;
  const ComponentLaw law = simple_law();
  const std::vector<double> lengths = lengths_between({0.085, 0.095, 0.088, 0.097}, 5);
  const StripForces given_way = pull(law, lengths, {.compliance = kCompliance});
  std::vector<double> of_strip;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    of_strip.push_back(lengths[i] - kCompliance * given_way.force(static_cast<Eigen::Index>(i)));
  }
  const StripForces rigid = pull(law, of_strip);
  EXPECT_LT((given_way.force - rigid.force).norm(), 1e-9);
  EXPECT_LT((given_way.strain - rigid.strain).norm(), 1e-12);
  EXPECT_LT(given_way.force.maxCoeff(), 0.99 * pull(law, lengths).force.maxCoeff());
}

// Cloth that has slipped out of the clamps stays out.
TEST(StripPull, SlipsByItsLargestPullSoFar) {
  constexpr double kSlip = 2e-4;
  const ComponentLaw elastic{ScalarCurve::affine(50, 40)};
  const std::vector<double> lengths = lengths_between({0.081, 0.095, 0.085, 0.1, 0.085}, 40);
  const StripForces slipped = pull(elastic, lengths, {.slip = kSlip});
  double largest = 0, longest = 0;
  for (Eigen::Index i = 0; i < slipped.force.size(); ++i) {
    const double strain = slipped.strain(i);
    EXPECT_NEAR(slipped.force(i), force_factor(kStrip, strain) * elastic.elastic_stress(strain),
                1e-12)
        << i;
    const double out = lengths[static_cast<std::size_t>(i)] / std::sqrt(1 + 2 * strain) - 0.08;
    largest = std::max(largest, slipped.force(i));
    // The largest pull is that at the turn, which lies a little beyond its row.
    EXPECT_NEAR(out, kSlip * largest, slipped.force(i) < largest ? 0.01 * kSlip * largest : 1e-14)
        << i;
    EXPECT_GE(out, longest - 1e-14) << i;
    longest = std::max(longest, out);
  }
}

TEST(StripPull, StartsToCarryAtItsRestLength) {
  const StripForces slack_first = pull(simple_law(), lengths_between({0.076, 0.092}, 8));
  const StripForces from_rest = pull(simple_law(), lengths_between({0.080, 0.092}, 6));
  EXPECT_LT((slack_first.force.tail(7) - from_rest.force).cwiseAbs().maxCoeff(), kRounding);
  EXPECT_EQ(slack_first.force.head(2).maxCoeff(), 0);
}

// Strain and friction stress at which a saturated strip of simple_law goes slack when unloaded.
double slack_strain() { return 1.5 / 60; }

TEST(StripPull, KeepsItsPersistentStrainWhileSlack) {
  const std::vector<double> lengths = lengths_between({0.08, 0.1, 0.078, 0.0805}, 200);
  const StripForces forces = pull(simple_law(), lengths);
  int slack = 0;
  for (size_t i = 200; i < lengths.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if (lengths[i] >= length_of(slack_strain()) - 1e-9) continue;
    ++slack;
    EXPECT_EQ(forces.force(row), 0);
    EXPECT_NEAR(forces.strain(row), slack_strain(), 1e-12);  // unloading is saturated to e^-40
  }
  EXPECT_GT(slack, 200);
}

TEST(StripPull, TakesUpLoadWhereItLeftOff) {
  const std::vector<double> lengths = lengths_between({0.08, 0.1, 0.078, 0.1}, 400);
  const StripForces forces = pull(simple_law(), lengths);
  for (size_t i = 801; i < lengths.size(); ++i) {
    const double strain = strain_at(kStrip, lengths[i]);
    const double beyond = strain - slack_strain();
    // From -60 slack_strain = -1.5 back to the loading branch.
    const double stress = beyond < 0 ? 0 : 60 * strain + 1.5 - 3 * std::exp(-beyond / 0.01);
    EXPECT_NEAR(forces.force(static_cast<Eigen::Index>(i)), force_factor(kStrip, strain) * stress,
                1e-11)  // rounding and what is left of the turn
        << lengths[i];
  }
}

TEST(StripPull, RepeatedCyclesClose) {
  RandomStream random(41);
  for (int draw = 0; draw < 20; ++draw) {
    const ComponentLaw law = random_law(random, CurveKind::hermite);
    const int rows = 40;
    // Down to slack in even draws, to a tensioned strip in odd ones.
    const double low = draw % 2 == 0 ? 0.079 : 0.09;
    std::vector<double> turns{0.08};
    for (int cycle = 0; cycle < 12; ++cycle) turns.insert(turns.end(), {0.1, low});
    const StripForces forces = pull(law, lengths_between(turns, rows));
    const Eigen::VectorXd last = forces.force.tail(2 * rows);
    const Eigen::VectorXd before = forces.force.segment(forces.force.size() - 4 * rows, 2 * rows);
    // A cycle forgets by exp(-2 x 0.1 / tau) at least, tau <= 0.1: ten of them to 1e-8.
    EXPECT_LT((last - before).cwiseAbs().maxCoeff(), 1e-7);
  }
}

TEST(StripPull, ANegativeInitialFrictionIsAPersistentStrain) {
  const ComponentLaw law = simple_law();
  // Half of the maximum stress is held by 60 x 0.0125.
  const StripForces forces =
      pull(law, lengths_between({0.078, 0.1}, 100), {.initial_friction = -0.5});
  EXPECT_NEAR(forces.strain(0), 0.0125, 1e-14);
  for (Eigen::Index i = 0; i < forces.force.size(); ++i) {
    const double length = 0.078 + 0.022 * static_cast<double>(i) / 100;
    const double strain = strain_at(kStrip, length);
    const double stress =
        strain < 0.0125 ? 0 : 60 * strain + 1.5 - 2.25 * std::exp(-(strain - 0.0125) / 0.01);
    EXPECT_NEAR(forces.force(i), force_factor(kStrip, strain) * stress, kRounding);
  }
}

TEST(StripPull, HasNoAnswerWhereThePersistentStrainHasNoValue) {
  ComponentLaw law;
  law.stiffness = ScalarCurve::constant(1);
  law.friction_law = FrictionLaw::dahl;
  law.friction = {1, 5, 0.01};  // friction grows faster with strain than the elastic stress
  const std::vector<double> lengths = lengths_between({0.078, 0.1}, 5);
  EXPECT_FALSE(pull_strip(law, kStrip, {.initial_friction = -0.9}, {}, lengths,
                          half_cycles_of(lengths, 1e-6), 0));
}

TEST(StripPull, NeverPushes) {
  RandomStream random(42);
  for (int draw = 0; draw < 200; ++draw) {
    const ComponentLaw law = random_law(random, CurveKind::affine);
    const double first = random.uniform(0.079, 0.083);
    const std::vector<double> lengths =
        lengths_between({first, random.uniform(0.084, 0.1), random.uniform(0.078, 0.083), 0.1}, 30);
    const double initial = random.uniform(-1, 1);
    const StripForces forces = pull(law, lengths, {.initial_friction = initial});
    ASSERT_GE(forces.force.minCoeff(), -kRounding)
        << "draw " << draw << ": first length " << first << ", initial friction " << initial;
  }
}

/// Friction with a second branch, softening and permanent set beside it.
ComponentLaw laws_that_remember(RandomStream& random) {
  ComponentLaw law = random_law(random, CurveKind::affine);
  law.addends = {{*find_addend_kind("dahl"), Eigen::Vector3d(0.5, 1, random.uniform(0.05, 0.2))},
                 {*find_addend_kind("softening"), Eigen::Vector2d(15, random.uniform(0.1, 0.3))},
                 {*find_addend_kind("set"), Eigen::VectorXd::Constant(1, 4)}};
  return law;
}

/// One random strip with every setup parameter in play.
struct StripCase {
  ComponentLaw law;
  StripSetup setup;
  std::vector<double> lengths;
  std::vector<double> before = {};  // of an earlier pull; none: empty

  /// Law, force offset, rest length change, initial friction, slip, compliance.
  Eigen::VectorXd parameters() const {
    Eigen::VectorXd all(law.parameter_count() + 5);
    all << law.parameters(), setup.force_offset, setup.rest_length_change, setup.initial_friction,
        setup.slip, setup.compliance;
    return all;
  }

  /// Small changes: no row may pass the length at which the strip goes slack.
  Eigen::VectorXd scales() const {
    Eigen::VectorXd all(law.parameter_count() + 5);
    all << parameter_scales(law) * 0.01, 0.01, 1e-6, 1e-3, 1e-6, 1e-6;
    return all;
  }

  std::optional<StripForces> forces(const Eigen::VectorXd& parameters, bool jacobian) const {
    const int count = law.parameter_count();
    const StripSetup changed{parameters(count),     parameters(count + 1),
                             parameters(count + 2), 0.02,
                             parameters(count + 3), parameters(count + 4)};
    const StripColumns columns =
        jacobian ? StripColumns{count, count + 1, count + 2, count + 3, count + 4} : StripColumns{};
    const ComponentLaw own = law.with_parameters(parameters);
    const int columns_of = jacobian ? count + 5 : 0;
    std::optional<PathPoint> state;
    if (!before.empty()) {
      state = state_after_pull(own, kStrip, {.slip = 2e-5}, before, half_cycles_of(before, 1e-5),
                               columns_of);
    }
    return pull_strip(own, kStrip, changed, columns, lengths, half_cycles_of(lengths, 1e-5),
                      columns_of, {}, state ? &*state : nullptr);
  }
};

void expect_right_derivatives(const StripCase& strip) {
  const auto stated = strip.forces(strip.parameters(), true);
  ASSERT_TRUE(stated);
  const VectorFunction forces = [&](const Eigen::VectorXd& parameters) {
    return strip.forces(parameters, false)->force;
  };
  const DerivativeCheck check =
      check_derivatives(forces, stated->jacobian, strip.parameters(), strip.scales());
  // Differences over so small steps keep seven digits; a wrong term shows at 1e-3 and more.
  EXPECT_LT(check.error, 1e-6) << check.describe();
}

StripCase random_strip(RandomStream& random, CurveKind curve, FrictionLaw friction, double first) {
  StripCase strip;
  strip.law = random_law(random, curve, friction);
  strip.lengths = lengths_between({first, random.uniform(0.088, 0.094), 0.0785,
                                   random.uniform(0.096, 0.1), random.uniform(0.085, 0.09), 0.1},
                                  17);
  return strip;
}

TEST(StripPull, DerivativesAreThoseOfDifferencesThroughSlackAndBack) {
  RandomStream random(43);
  const auto given_way = [&] { return random.uniform(1e-5, 1e-4); };
  for (const CurveKind curve : {CurveKind::constant, CurveKind::affine, CurveKind::hermite}) {
    for (const FrictionLaw friction :
         {FrictionLaw::none, FrictionLaw::dahl, FrictionLaw::constant_slope}) {
      for (int draw = 0; draw < 5; ++draw) {
        StripCase strip = random_strip(random, curve, friction, 0.0783);
        // Friction that pulls cannot be held by a slack strip: it has no effect.
        strip.setup = {0.1, random.uniform(-2e-4, 2e-4), 0.3, 0, given_way(), given_way()};
        expect_right_derivatives(strip);
      }
    }
  }
}

TEST(StripPull, DerivativesAreThoseOfDifferencesFromAPersistentStart) {
  RandomStream random(44);
  const auto given_way = [&] { return random.uniform(1e-5, 1e-4); };
  for (const CurveKind curve : {CurveKind::constant, CurveKind::affine, CurveKind::hermite}) {
    for (int draw = 0; draw < 8; ++draw) {
      StripCase strip = random_strip(random, curve, FrictionLaw::dahl, 0.0783);
      strip.setup = {
          -0.1,       random.uniform(-2e-4, 2e-4), random.uniform(-0.9, -0.1), 0, given_way(),
          given_way()};
      expect_right_derivatives(strip);
    }
  }
}

TEST(StripPull, DerivativesAreThoseOfDifferencesFromATautStart) {
  RandomStream random(45);
  const auto given_way = [&] { return random.uniform(1e-5, 1e-4); };
  for (const CurveKind curve : {CurveKind::constant, CurveKind::affine, CurveKind::hermite}) {
    for (int draw = 0; draw < 8; ++draw) {
      StripCase strip = random_strip(random, curve, FrictionLaw::dahl, 0.0865);
      strip.setup = {
          0, random.uniform(-2e-4, 2e-4), random.uniform(0, 0.9), 0, given_way(), given_way()};
      expect_right_derivatives(strip);
    }
  }
}

// A strip that is clamped anew as it is pulls on as if it had never left the clamps.
TEST(StripPull, AStripThatWasPulledBeforePullsOn) {
  RandomStream random(47);
  const ComponentLaw law = laws_that_remember(random);
  const std::vector<double> before = lengths_between({0.08, 0.096, 0.085, 0.098, 0.0802}, 9);
  const std::vector<double> again = lengths_between({0.0802, 0.093, 0.0805, 0.1}, 9);
  std::vector<double> whole = before;
  whole.insert(whole.end(), again.begin() + 1, again.end());
  const Eigen::VectorXd expected = pull(law, whole).force.tail(27);

  const auto state = state_after_pull(law, kStrip, {}, before, half_cycles_of(before, 1e-6), 0);
  ASSERT_TRUE(state);
  EXPECT_GT(state->strain, 0.001);
  const UniaxialGeometry as_left{length_at(kStrip, state->strain), kStrip.width, kStrip.measure};
  const auto forces =
      pull_strip(law, as_left, {}, {}, again, half_cycles_of(again, 1e-6), 0, {}, &*state);
  ASSERT_TRUE(forces);
  EXPECT_LT((forces->force.tail(27) - expected).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(StripPull, AStripThatIsReleasedIsFreeOfForce) {
  RandomStream random(48);
  ComponentLaw law = laws_that_remember(random);
  law.addends.push_back({*find_addend_kind("maxwell"), Eigen::Vector2d(20, 3)});
  const std::vector<double> lengths = lengths_between({0.079, 0.096, 0.09}, 9);
  std::vector<double> times(lengths.size());
  for (size_t i = 0; i < times.size(); ++i) times[i] = 0.2 * static_cast<double>(i);
  const auto state =
      state_after_pull(law, kStrip, {}, lengths, half_cycles_of(lengths, 1e-6), 0, times);
  ASSERT_TRUE(state);
  EXPECT_NEAR(LawPath(law, *state).stress_at(state->strain), 0, 1e-6);
}

TEST(SlowStripPull, DerivativesAreThoseOfDifferencesAfterAnEarlierPull) {
  RandomStream random(49);
  for (const double first : {0.0783, 0.0885}) {  // slack, taut
    for (int draw = 0; draw < 8; ++draw) {
      StripCase strip = random_strip(random, CurveKind::affine, FrictionLaw::dahl, first);
      strip.law.addends = laws_that_remember(random).addends;
      strip.setup = {0.1, random.uniform(-2e-4, 2e-4), 0.3, 0, 3e-5, 5e-5};
      strip.before = lengths_between({0.079, random.uniform(0.085, 0.1), 0.082, 0.095}, 5);
      expect_right_derivatives(strip);
    }
  }
}

TEST(StripPull, LengthGainIsTheSizeOfForcePerLength) {
  RandomStream random(46);
  const ComponentLaw law = random_law(random, CurveKind::affine);
  const std::vector<double> lengths = lengths_between({0.079, 0.095, 0.0785, 0.1}, 12);
  const auto half_cycles = half_cycles_of(lengths, 1e-6);
  const StripForces forces = pull(law, lengths);
  for (size_t row = 1; row + 1 < lengths.size(); ++row) {
    if (row % 12 == 0) continue;  // the state turns there: its length moves all rows after it
    const auto index = static_cast<Eigen::Index>(row);
    const VectorFunction force = [&](const Eigen::VectorXd& length) {
      std::vector<double> moved = lengths;
      moved[row] = length(0);
      const auto pulled = pull_strip(law, kStrip, {}, {}, moved, half_cycles, 0);
      return Eigen::VectorXd::Constant(1, pulled->force(index));
    };
    const double estimated = estimate_jacobian(force, Eigen::VectorXd::Constant(1, lengths[row]),
                                               Eigen::VectorXd::Constant(1, 1e-5))(0, 0);
    // Differences of the force over micrometres.
    EXPECT_NEAR(forces.length_gain(index), std::abs(estimated), 1e-6 * std::abs(estimated) + 1e-9);
  }
}

}  // namespace
}  // namespace pliant
