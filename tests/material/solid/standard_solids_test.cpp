// Standard laws of solids against their closed forms, and what holds of every law of a solid.

#include "pliant/material/solid/standard_solids.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "pliant/material/addend/rubber_addends.h"
#include "pliant/material/density/stiffness_density.h"
#include "pliant/material/solid/solid_density.h"

#include "material/solid/random_strains.h"

namespace pliant {
namespace {

// Both sides are computed in some dozens of operations on numbers of order 1.
constexpr double kRounding = 1e-10;

MaterialComponent component(const ScalarCurve& stiffness) {
  MaterialComponent result;
  result.stiffness = stiffness;
  return result;
}

MaterialComponent component(std::vector<Addend> addends) {
  MaterialComponent result = component(ScalarCurve::none());
  result.addends = std::move(addends);
  return result;
}

Addend linear(double c) { return {linear_addend(), Eigen::VectorXd::Constant(1, c)}; }

Addend ogden(double mu, double alpha) { return {ogden_addend(), Eigen::Vector2d(mu, alpha)}; }

Material solid_of(std::map<std::string, MaterialComponent> components) {
  Material material;
  material.kind = MaterialKind::solid;
  material.components = std::move(components);
  return material;
}

test::SolidAnswer answer_of(const Material& material, const SolidVector& strain) {
  return test::answer(*solid_density(material).law, strain);
}

/// Invariants of C = F^T F, and C.
struct Deformed {
  explicit Deformed(const Eigen::Matrix3d& f)
      : c(f.transpose() * f),
        strain(test::green_strain(f)),
        volume(f.determinant()),
        first(c.trace()),
        second((first * first - (c * c).trace()) / 2) {}

  Eigen::Matrix3d c;
  SolidVector strain;
  double volume, first, second;
};

const Eigen::Matrix3d kIdentity = Eigen::Matrix3d::Identity();

TEST(StandardSolids, StVKIsItsClosedForm) {
  RandomStream random(41);
  constexpr double kLambda = 3.2, kMu = 1.7;
  for (int draw = 0; draw < 20; ++draw) {
    const Deformed at(test::random_deformation(random));
    const test::SolidAnswer law = answer_of(stvk_solid(kLambda, kMu), at.strain);
    const Eigen::Matrix3d e = (at.c - kIdentity) / 2;
    const Eigen::Matrix3d stress = kLambda * e.trace() * kIdentity + 2 * kMu * e;
    SolidMatrix tangent = SolidMatrix::Zero();
    tangent.topLeftCorner<3, 3>().setConstant(kLambda);
    tangent.diagonal() += (SolidVector() << 2, 2, 2, 1, 1, 1).finished() * kMu;
    EXPECT_NEAR(law.energy, kLambda / 2 * e.trace() * e.trace() + kMu * (e * e).trace(), kRounding);
    EXPECT_LT((law.stress - test::stress_vector(stress)).norm(), kRounding);
    EXPECT_LT((law.tangent - tangent).norm(), kRounding);
  }
}

/// d2 (stress) / dE of C^-1: -2 (C^-1 o C^-1), as a matrix on strain vectors.
SolidMatrix inverse_tangent(const Eigen::Matrix3d& inverse) {
  constexpr int kFirst[] = {0, 1, 2, 1, 0, 0}, kSecond[] = {0, 1, 2, 2, 2, 1};
  SolidMatrix result;
  for (int a = 0; a < 6; ++a) {
    for (int b = 0; b < 6; ++b) {
      const int i = kFirst[a], j = kSecond[a], k = kFirst[b], l = kSecond[b];
      result(a, b) = -(inverse(i, k) * inverse(j, l) + inverse(i, l) * inverse(j, k));
    }
  }
  return result;
}

/// How I1-bar and I2-bar change with the strain, once and twice.
struct BarInvariants {
  explicit BarInvariants(const Deformed& at) {
    const Eigen::Matrix3d inverse = at.c.inverse();
    const double less = std::pow(at.volume, -2.0 / 3), square = less * less;
    const SolidVector one = test::stress_vector(kIdentity), back = test::stress_vector(inverse),
                      rest = at.first * one - test::stress_vector(at.c);  // d I2 / dE / 2
    const SolidMatrix turn = inverse_tangent(inverse);
    const SolidMatrix mixed = one * back.transpose() + back * one.transpose();
    first = 2 * less * (one - at.first / 3 * back);
    second = 2 * square * (rest - 2.0 / 3 * at.second * back);
    first_twice =
        4 * less * (-mixed / 3 + at.first / 9 * back * back.transpose() - at.first / 6 * turn);
    second_twice = 2 * square *
                       (2 * one * one.transpose() -
                        2.0 / 3 * (2 * back * rest.transpose() + at.second * turn)) -
                   4.0 / 3 * second * back.transpose();
    second_twice.diagonal() -= 2 * square * (SolidVector() << 2, 2, 2, 1, 1, 1).finished();
  }

