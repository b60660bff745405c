// Derivatives of every density against finite differences over random states. One registry holds
// them all, and a test compares it with the folder of the densities: a new law cannot be forgotten.

#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "pliant/base/random.h"
#include "pliant/material/density/dahl_friction.h"
#include "pliant/material/density/damping.h"
#include "pliant/material/density/in_plane.h"
#include "pliant/material/density/linearized_dahl_friction.h"
#include "pliant/material/density/maxwell_density.h"
#include "pliant/material/density/plastic_density.h"
#include "pliant/material/density/rate_friction.h"
#include "pliant/material/density/rubber_energies.h"
#include "pliant/material/density/set_density.h"
#include "pliant/material/density/softening_density.h"
#include "pliant/material/density/stiffness_density.h"
#include "pliant/material/density/sum.h"
#include "pliant/material/solid/solid_density.h"
#include "pliant/math/check_derivatives.h"

#include "material/quasi_static_step.h"
#include "material/random_plasticity.h"
#include "support/density_samples.h"
#include "support/random_laws.h"

namespace pliant {
namespace {

using test::is_amid_a_branch;
using test::log_uniform;
using test::random_dahl;
using test::random_plasticity;
using test::random_saturating_plasticity;

/// A law of three strains at random parameters.
struct RegisteredLaw {
  std::string header;
  std::string name;
  std::function<std::unique_ptr<Density>(RandomStream&)> draw;
  /// Whether a step keeps clear of where its history makes derivatives jump; null: it always does.
  std::function<bool(const Density&, double strain, const Eigen::VectorXd& history)> is_clear =
      nullptr;
  int strain = 0;  ///< that it looks at
};

constexpr int kStrains = 3;
// The laws below change over at least this much strain.
constexpr double kReach = 0.02;
const std::vector<double> kKnots{-0.25, -0.1, 0.05, 0.15, 0.3};

DahlParameters slow_dahl(RandomStream& random) {
  DahlParameters dahl = random_dahl(random);
  dahl.tau = log_uniform(random, kReach, 0.1);
  return dahl;
}

DahlBySide slow_dahl_by_side(RandomStream& random) {
  const DahlParameters positive = slow_dahl(random);
  return {positive, slow_dahl(random)};
}

ScalarCurve wavy_stiffness(RandomStream& random) {
  std::vector<double> values;
  for (size_t i = 0; i < kKnots.size(); ++i) values.push_back(random.uniform(5, 80));
  return ScalarCurve::hermite(kKnots, values);
}

std::unique_ptr<Density> closed_form(EnergyFunction energy, const std::vector<double>& values) {
  return std::make_unique<ClosedFormDensity>(
      2, energy, Eigen::Map<const Eigen::VectorXd>(values.data(), std::ssize(values)));
}

std::unique_ptr<StiffnessDensity> stiff(int strain, const ScalarCurve& curve) {
  return std::make_unique<StiffnessDensity>(strain, curve);
}

std::unique_ptr<Sum> draw_sum(RandomStream& random) {
  auto sum = std::make_unique<Sum>();
  sum->add_addend(stiff(0, wavy_stiffness(random)));
  sum->add_addend(std::make_unique<DahlFriction>(2, slow_dahl_by_side(random)));
  sum->add_addend(std::make_unique<Damping>(1, random.uniform(0, 2)));
  sum->add_addend(std::make_unique<DahlFriction>(0, slow_dahl(random)));
  sum->add_addend(stiff(1, ScalarCurve::affine(random.uniform(20, 80), random.uniform(0, 100))));
  return sum;
}

const std::vector<RegisteredLaw>& registered_laws() {
  static const std::vector<RegisteredLaw> laws{
      {"stiffness_density", "ConstantStiffness",
       [](RandomStream& random) { return stiff(1, ScalarCurve::constant(random.uniform(1, 9))); }},
      {"stiffness_density", "AffineStiffness",
       [](RandomStream& random) {
         return stiff(2, ScalarCurve::affine(random.uniform(1, 90), random.uniform(-50, 90)));
       }},
      {"stiffness_density", "HermiteStiffness",
       [](RandomStream& random) { return stiff(0, wavy_stiffness(random)); }},
      {"stiffness_density", "SplineEnergy",
       [](RandomStream& random) {
         return stiff(1, ScalarCurve::spline(kKnots, wavy_stiffness(random).values()));
       }},
      {"closed_form_density", "LinearEnergy",
       [](RandomStream& random) { return closed_form(linear_energy, {random.uniform(-1, 5)}); }},
      {"rubber_energies", "PolynomialEnergy",
       [](RandomStream& random) {
         return closed_form(polynomial_energy,
                            {random.uniform(1, 5), random.uniform(-1, 1), random.uniform(1, 2)});
       }},
      {"rubber_energies", "OgdenEnergy",
       [](RandomStream& random) {
         return closed_form(ogden_energy, {random.uniform(1, 5), random.uniform(-6, 6)});
       }},
      {"rubber_energies", "ArrudaBoyceEnergy",
       [](RandomStream& random) {
         return closed_form(arruda_boyce_energy, {random.uniform(1, 5), random.uniform(1.2, 5)});
       }},
      {"rubber_energies", "ExponentialEnergy",
       [](RandomStream& random) {
         return closed_form(exponential_energy, {random.uniform(1, 5), random.uniform(0.01, 6)});
       }},
      {"dahl_friction", "DahlFriction",
       [](RandomStream& random) { return std::make_unique<DahlFriction>(1, slow_dahl(random)); }},
      {"dahl_friction", "DahlFrictionBySide",
       [](RandomStream& random) {
         return std::make_unique<DahlFriction>(2, slow_dahl_by_side(random));
       }},
      {"linearized_dahl_friction", "LinearizedDahlFriction",
       [](RandomStream& random) {
         return std::make_unique<LinearizedDahlFriction>(0, slow_dahl_by_side(random));
       }},
      {"plastic_density", "Plasticity",
       [](RandomStream& random) {
         return std::make_unique<PlasticDensity>(1, random_plasticity(random));
       },
       is_amid_a_branch, 1},
      {"plastic_density", "SaturatingPlasticity",
       [](RandomStream& random) {
         return std::make_unique<PlasticDensity>(2, random_saturating_plasticity(random));
       },
       is_amid_a_branch, 2},
      {"softening_density", "Softening",
       [](RandomStream& random) {
         return std::make_unique<SofteningDensity>(1, random.uniform(5, 80),
                                                   random.uniform(0.1, 0.5));
       },
       test::is_clear_of_history, 1},
      {"set_density", "Set",
       [](RandomStream& random) { return std::make_unique<SetDensity>(2, random.uniform(5, 80)); },
       test::is_clear_of_history, 2},
      {"maxwell_density", "Maxwell",
       [](RandomStream& random) {
         return std::make_unique<MaxwellDensity>(1, random.uniform(5, 80),
                                                 random.uniform(0.005, 0.05));
       }},
      {"rate_friction", "RateFriction",
       [](RandomStream& random) {
         const DahlParameters dahl = slow_dahl(random);
         return std::make_unique<RateFriction>(
             1, Eigen::Vector4d(dahl.a, dahl.b, dahl.tau, random.uniform(0.02, 0.2)));
       },
       test::is_clear_of_history, 1},
      {"damping", "Damping",
       [](RandomStream& random) { return std::make_unique<Damping>(2, random.uniform(0, 5)); }},
      {"in_plane", "InPlaneOnSumOfStrains",
       [](RandomStream& random) {
         const auto law = std::make_shared<DahlFriction>(0, slow_dahl(random));
         return std::make_unique<InPlane>(law_on_metric("green.xx+yy", law));
       }},
      {"in_plane", "InPlaneOnTwoStrains",
       [](RandomStream&) {
         const std::string pair = "green.xx*green.xy@0.1/0.1~0.2/0.3";
         return std::make_unique<InPlane>(law_on_metric(pair, stiff(0, ScalarCurve::constant(5))));
       }},
      {"sum", "Sum", draw_sum},
      {"sum", "SumWithLinearizedFriction",
       [](RandomStream& random) {
         std::unique_ptr<Sum> sum = draw_sum(random);
         sum->add_addend(std::make_unique<LinearizedDahlFriction>(1, slow_dahl_by_side(random)));
         return sum;
       }},
  };
  return laws;
}

/// A random state on fixed branches: all strains stay clear of zero, of the knots and of the last
/// ones, where derivatives jump or bend. Half of the steps pass through zero.
test::LaneState draw_state(RandomStream& random, const Density& law,
                           const RegisteredLaw& registered) {
  constexpr double kGap = kReach / 5, kRange = 0.35;
  test::LaneState state(kStrains, law.history_size());
  std::vector<double> kinks = kKnots;
  kinks.push_back(0);
  const auto draw_lane = [&](int lane) {
    for (int c = 0; c < kStrains; ++c) {
      state.last(lane, c) = test::away_from(random, kRange, kGap, kinks);
      kinks.push_back(state.last(lane, c));
      state.strain(lane, c) = test::away_from(random, kRange, kGap, kinks);
      kinks.pop_back();
      // Near the last one: the linearised form supposes that steps are shorter than tau.
      state.before(lane, c) = state.last(lane, c) + random.uniform(-0.2, 0.2) * kReach;
    }
    for (double& x : state.history.row(lane)) x = random.uniform(-1, 1);
  };
  for (int lane = 0; lane < kLanes; ++lane) {
    do {
      draw_lane(lane);
    } while (registered.is_clear && !registered.is_clear(law, state.strain(lane, registered.strain),
                                                         state.history.row(lane).transpose()));
  }
  return state;
}

class DensityLaws : public ::testing::TestWithParam<RegisteredLaw> {};

constexpr StepTime kTime{1 / 0.005, 4.0 / 3, -1.0 / 3, {}, 0.0075};
// Differences are good to 1e-10 or so; a wrong term shows at 1e-3 and more.
constexpr double kDifferences = 1e-8;

test::LaneState with_strain(test::LaneState state, int lane, const Eigen::VectorXd& strain) {
  state.strain.row(lane) = strain.transpose().array();
  return state;
}

TEST_P(DensityLaws, HaveTheStressAndTangentOfTheirEnergy) {
  RandomStream random(21);
  const Eigen::VectorXd scale = Eigen::VectorXd::Constant(kStrains, kReach / 2);
  for (int draw = 0; draw < 25; ++draw) {
    const std::unique_ptr<Density> law = GetParam().draw(random);
    const test::LaneState state = draw_state(random, *law, GetParam());
    const Response response = test::response_of(*law, state, kTime);
    for (int lane = 0; lane < kLanes; ++lane) {
      const Eigen::VectorXd at = state.strain.row(lane).transpose();
      const VectorFunction energy = [&](const Eigen::VectorXd& strain) {
        const Response r = test::response_of(*law, with_strain(state, lane, strain), kTime);
        return Eigen::VectorXd::Constant(1, r.stored(lane) + r.work(lane));
      };
      const VectorFunction stress = [&](const Eigen::VectorXd& strain) -> Eigen::VectorXd {
        return test::response_of(*law, with_strain(state, lane, strain), kTime)
            .stress.row(lane)
            .transpose();
      };
      Eigen::MatrixXd tangent(kStrains, kStrains);
      for (int i = 0; i < kStrains; ++i) {
        for (int j = 0; j < kStrains; ++j) tangent(i, j) = response.tangent(lane, i * kStrains + j);
      }
      EXPECT_EQ(tangent, tangent.transpose());
      const DerivativeCheck first =
          check_derivatives(energy, response.stress.row(lane).matrix(), at, scale);
      const DerivativeCheck second = check_derivatives(stress, tangent, at, scale);
      EXPECT_LT(first.error, kDifferences) << "draw " << draw << ": " << first.describe();
      EXPECT_LT(second.error, kDifferences) << "draw " << draw << ": " << second.describe();
    }
  }
}

TEST_P(DensityLaws, KeepTheirPointsApart) {
  RandomStream random(22);
  for (int draw = 0; draw < 25; ++draw) {
    const std::unique_ptr<Density> law = GetParam().draw(random);
    test::LaneState all = draw_state(random, *law, GetParam());
    const Response together = test::response_of(*law, all, kTime);
    std::vector<test::LaneState> alone;
    for (int lane = 0; lane < kLanes; ++lane) {
      test::LaneState state = all;  // eight times this point
      for (int other = 0; other < kLanes; ++other) {
        state.strain.row(other) = all.strain.row(lane);
        state.last.row(other) = all.last.row(lane);
        state.before.row(other) = all.before.row(lane);
        state.history.row(other) = all.history.row(lane);
      }
      const Response own = test::response_of(*law, state, kTime);
      // Which points stand beside one decides between two forms of the same solution: rounding.
      const double scale = 1e-12 * (1 + own.stress.row(lane).abs().maxCoeff());
      EXPECT_NEAR(together.stored(lane), own.stored(lane), scale);
      EXPECT_NEAR(together.work(lane), own.work(lane), scale);
      EXPECT_LT((together.stress.row(lane) - own.stress.row(lane)).abs().maxCoeff(), scale);
      EXPECT_LT((together.tangent.row(lane) - own.tangent.row(lane)).abs().maxCoeff(), 100 * scale);
      alone.push_back(state);
    }
    const Lane work = test::advance(*law, all, kTime);
    for (int lane = 0; lane < kLanes; ++lane) {
      const Lane own = test::advance(*law, alone[static_cast<size_t>(lane)], kTime);
      EXPECT_NEAR(work(lane), own(lane), 1e-11);
      EXPECT_TRUE(alone[static_cast<size_t>(lane)].history.row(lane).isApprox(all.history.row(lane),
                                                                              1e-11));
    }
  }
}

TEST_P(DensityLaws, StateTheDerivativesThatAPathNeeds) {
  if (GetParam().name == "SumWithLinearizedFriction") return;  // no part in `differentiate`
  RandomStream random(23);
  for (int draw = 0; draw < 25; ++draw) {
    const std::unique_ptr<Density> law = GetParam().draw(random);
    auto* parametric = dynamic_cast<ParametricDensity*>(law.get());
    if (!parametric) return;
    const test::LaneState state = draw_state(random, *law, GetParam());
    for (int lane = 0; lane < kLanes; ++lane) {
      const test::QuasiStaticStep step(*parametric, state, lane, kReach / 2,
                                       {.seconds = kTime.seconds});
      const DerivativeCheck check =
          check_derivatives(step, step.stated(), step.arguments(), step.scale());
      EXPECT_LT(check.error, kDifferences) << "draw " << draw << ": " << check.describe();
    }
  }
}

TEST_P(DensityLaws, TakeTheParametersThatTheyAreGiven) {
  RandomStream random(24);
  const std::unique_ptr<Density> first = GetParam().draw(random), other = GetParam().draw(random);
  const auto* parametric = dynamic_cast<const ParametricDensity*>(first.get());
  if (!parametric) return;
  const Eigen::VectorXd parameters = dynamic_cast<ParametricDensity&>(*other).parameters();
  const auto law = parametric->with_parameters(parameters);
  EXPECT_EQ(law->parameters(), parameters);
  if (GetParam().name == "SumWithLinearizedFriction") return;  // whose addend has none
  const test::LaneState state = draw_state(random, *law, GetParam());
  const Response response = test::response_of(*law, state);
  const Response expected = test::response_of(*other, state);
  EXPECT_TRUE((response.stress == expected.stress).all());
  EXPECT_TRUE((response.stored == expected.stored).all());
}

INSTANTIATE_TEST_SUITE_P(Registered, DensityLaws, ::testing::ValuesIn(registered_laws()),
                         [](const auto& instance) { return instance.param.name; });

TEST(DensityRegistry, HoldsEveryDensityOfTheFolder) {
  // The interface, friction stresses and a conversion of parameters: no densities. Others are
  // tested by themselves.
  std::set<std::string> known{"density",
                              "dahl",
                              "dahl_published",
                              "dahl_constant_slope",
                              "persistent_deformation",
                              "scalar_density",
                              "blended_density",
                              "limited_density"};
  for (const RegisteredLaw& law : registered_laws()) known.insert(law.header);
  const auto folder = std::filesystem::path(PLIANT_SOURCE_DIR) / "src/pliant/material/density";
  int headers = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".h") continue;
    ++headers;
    EXPECT_TRUE(known.contains(entry.path().stem().string()))
        << entry.path().filename() << " is in no registered density: add it to this file";
  }
  EXPECT_GE(headers, 10);
}

}  // namespace
}  // namespace pliant
