#include "pliant/math/hermite_energy.h"

#include <cmath>

#include <gtest/gtest.h>

#include "pliant/base/random.h"
#include "pliant/math/check_derivatives.h"

namespace pliant {
namespace {

const std::vector<double> kPlaces{-0.8, -0.3, 0.2, 0.5, 2};

Eigen::VectorXd quadratic(const std::vector<double>& places, double stiffness) {
  Eigen::VectorXd values(std::ssize(places));
  for (std::size_t i = 0; i < places.size(); ++i) {
    values(static_cast<Eigen::Index>(i)) = stiffness * places[i] * places[i] / 2;
  }
  return values;
}

TEST(HermiteEnergy, GoesThroughItsControlValues) {
  for (std::size_t i = 0; i < kPlaces.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    EXPECT_LT((hermite_energy_weights(kPlaces, kPlaces[i]) - Eigen::VectorXd::Unit(5, k)).norm(),
              1e-14);
  }
}

TEST(HermiteEnergy, MeetsAQuadraticEnergyExactly) {
  for (const std::vector<double>& places :
       {kPlaces, std::vector<double>{0.3}, std::vector<double>{-2, -0.5}}) {
    const Eigen::VectorXd values = quadratic(places, 7);
    for (const double x : {-4.0, -0.5, -0.1, 0.0, 0.1, 0.3, 0.7, 5.0}) {
      EXPECT_NEAR(hermite_energy_weights(places, x).dot(values), 3.5 * x * x, 1e-12) << x;
      EXPECT_NEAR(hermite_energy_stress_weights(places, x).dot(values), 7 * x, 1e-12) << x;
      EXPECT_NEAR(hermite_energy_tangent_weights(places, x).dot(values), 7, 1e-12) << x;
      EXPECT_NEAR(hermite_energy_secant_weights(places, x).dot(values), 7, 1e-12) << x;
      EXPECT_NEAR(hermite_energy_secant_slope_weights(places, x).dot(values), 0, 1e-11) << x;
    }
  }
}

TEST(HermiteEnergy, HasOneEnergyWithItsStressItsTangentAndItsSecant) {
  Eigen::VectorXd values(5);
  values << 3, 0.2, 0.4, 0.1, 9;
  const auto number = [](double value) { return Eigen::VectorXd::Constant(1, value); };
  for (const double x : {-1.3, -0.5, -0.05, 0.07, 0.3, 0.9, 2.6}) {
    const Eigen::VectorXd at = number(x), step = number(0.01);
    const auto energy = [&](const Eigen::VectorXd& e) {
      return number(hermite_energy_weights(kPlaces, e(0)).dot(values));
    };
    const auto stress = [&](const Eigen::VectorXd& e) {
      return number(hermite_energy_stress_weights(kPlaces, e(0)).dot(values));
    };
    const auto secant = [&](const Eigen::VectorXd& e) {
      return number(hermite_energy_secant_weights(kPlaces, e(0)).dot(values));
    };
    const double tangent = hermite_energy_tangent_weights(kPlaces, x).dot(values);
    const double slope = hermite_energy_secant_slope_weights(kPlaces, x).dot(values);
    EXPECT_LT(check_derivatives(energy, stress(at), at, step).error, 1e-8) << x;
    EXPECT_LT(check_derivatives(stress, number(tangent), at, step).error, 1e-8) << x;
    EXPECT_LT(check_derivatives(secant, number(slope), at, step).error, 1e-8) << x;
    EXPECT_NEAR(secant(at)(0) * x, stress(at)(0), 1e-13) << x;
  }
}

TEST(HermiteEnergy, IsSmoothAtItsControlPointsAndAtRest) {
  Eigen::VectorXd values(5);
  values << 3, 0.2, 0.4, 0.1, 9;
  for (const double place : {-0.8, -0.3, 0.0, 0.2, 0.5, 2.0}) {
    const double below = hermite_energy_stress_weights(kPlaces, place - 1e-9).dot(values);
    const double above = hermite_energy_stress_weights(kPlaces, place + 1e-9).dot(values);
    EXPECT_NEAR(below, above, 1e-6) << place;
  }
}

TEST(HermiteEnergy, ASideWithoutControlPointsGoesOnFromTheOther) {
  const std::vector<double> places{0.2, 1};
  const Eigen::Vector2d values(0.3, 5);
  const double at_rest = hermite_energy_tangent_weights(places, 0).dot(values);
  for (const double x : {-0.1, -3.0}) {
    EXPECT_NEAR(hermite_energy_tangent_weights(places, x).dot(values), at_rest, 1e-13);
    EXPECT_NEAR(hermite_energy_weights(places, x).dot(values), at_rest * x * x / 2, 1e-12);
  }
}

// Random energies: those whose conditions hold are convex wherever one looks, those of which one
// fails are not.
TEST(HermiteEnergy, IsConvexExactlyWhereItsConditionsHold) {
  RandomStream random(5);
  const Eigen::MatrixXd conditions = hermite_energy_curvatures(kPlaces);
  int convex = 0;
  for (int trial = 0; trial < 100; ++trial) {
    Eigen::VectorXd values = quadratic(kPlaces, 1);
    for (double& value : values) value *= random.uniform(0.5, 1.5);
    double least = INFINITY;
    for (int i = 0; i <= 1200; ++i) {
      const double x = -1 + 3.3 * i / 1200;
      least = std::min(least, hermite_energy_tangent_weights(kPlaces, x).dot(values));
    }
    const double condition = (conditions * values).minCoeff();
    convex += condition >= 0;
    if (condition >= 0) {
      EXPECT_GE(least, 0);
    }
    if (condition < -0.2) {  // samples stand near the ends of pieces, not at them
      EXPECT_LT(least, 0);
    }
  }
  EXPECT_GT(convex, 5);
  EXPECT_LT(convex, 95);
}

}  // namespace
}  // namespace pliant