  SolidVector first, second;
  SolidMatrix first_twice, second_twice;
};

TEST(StandardSolids, NeoHookeanIsItsClosedForm) {
  RandomStream random(42);
  constexpr double kC = 0.8, kKappa = 12;
  for (int draw = 0; draw < 20; ++draw) {
    const Deformed at(test::random_deformation(random));
    const test::SolidAnswer law = answer_of(neo_hookean_solid(kC, kKappa), at.strain);
    const Eigen::Matrix3d inverse = at.c.inverse();
    const double j = at.volume, less = std::pow(j, -2.0 / 3);
    const Eigen::Matrix3d stress =
        2 * kC * less * (kIdentity - at.first / 3 * inverse) + kKappa * (j - 1) * j * inverse;
    const SolidVector back = test::stress_vector(inverse);
    const SolidMatrix tangent =
        kC * BarInvariants(at).first_twice +
        kKappa * j * ((2 * j - 1) * back * back.transpose() + (j - 1) * inverse_tangent(inverse));
    EXPECT_NEAR(law.energy, kC * (at.first * less - 3) + kKappa / 2 * (j - 1) * (j - 1), kRounding);
    EXPECT_LT((law.stress - test::stress_vector(stress)).norm(), kRounding);
    EXPECT_LT((law.tangent - tangent).norm(), kRounding * kKappa);
  }
}

TEST(StandardSolids, MooneyRivlinAndYeohAreTheirClosedForms) {
  RandomStream random(43);
  const Material mooney = solid_of({{"I1-bar", component({linear(0.7)})},
                                    {"I2-bar", component({linear(0.2)})},
                                    {"log-J", component(ScalarCurve::constant(9))}});
  const Material yeoh =
      solid_of({{"I1-bar", component({{polynomial_addend(), Eigen::Vector3d(0.6, -0.05, 0.02)}})}});
  for (int draw = 0; draw < 20; ++draw) {
    const Deformed at(test::random_deformation(random));
    const Eigen::Matrix3d inverse = at.c.inverse();
    const double j = at.volume, less = std::pow(j, -2.0 / 3), square = less * less;
    const double first = at.first * less - 3, second = at.second * square - 3;
    const BarInvariants by(at);
    const SolidVector back = test::stress_vector(inverse);
    const test::SolidAnswer law = answer_of(mooney, at.strain);
    const SolidVector stress = 0.7 * by.first + 0.2 * by.second + 9 * std::log(j) * back;
    const SolidMatrix tangent =
        0.7 * by.first_twice + 0.2 * by.second_twice +
        9 * (back * back.transpose() + std::log(j) * inverse_tangent(inverse));
    EXPECT_NEAR(law.energy, 0.7 * first + 0.2 * second + 4.5 * std::pow(std::log(j), 2), kRounding);
    EXPECT_LT((law.stress - stress).norm(), kRounding);
    EXPECT_LT((law.tangent - tangent).norm(), kRounding);
    const test::SolidAnswer cubic = answer_of(yeoh, at.strain);
    const double slope = 0.6 - 0.1 * first + 0.06 * first * first;
    EXPECT_NEAR(cubic.energy, first * (0.6 - 0.05 * first + 0.02 * first * first), kRounding);
    EXPECT_LT((cubic.stress - slope * by.first).norm(), kRounding);
    const SolidMatrix cubic_tangent =
        slope * by.first_twice + (-0.1 + 0.12 * first) * by.first * by.first.transpose();
    EXPECT_LT((cubic.tangent - cubic_tangent).norm(), kRounding);
  }
}

/// The tangent of an isotropic law from its principal stresses.
/// @param by  how those change with the principal strains
SolidMatrix principal_tangent(const Eigen::Vector3d& stress, const Eigen::Matrix3d& by,
                              const Eigen::Vector3d& stretch, const Eigen::Matrix3d& axes) {
  SolidMatrix tangent = SolidMatrix::Zero();
  const auto dyad = [&](int i, int j) {
    const Eigen::Matrix3d product = axes.col(i) * axes.col(j).transpose();
    return SolidVector(test::stress_vector((product + product.transpose()) / 2));
  };
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) tangent += by(i, j) * dyad(i, i) * dyad(j, j).transpose();
    for (int j = 0; j < i; ++j) {
      const double shear =
          (stress(i) - stress(j)) / (stretch(i) * stretch(i) - stretch(j) * stretch(j));
      tangent += 4 * shear * dyad(i, j) * dyad(i, j).transpose();
    }
  }
  return tangent;
}

