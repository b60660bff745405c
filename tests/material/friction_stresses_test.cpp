// Derivatives of every friction stress against finite differences over random states.

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "pliant/base/random.h"
#include "pliant/material/density/dahl.h"
#include "pliant/material/density/dahl_constant_slope.h"
#include "pliant/material/density/dahl_published.h"
#include "pliant/math/check_derivatives.h"

#include "support/random_laws.h"

namespace pliant {
namespace {

using test::log_uniform;
using test::random_dahl;

/// A friction stress at one random state: of its six arguments (three parameters, strain, strain
/// and stress at the start), with the derivatives it states.
struct StressSample {
  std::function<FrictionStress(const Eigen::VectorXd&)> stress;
  Eigen::VectorXd at;
  Eigen::VectorXd scale;
};

struct RegisteredStress {
  std::string name;
  std::function<StressSample(RandomStream&)> draw;
};

DahlParameters dahl_of(const Eigen::VectorXd& x) { return {x(0), x(1), x(2)}; }
FrictionState start_of(const Eigen::VectorXd& x) { return {x(4), x(5)}; }

/// A strain in +-0.4 or, one-sided, in 0..0.4, at least `gap` from zero and from `other`: the
/// derivatives jump or bend there.
double draw_strain(RandomStream& random, double low, double gap, double other) {
  for (;;) {
    const double strain = random.uniform(low, 0.4);
    if (std::abs(strain) > gap && std::abs(strain - other) > gap) return strain;
  }
}

/// Arguments near `parameters`; `reach` is the strain over which the friction follows.
StressSample sample_near(RandomStream& random, const Eigen::Vector3d& parameters, double reach,
                         double low) {
  const double from = draw_strain(random, low, reach / 5, 0);
  const double strain = draw_strain(random, low, reach / 5, from);
  StressSample sample;
  sample.at.resize(6);
  sample.at << parameters, strain, from, random.uniform(-1, 1) * parameters(0);
  sample.scale.resize(6);
  sample.scale << parameters.cwiseAbs().cwiseMax(0.1), reach, reach, parameters(0);
  sample.scale *= 0.5;
  return sample;
}

StressSample dahl_sample(RandomStream& random, double low) {
  const DahlParameters dahl = random_dahl(random);
  return sample_near(random, {dahl.a, dahl.b, dahl.tau}, dahl.tau, low);
}

StressSample draw_dahl(RandomStream& random) {
  StressSample sample = dahl_sample(random, -0.4);
  sample.stress = [](const Eigen::VectorXd& x) {
    return friction_stress(dahl_of(x), x(3), start_of(x));
  };
  return sample;
}

StressSample draw_published(RandomStream& random) {
  StressSample sample = dahl_sample(random, 0);  // its strain must not change sign
  sample.stress = [](const Eigen::VectorXd& x) {
    return published_friction_stress(dahl_of(x), x(3), start_of(x));
  };
  return sample;
}

StressSample draw_anchored(RandomStream& random) {
  StressSample sample = dahl_sample(random, 0);
  const int direction = sample.at(3) > sample.at(4) ? 1 : -1;
  sample.stress = [direction](const Eigen::VectorXd& x) {
    return anchored_friction_stress(dahl_of(x), x(3), x(4), direction);
  };
  return sample;
}

StressSample draw_constant_slope(RandomStream& random) {
  const double a = random.uniform(0.2, 3), alpha = log_uniform(random, 10, 400);
  // b = 0 in one draw of four, where the closed form is a limit.
  const double b = random.uniform() < 0.25 ? 0 : random.uniform(0, 6);
  StressSample sample = sample_near(random, {a, b, alpha}, a / alpha, -0.4);
  sample.stress = [](const Eigen::VectorXd& x) {
    return friction_stress(ConstantSlopeParameters{x(0), x(1), x(2)}, x(3), start_of(x));
  };
  return sample;
}

const std::vector<RegisteredStress>& registered_stresses() {
  static const std::vector<RegisteredStress> densities{
      {"Dahl", draw_dahl},
      {"DahlPublished", draw_published},
      {"DahlAnchored", draw_anchored},
      {"DahlConstantSlope", draw_constant_slope},
  };
  return densities;
}

Eigen::MatrixXd stated_jacobian(const FrictionStress& stress) {
  Eigen::MatrixXd row(1, 6);
  row << stress.parameters[0], stress.parameters[1], stress.parameters[2], stress.slope,
      stress.from_strain, stress.from_stress;
  return row;
}

class FrictionStresses : public ::testing::TestWithParam<RegisteredStress> {};

TEST_P(FrictionStresses, AreThoseOfFiniteDifferences) {
  RandomStream random(11);
  for (int i = 0; i < 200; ++i) {
    const StressSample sample = GetParam().draw(random);
    const VectorFunction value = [&](const Eigen::VectorXd& x) {
      return Eigen::VectorXd::Constant(1, sample.stress(x).stress);
    };
    const DerivativeCheck check = check_derivatives(
        value, stated_jacobian(sample.stress(sample.at)), sample.at, sample.scale);
    // Differences are good to 1e-10 or so; a wrong term shows at 1e-3 and more.
    EXPECT_LT(check.error, 1e-8) << "draw " << i << " at " << sample.at.transpose() << ": "
                                 << check.describe();
  }
}

INSTANTIATE_TEST_SUITE_P(Registered, FrictionStresses, ::testing::ValuesIn(registered_stresses()),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace pliant
