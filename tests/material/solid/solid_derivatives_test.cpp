// Derivatives of laws on every metric of a solid against finite differences over random states: the
// registries of metrics are gone through, so that a new one cannot be forgotten.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "pliant/material/density/dahl_friction.h"
#include "pliant/material/density/damping.h"
#include "pliant/material/density/limited_density.h"
#include "pliant/material/density/rubber_energies.h"
#include "pliant/material/density/stiffness_density.h"
#include "pliant/material/density/sum.h"
#include "pliant/material/solid/metric_density.h"
#include "pliant/material/solid/pair_metric.h"
#include "pliant/material/solid/principal_density.h"
#include "pliant/math/check_derivatives.h"

#include "material/quasi_static_step.h"
#include "material/solid/random_strains.h"

namespace pliant {
namespace {

/// A law of solids at random parameters.
struct SolidLaw {
  std::string name;
  std::function<std::unique_ptr<ParametricDensity>(RandomStream&)> draw;
  std::vector<const StrainMetric*> of_friction = {};  ///< metrics on which it has friction
};

void PrintTo(const SolidLaw& law, std::ostream* out) { *out << law.name; }

/// Smooth over all strains: knots make second derivatives jump.
std::unique_ptr<Sum> elastic_law(RandomStream& random) {
  auto law = std::make_unique<Sum>();
  law->add_addend(
      std::make_unique<StiffnessDensity>(0, ScalarCurve::constant(random.uniform(1, 9))));
  law->add_addend(std::make_unique<ClosedFormDensity>(
      0, polynomial_energy, Eigen::Vector3d(random.uniform(1, 9), random.uniform(-2, 2), 1.5)));
  return law;
}

/// Friction that builds up slowly, and so smoothly.
std::unique_ptr<Sum> law_with_friction(RandomStream& random) {
  auto law = elastic_law(random);
  law->add_addend(std::make_unique<DahlFriction>(
      0, DahlParameters{random.uniform(1, 3), 0, random.uniform(0.2, 1)}));
  return law;
}

std::vector<SolidLaw> laws() {
  std::vector<SolidLaw> laws;
  for (const StrainMetric& metric : strain_metrics()) {
    laws.push_back({std::string(metric.name),
                    [&metric](RandomStream& random) {
                      return std::make_unique<MetricDensity>(metric, law_with_friction(random));
                    },
                    {&metric}});
  }
  for (const PrincipalMetric& metric : principal_metrics()) {
    laws.push_back({std::string(metric.name), [&metric](RandomStream& random) {
                      return std::make_unique<PrincipalDensity>(metric, elastic_law(random));
                    }});
  }
  for (const char* name : {"green.xx*green.yy", "green.xx*green.yz@0.1/-0.05~0.2/0.3"}) {
    laws.push_back({name, [name](RandomStream& random) {
                      return std::make_unique<ScalarDensity<PairMetric>>(*find_pair_metric(name),
                                                                         elastic_law(random));
                    }});
  }
  laws.push_back({"sum of several",
                  [](RandomStream& random) {
                    auto sum = std::make_unique<Sum>();
                    for (const char* name : {"I1-bar", "green.xy", "log-J"}) {
                      sum->add_addend(std::make_shared<MetricDensity>(*find_strain_metric(name),
                                                                      law_with_friction(random)));
                    }
                    sum->add_addend(std::make_shared<PrincipalDensity>(
                        *find_principal_metric("stretch-bar"), elastic_law(random)));
                    return sum;
                  },
                  {find_strain_metric("I1-bar"), find_strain_metric("green.xy"),
                   find_strain_metric("log-J")}});
  laws.push_back({"limited", [](RandomStream& random) {
                    const auto sum = std::make_shared<Sum>();
                    sum->add_addend(std::make_shared<MetricDensity>(*find_strain_metric("I1-bar"),
                                                                    elastic_law(random)));
                    sum->add_addend(std::make_shared<PrincipalDensity>(
                        *find_principal_metric("stretch"), elastic_law(random)));
                    return std::make_unique<LimitedDensity>(sum, 1e3);
                  }});
  return laws;
}

class SolidLaws : public ::testing::TestWithParam<SolidLaw> {};

// Over which laws and metrics change noticeably.
constexpr double kReach = 0.2;
// Differences are good to 1e-10 or so; a wrong term shows at 1e-3 and more.
constexpr double kDifferences = 1e-8;

test::LaneState draw_state(RandomStream& random, int history_size) {
  test::LaneState state(kSolidStrains, history_size);
  for (int lane = 0; lane < kLanes; ++lane) {
    state.last.row(lane) = test::green_strain(test::random_deformation(random)).transpose();
    state.before.row(lane) = test::green_strain(test::random_deformation(random)).transpose();
    // Far from the last strain, where the branches of friction part.
    state.strain.row(lane) = test::green_strain(test::random_deformation(random)).transpose();
    for (double& x : state.history.row(lane)) x = random.uniform(-0.5, 0.5);
  }
  return state;
}

/// Whether friction has moved clearly: its branches part at the last strain, and steps of finite
/// differences must not cross it.
bool is_clear(const SolidLaw& law, const test::LaneState& state, int lane) {
  constexpr double kGap = 0.12;
  return std::ranges::all_of(law.of_friction, [&](const StrainMetric* metric) {
    const double now = metric->jet(test::LaneState::view(state.strain)).value(lane);
    const double last = metric->jet(test::LaneState::view(state.last)).value(lane);
    return std::abs(now - last) > kGap;
  });
}

TEST_P(SolidLaws, HaveTheStressAndTangentOfTheirEnergy) {
  RandomStream random(31);
  const Eigen::VectorXd scale = Eigen::VectorXd::Constant(kSolidStrains, kReach);
  int checked = 0;
  for (int draw = 0; draw < 400 && checked < 12; ++draw) {
    const auto law = GetParam().draw(random);
    test::LaneState state = draw_state(random, law->history_size());
    const int lane = draw % kLanes;
    if (!is_clear(GetParam(), state, lane)) continue;
    ++checked;
    const Response response = test::response_of(*law, state);
    const auto with = [&](const Eigen::VectorXd& strain) {
      test::LaneState other = state;
      other.strain.row(lane) = strain.transpose().array();
      return test::response_of(*law, other);
    };
    const Eigen::VectorXd at = state.strain.row(lane).transpose();
    SolidMatrix tangent;
    for (int k = 0; k < 36; ++k) tangent(k / 6, k % 6) = response.tangent(lane, k);
    EXPECT_EQ(tangent, tangent.transpose());
    const DerivativeCheck first = check_derivatives(
        [&](const Eigen::VectorXd& strain) {
          const Response r = with(strain);
          return Eigen::VectorXd::Constant(1, r.stored(lane) + r.work(lane));
        },
        response.stress.row(lane).matrix(), at, scale);
    const DerivativeCheck second = check_derivatives(
        [&](const Eigen::VectorXd& strain) -> Eigen::VectorXd {
          return with(strain).stress.row(lane).transpose();
        },
        tangent, at, scale);
    EXPECT_LT(first.error, kDifferences) << first.describe();
    EXPECT_LT(second.error, kDifferences) << second.describe();
  }
  EXPECT_EQ(checked, 12);
}

TEST_P(SolidLaws, StateTheDerivativesThatAPathNeeds) {
  RandomStream random(33);
  int checked = 0;
  for (int draw = 0; draw < 400 && checked < 8; ++draw) {
    const auto law = GetParam().draw(random);
    const test::LaneState state = draw_state(random, law->history_size());
    const int lane = draw % kLanes;
    if (!is_clear(GetParam(), state, lane)) continue;
    ++checked;
    const test::QuasiStaticStep step(*law, state, lane, kReach);
    const Eigen::VectorXd scale = step.scale().cwiseMax(0.5 * kReach);
    const DerivativeCheck check = check_derivatives(step, step.stated(), step.arguments(), scale);
    EXPECT_LT(check.error, kDifferences) << check.describe();
  }
  EXPECT_EQ(checked, 8);
}

TEST_P(SolidLaws, TakeTheParametersThatTheyAreGiven) {
  RandomStream random(34);
  const auto first = GetParam().draw(random), other = GetParam().draw(random);
  const auto law = first->with_parameters(other->parameters());
  EXPECT_EQ(law->parameters(), other->parameters());
  const SolidVector strain = test::green_strain(test::random_deformation(random));
  EXPECT_EQ(test::answer(*law, strain).stress, test::answer(*other, strain).stress);
}

TEST_P(SolidLaws, HaveNoEnergyAtRestAndIsochoricOnesNoStress) {
  RandomStream random(35);
  const auto law = GetParam().draw(random);
  const test::SolidAnswer rest = test::answer(*law, SolidVector::Zero());
  EXPECT_NEAR(rest.energy, 0, 1e-15);
  // The gradient of isochoric metrics vanishes at rest; elsewhere the linear term of the law shows.
  if (!GetParam().name.ends_with("-bar")) return;
  EXPECT_LT(rest.stress.norm(), 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Registered, SolidLaws, ::testing::ValuesIn(laws()),
                         [](const auto& instance) {
                           std::string name = instance.param.name;
                           for (char& c : name) {
                             if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                           }
                           return name;
                         });

}  // namespace
}  // namespace pliant