TEST(StandardSolids, OgdenIsItsClosedFormOnItsAxes) {
  RandomStream random(44);
  const Material material =
      solid_of({{"stretch-bar", component({ogden(1.2, 1.3), ogden(0.02, 5), ogden(0.1, -2)})}});
  constexpr std::array<std::pair<double, double>, 3> kTerms{{{1.2, 1.3}, {0.02, 5}, {0.1, -2}}};
  for (int draw = 0; draw < 20; ++draw) {
    const Eigen::Vector3d stretch(random.uniform(0.5, 2), random.uniform(0.5, 2),
                                  random.uniform(0.5, 2));
    const Eigen::Matrix3d axes = test::random_rotation(random);
    const Deformed at(stretch.asDiagonal() * axes.transpose());
    const Eigen::Array3d bar = stretch / std::cbrt(stretch.prod());
    double energy = 0;
    Eigen::Array3d by_log = Eigen::Array3d::Zero();
    Eigen::Matrix3d twice = Eigen::Matrix3d::Zero();  // by logarithms of stretches
    for (const auto& [mu, alpha] : kTerms) {
      const Eigen::Array3d power = bar.pow(alpha);
      energy += 2 * mu / (alpha * alpha) * (power.sum() - 3);
      by_log += 2 * mu / alpha * (power - power.mean());
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
          const double own = i == j ? power(i) : 0;
          twice(i, j) += 2 * mu * (own - (power(i) + power(j) - power.mean()) / 3);
        }
      }
    }
    const Eigen::Vector3d principal = by_log / stretch.array().square();
    const Eigen::Matrix3d stress = axes * principal.asDiagonal() * axes.transpose();
    const test::SolidAnswer law = answer_of(material, at.strain);
    EXPECT_NEAR(law.energy, energy, kRounding);
    EXPECT_LT((law.stress - test::stress_vector(stress)).norm(), kRounding);
    const Eigen::Vector3d square = stretch.array().square();
    twice.diagonal() -= 2 * by_log.matrix();
    const Eigen::Matrix3d by =
        square.cwiseInverse().asDiagonal() * twice * square.cwiseInverse().asDiagonal();
    const SolidMatrix tangent = principal_tangent(principal, by, stretch, axes);
    EXPECT_LT((law.tangent - tangent).norm(), kRounding * std::max(1.0, tangent.norm()));
  }
}

TEST(StandardSolids, OgdenWithPowerTwoHasTheTangentOfNeoHookeanWhereStretchesCoincide) {
  RandomStream random(45);
  const Material powers = solid_of({{"stretch-bar", component({ogden(2, 2)})}});
  const Material invariant = solid_of({{"I1-bar", component({linear(1)})}});
  for (const double gap : {0.0, 1e-15, 1e-12, 1e-9, 1e-7, 1e-6, 1e-5, 3e-5, 1e-4, 1e-2}) {
    for (const bool all : {false, true}) {
      const Eigen::Matrix3d axes = test::random_rotation(random);
      const Eigen::Vector3d stretch(1.3, 1.3 + gap, all ? 1.3 - 2 * gap : 0.7);
      const SolidVector strain = test::green_strain(stretch.asDiagonal() * axes.transpose());
      const test::SolidAnswer a = answer_of(powers, strain), b = answer_of(invariant, strain);
      EXPECT_NEAR(a.energy, b.energy, kRounding);
      EXPECT_LT((a.stress - b.stress).norm(), kRounding) << gap;
      // Digits lost in the difference quotient, and the square of the gap in its limit.
      EXPECT_LT((a.tangent - b.tangent).norm(), 1e-9) << gap;
    }
  }
}

TEST(StandardSolids, ArrudaBoyceIsItsSeriesAndNeoHookeanWhereChainsAreLong) {
  RandomStream random(46);
  const auto chains = [](double lock) {
    return solid_of({{"I1-bar", component({{arruda_boyce_addend(), Eigen::Vector2d(0.9, lock)}})}});
  };
  for (int draw = 0; draw < 20; ++draw) {
    const Deformed at(test::random_deformation(random));
    const double i = at.first * std::pow(at.volume, -2.0 / 3), n = 2.5 * 2.5;
    const double series =
        0.9 * ((i - 3) / 2 + (i * i - 9) / (20 * n) + 11 * (std::pow(i, 3) - 27) / (1050 * n * n) +
               19 * (std::pow(i, 4) - 81) / (7000 * std::pow(n, 3)) +
               519 * (std::pow(i, 5) - 243) / (673750 * std::pow(n, 4)));
    const double slope = 0.9 * (0.5 + i / (10 * n) + 11 * i * i / (350 * n * n) +
                                19 * std::pow(i, 3) / (1750 * std::pow(n, 3)) +
                                519 * std::pow(i, 4) / (134750 * std::pow(n, 4)));
    const double twice =
        0.9 * (1 / (10 * n) + 11 * i / (175 * n * n) + 57 * i * i / (1750 * std::pow(n, 3)) +
               2 * 519 * std::pow(i, 3) / (67375 * std::pow(n, 4)));
    const BarInvariants by(at);
    const test::SolidAnswer law = answer_of(chains(2.5), at.strain);
    EXPECT_NEAR(law.energy, series, kRounding);
    EXPECT_LT((law.stress - slope * by.first).norm(), kRounding);
    EXPECT_LT(
        (law.tangent - slope * by.first_twice - twice * by.first * by.first.transpose()).norm(),
        kRounding);
    const test::SolidAnswer neo =
        answer_of(solid_of({{"I1-bar", component({linear(0.45)})}}), at.strain);
    EXPECT_LT((answer_of(chains(1e6), at.strain).stress - neo.stress).norm(), 1e-10);
  }
}

TEST(StandardSolids, OrthotropicStVKIsASumOfSquaresOfSums) {
  RandomStream random(47);
  // E_i E_j = ((E_i + E_j)^2 - E_i^2 - E_j^2) / 2
  Eigen::Matrix3d d;
  d << 9, 2, 1.5, 2, 6, 1, 1.5, 1, 4;
  const Eigen::Vector3d shear(1.1, 1.4, 0.9);  // yz, xz, xy
  const auto square = [](double k) { return component(ScalarCurve::constant(k)); };
  const Material material = solid_of({{"green.xx", square(d(0, 0) - d(0, 1) - d(0, 2))},
                                      {"green.yy", square(d(1, 1) - d(0, 1) - d(1, 2))},
                                      {"green.zz", square(d(2, 2) - d(0, 2) - d(1, 2))},
                                      {"green.xx+yy", square(d(0, 1))},
                                      {"green.xx+zz", square(d(0, 2))},
                                      {"green.yy+zz", square(d(1, 2))},
                                      {"green.yz", square(shear(0))},
                                      {"green.xz", square(shear(1))},
                                      {"green.xy", square(shear(2))}});
  SolidMatrix stiffness = SolidMatrix::Zero();
  stiffness.topLeftCorner<3, 3>() = d;
  stiffness.diagonal().tail<3>() = shear;
  for (int draw = 0; draw < 20; ++draw) {
    const Deformed at(test::random_deformation(random));
    const test::SolidAnswer law = answer_of(material, at.strain);
    EXPECT_NEAR(law.energy, at.strain.dot(stiffness * at.strain) / 2, kRounding);
    EXPECT_LT((law.stress - stiffness * at.strain).norm(), kRounding);
    EXPECT_LT((law.tangent - stiffness).norm(), kRounding);
  }
}

TEST(StandardSolids, IsotropicOnesDoNotSeeHowTheSpecimenIsTurned) {
  RandomStream random(48);
  const std::vector<Material> materials{
      stvk_solid(3, 1), neo_hookean_solid(0.5, 9),
      solid_of({{"stretch-bar", component({ogden(1.2, 1.3), ogden(0.1, -2)})},
                {"I2", component({linear(0.3)})},
                {"log-stretch", component(ScalarCurve::constant(2))}})};
  for (const Material& material : materials) {
    const Eigen::Matrix3d f = test::random_deformation(random), q = test::random_rotation(random);
    const test::SolidAnswer as_cut = answer_of(material, test::green_strain(f));
    // Space turns: nothing of the law does.
    const test::SolidAnswer moved = answer_of(material, test::green_strain(q * f));
    EXPECT_NEAR(moved.energy, as_cut.energy, 1e-13);
    EXPECT_LT((moved.stress - as_cut.stress).norm(), 1e-12);
    // The specimen turns: so does its stress.
    const test::SolidAnswer turned = answer_of(material, test::green_strain(f * q));
    EXPECT_NEAR(turned.energy, as_cut.energy, 1e-13);
    const Eigen::Matrix3d back = q * test::stress_matrix(turned.stress) * q.transpose();
    EXPECT_LT((test::stress_vector(back) - as_cut.stress).norm(), 1e-12);
  }
}

/// Work of a law's stress over the closed path of Fig. 4.1: a triangle in the plane whose third
/// vertex moves in a circle, n steps a turn.
template <class Stress>
double work_of_a_turn(const Stress& stress, int steps) {
  const auto deformed = [](double angle) {
    Eigen::Matrix3d f = kIdentity;  // of the triangle (0, 0), (1, 0), (0, 1)
    f(0, 1) = 0.35 * std::sin(angle);
    f(1, 1) = 1.15 + 0.35 * std::cos(angle);
    return f;
  };
  double work = 0;
  for (int i = 0; i < steps; ++i) {
    const double from = 2 * std::numbers::pi * i / steps,
                 to = 2 * std::numbers::pi * (i + 1) / steps;
    const SolidVector change =
        test::green_strain(deformed(to)) - test::green_strain(deformed(from));
    // A Gauss rule of the way between: as good as exact for stresses that are smooth.
    constexpr std::array kPlaces{0.5 - 0.387298334620742, 0.5, 0.5 + 0.387298334620742};
    constexpr std::array kWeights{5.0 / 18, 8.0 / 18, 5.0 / 18};
    for (std::size_t k = 0; k < 3; ++k) {
      const SolidVector at = test::green_strain(deformed(from)) + kPlaces[k] * change;
      work += kWeights[k] * stress(at).dot(change);
    }
  }
  return work;
}

TEST(StandardSolids, TakeNoWorkOverTheCircleOfFigure41WhereAStrainDependentModulusGains) {
  const auto work = [](const Material& material) {
    const NamedLaw density = solid_density(material);
    return work_of_a_turn(
        [&](const SolidVector& strain) { return test::answer(*density.law, strain).stress; }, 400);
  };
  EXPECT_NEAR(work(stvk_solid(1, 0.7)), 0, 1e-12);
  EXPECT_NEAR(work(neo_hookean_solid(0.5, 3)), 0, 1e-12);
  EXPECT_NEAR(work(solid_of({{"stretch", component({ogden(1.2, 1.3), ogden(0.1, -2)})}})), 0,
              1e-12);

  // StVK with the Young's modulus E = eps_1 + 2 eps_2 + 3 eps_12 put in for its constant: the
  // stress is the gradient of no energy ([T] 4.1).
  const double gained = work_of_a_turn(
      [](const SolidVector& strain) -> SolidVector {
        const double young = 1 + strain(0) + 2 * strain(1) + 1.5 * strain(5), poisson = 0.3;
        const double mu = young / (2 * (1 + poisson));
        const double lambda = young * poisson / ((1 + poisson) * (1 - 2 * poisson));
        SolidVector stress = 2 * mu * strain;
        stress.tail<3>() /= 2;
        stress.head<3>().array() += lambda * strain.head<3>().sum();
        return stress;
      },
      400);
  EXPECT_GT(std::abs(gained), 1e-2);
}

}  // namespace
}  // namespace pliant
