// Facts that every strain measure must show, over random states: derivatives against finite
// differences, symmetric Hessians with convex stand-ins, no change under rigid motion. One registry
// holds them all, and a test compares it with the folder of the measures: a new one cannot be
// forgotten.

#include <cmath>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "pliant/base/assert.h"
#include "pliant/base/random.h"
#include "pliant/geometry/hexahedron_shape.h"
#include "pliant/material/strain/discrete_shells.h"
#include "pliant/material/strain/hexahedron_dilatation.h"
#include "pliant/material/strain/linear_tetrahedron.h"
#include "pliant/material/strain/soft_constraint_membrane.h"
#include "pliant/material/strain/spring.h"
#include "pliant/material/strain/stvk_membrane.h"
#include "pliant/material/strain/trilinear_hexahedron.h"
#include "pliant/math/check_derivatives.h"

namespace pliant {
namespace {

constexpr double kSize = 0.1;  // m, of the stencils

/// A measure at one rest shape, as functions of a vector of unknowns.
struct Measure {
  std::string header;
  int unknowns = 0;
  int strains = 0;
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> strain;
  std::function<Eigen::MatrixXd(const Eigen::VectorXd&)> gradient;
  std::function<Eigen::MatrixXd(const Eigen::VectorXd&, const Eigen::VectorXd&)> weighted_hessian;
  std::function<Eigen::MatrixXd(const Eigen::VectorXd&, const Eigen::VectorXd&)> convex_hessian;
};

template <class M>
Measure measure(const std::string& header, const typename M::Rest& rest) {
  const auto positions = [](const Eigen::VectorXd& q) {
    return typename M::Positions(Eigen::Map<const typename M::Positions>(q.data()));
  };
  return {header,
          M::kUnknowns,
          M::kStrains,
          [=](const Eigen::VectorXd& q) { return M::strain(rest, positions(q)); },
          [=](const Eigen::VectorXd& q) { return M::gradient(rest, positions(q)); },
          [=](const Eigen::VectorXd& q, const Eigen::VectorXd& y) {
            return M::weighted_hessian(rest, positions(q), y);
          },
          [=](const Eigen::VectorXd& q, const Eigen::VectorXd& y) {
            return M::convex_weighted_hessian(rest, positions(q), y);
          }};
}

MembraneRest skewed_triangle() {
  Eigen::Matrix<double, 2, 3> corners;
  corners << 0, 1.1, 0.2, 0, 0.1, 0.9;
  return membrane_rest(kSize * corners);
}

TrilinearHexahedron::Positions skewed_hexahedron() {
  TrilinearHexahedron::Positions x;
  x << 0, 1.1, 0.9, -0.1, 0.1, 1.0, 1.2, 0.2,  //
      0, 0.1, 0.8, 1.1, -0.1, 0.2, 1.1, 0.9,   //
      0, 0.2, -0.1, 0.1, 0.8, 1.1, 1.3, 1.0;
  return kSize * x;
}

LinearTetrahedron::Positions skewed_tetrahedron() {
  LinearTetrahedron::Positions x;
  x << 0, 1.1, 0.2, 0.3, 0, 0.1, 0.9, 0.2, 0, -0.1, 0.2, 0.8;
  return kSize * x;
}

std::vector<Measure> registry() {
  return {measure<StvkMembrane>("stvk_membrane", skewed_triangle()),
          measure<SoftConstraintMembrane>("soft_constraint_membrane", skewed_triangle()),
          measure<Spring>("spring", {0.7 * kSize}),
          measure<DiscreteShells>("discrete_shells", {0.3, 0.5 * kSize, 0.3}),
          measure<LinearTetrahedron>("linear_tetrahedron", tetrahedron_rest(skewed_tetrahedron())),
          measure<TrilinearHexahedron>("trilinear_hexahedron",
                                       hexahedron_points(skewed_hexahedron())[5].rest),
          measure<HexahedronDilatation>("hexahedron_dilatation",
                                        {hexahedron_sizes(skewed_hexahedron()).sum()})};
}

/// Whether its stand-in for the part of the stress is zero: that part itself is never convex.
bool has_no_convex_part(const Measure& m) {
  return m.header == "discrete_shells" || m.header == "hexahedron_dilatation";
}

Eigen::VectorXd random_vector(RandomStream& random, int size, double scale) {
  Eigen::VectorXd v(size);
  for (double& x : v) x = scale * random.normal();
  return v;
}

Eigen::VectorXd moved(const Eigen::VectorXd& q, const Eigen::Matrix3d& rotation,
                      const Eigen::Vector3d& shift) {
  Eigen::VectorXd result(q.size());
  for (Eigen::Index i = 0; i < q.size(); i += 3) {
    result.segment<3>(i) = rotation * q.segment<3>(i) + shift;
  }
  return result;
}

TEST(StrainMeasures, AreAllRegistered) {
  const std::set<std::string> helpers{"strain_measure", "membrane_rest", "green_strain",
                                      "inversion"};
  std::set<std::string> headers, registered;
  const std::filesystem::path folder =
      std::filesystem::path(PLIANT_SOURCE_DIR) / "src/pliant/material/strain";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() == ".h" && !helpers.contains(name)) headers.insert(name);
  }
  for (const Measure& m : registry()) registered.insert(m.header);
  EXPECT_EQ(headers, registered);
}

TEST(StrainMeasures, GradientsAndHessiansAreThoseOfDifferences) {
  RandomStream random(7);
  for (const Measure& m : registry()) {
    for (int trial = 0; trial < 50; ++trial) {
      const Eigen::VectorXd q = random_vector(random, m.unknowns, kSize);
      const Eigen::VectorXd y = random_vector(random, m.strains, 1);
      const Eigen::VectorXd scale = Eigen::VectorXd::Constant(m.unknowns, 0.1 * kSize);
      const DerivativeCheck first = check_derivatives(m.strain, m.gradient(q), q, scale);
      const auto force = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
        return m.gradient(x).transpose() * y;
      };
      const DerivativeCheck second = check_derivatives(force, m.weighted_hessian(q, y), q, scale);
      // Extrapolated differences are good to about 1e-10; near-degenerate stencils lose some of it.
      EXPECT_LT(first.error, 1e-7) << m.header << ": " << first.describe();
      EXPECT_LT(second.error, 1e-7) << m.header << ": " << second.describe();
    }
  }
}

TEST(StrainMeasures, HessiansAreSymmetric) {
  RandomStream random(8);
  for (const Measure& m : registry()) {
    const Eigen::VectorXd q = random_vector(random, m.unknowns, kSize);
    const Eigen::MatrixXd hessian = m.weighted_hessian(q, random_vector(random, m.strains, 1));
    EXPECT_LT((hessian - hessian.transpose()).norm(), 1e-12 * hessian.norm()) << m.header;
  }
}

TEST(StrainMeasures, DoNotSeeRigidMotions) {
  RandomStream random(9);
  for (const Measure& m : registry()) {
    for (int trial = 0; trial < 20; ++trial) {
      const Eigen::VectorXd q = random_vector(random, m.unknowns, kSize);
      const Eigen::Vector3d axis = random_vector(random, 3, 1);
      const Eigen::Matrix3d rotation =
          Eigen::AngleAxisd(random.uniform(0, 3), axis.normalized()).toRotationMatrix();
      const Eigen::VectorXd there = moved(q, rotation, random_vector(random, 3, 1));
      // Rounding of positions at a distance of 1 m, on stencils of 0.1 m.
      EXPECT_TRUE(m.strain(there).isApprox(m.strain(q), 1e-11)) << m.header;
      const Eigen::VectorXd y = random_vector(random, m.strains, 1);
      const Eigen::VectorXd force = m.gradient(q).transpose() * y;
      Eigen::Vector3d sum = Eigen::Vector3d::Zero(), moment = sum;
      for (Eigen::Index i = 0; i < q.size(); i += 3) {
        sum += force.segment<3>(i);
        moment += q.segment<3>(i).cross(force.segment<3>(i));
      }
      EXPECT_LT(sum.norm(), 1e-12 * force.norm()) << m.header;
      EXPECT_LT(moment.norm(), 1e-12 * force.norm() * q.norm()) << m.header;
    }
  }
}

double least_eigenvalue(const Eigen::MatrixXd& symmetric) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly)
      .eigenvalues()(0);
}

/// Stresses of all signs; every second one vanishes, since shear alone is never convex.
Eigen::VectorXd random_stress(RandomStream& random, int strains) {
  Eigen::VectorXd y = random_vector(random, strains, 1);
  for (double& stress : y) {
    if (random.uniform() < 0.5) stress = 0;
  }
  return y;
}

TEST(StrainMeasures, ConvexHessiansAreSymmetricAndPositiveSemidefinite) {
  RandomStream random(11);
  for (const Measure& m : registry()) {
    for (int trial = 0; trial < 200; ++trial) {
      const Eigen::VectorXd q = random_vector(random, m.unknowns, kSize);
      const Eigen::VectorXd y =
          trial % 2 == 0 ? random_vector(random, m.strains, 1) : random_stress(random, m.strains);
      const Eigen::MatrixXd hessian = m.convex_hessian(q, y);
      EXPECT_LE((hessian - hessian.transpose()).norm(), 1e-14 * hessian.norm()) << m.header;
      EXPECT_GE(least_eigenvalue(hessian), -1e-13 * hessian.norm()) << m.header;
    }
  }
}

TEST(StrainMeasures, ConvexHessiansAreTheExactOnesWhereTheseAreConvex) {
  RandomStream random(12);
  for (const Measure& m : registry()) {
    int convex = 0;
    for (int trial = 0; trial < 200; ++trial) {
      const Eigen::VectorXd q = random_vector(random, m.unknowns, kSize);
      const Eigen::VectorXd y = random_stress(random, m.strains);
      const Eigen::MatrixXd exact = m.weighted_hessian(q, y);
      if (exact.norm() == 0 || least_eigenvalue(exact) < -1e-12 * exact.norm()) continue;
      ++convex;
      EXPECT_LT((m.convex_hessian(q, y) - exact).norm(), 1e-12 * exact.norm()) << m.header;
    }
    // A hinge's exact Hessian never is: its forces turn with the hinge. So do those of pressures.
    if (has_no_convex_part(m)) {
      EXPECT_EQ(convex, 0);
    } else {
      EXPECT_GE(convex, 5) << m.header;  // of six random stresses few are
    }
  }
}

TEST(StrainMeasures, ConvexHessianOfAHingeVanishes) {
  RandomStream random(13);
  const Measure hinge = measure<DiscreteShells>("discrete_shells", {0.3, 0.5 * kSize, 0.3});
  const Eigen::VectorXd q = random_vector(random, hinge.unknowns, kSize);
  EXPECT_EQ(hinge.convex_hessian(q, Eigen::VectorXd::Ones(1)).norm(), 0);
}

// Over all weights of the strains the stand-in lies nowhere below the exact Hessian for the
// measures that take the positive part of all of it.
TEST(StrainMeasures, ConvexHessiansOfMembranesAndSpringsMajoriseTheExactOnes) {
  RandomStream random(14);
  for (const Measure& m : registry()) {
    if (has_no_convex_part(m)) continue;
    for (int trial = 0; trial < 100; ++trial) {
      const Eigen::VectorXd q = random_vector(random, m.unknowns, kSize);
      const Eigen::VectorXd y = random_vector(random, m.strains, 1);
      const Eigen::MatrixXd added = m.convex_hessian(q, y) - m.weighted_hessian(q, y);
      EXPECT_GE(least_eigenvalue(added), -1e-12 * m.weighted_hessian(q, y).norm()) << m.header;
    }
  }
}

TEST(MembraneMeasures, MeasureStretchAndShearOfTheWeftAndWarp) {
  Eigen::Matrix<double, 2, 3> corners;
  corners << 0, 1, 0, 0, 0, 1;
  const MembraneRest rest = membrane_rest(corners);
  StvkMembrane::Positions stretched;  // u by 1.2, v by 0.9, sheared by 0.1
  stretched << 0, 1.2, 0.1, 0, 0, 0.9, 0, 0, 0;
  EXPECT_TRUE(StvkMembrane::strain(rest, stretched)
                  .isApprox(Eigen::Vector3d((1.44 - 1) / 2, (0.82 - 1) / 2, 0.12), 1e-14));
  EXPECT_TRUE(SoftConstraintMembrane::strain(rest, stretched)
                  .isApprox(Eigen::Vector3d(0.2, std::sqrt(0.82) - 1, 0.12), 1e-14));
}

TEST(MembraneMeasures, RefuseATriangleThatLiesTheWrongWayRound) {
  Eigen::Matrix<double, 2, 3> corners;
  corners << 0, 0, 1, 0, 1, 0;
  EXPECT_THROW(membrane_rest(corners), AssertionError);
}

TEST(SolidMeasures, MeasureStretchAndShearAlongTheAxesAtRest) {
  Eigen::Matrix3d f;
  f << 1.2, 0.1, 0, 0, 0.9, -0.2, 0.3, 0, 1.1;
  const Eigen::Matrix3d e = (f.transpose() * f - Eigen::Matrix3d::Identity()) / 2;
  Eigen::Vector<double, 6> expected;
  expected << e(0, 0), e(1, 1), e(2, 2), 2 * e(1, 2), 2 * e(0, 2), 2 * e(0, 1);
  const auto tetrahedron = skewed_tetrahedron();
  EXPECT_TRUE(LinearTetrahedron::strain(tetrahedron_rest(tetrahedron), f * tetrahedron)
                  .isApprox(expected, 1e-14));
  const auto hexahedron = skewed_hexahedron();
  double volume = 0;
  for (const HexahedronPoint& point : hexahedron_points(hexahedron)) {
    EXPECT_TRUE(TrilinearHexahedron::strain(point.rest, f * hexahedron).isApprox(expected, 1e-13));
    EXPECT_NEAR(TrilinearHexahedron::volume_ratio(point.rest, f * hexahedron), f.determinant(),
                1e-14);
    volume += point.size;
  }
  EXPECT_NEAR(HexahedronDilatation::strain({volume}, f * hexahedron)(0), f.determinant() - 1,
              1e-14);
}

TEST(SolidMeasures, RefuseElementsThatAreTurnedInsideOut) {
  LinearTetrahedron::Positions tetrahedron = skewed_tetrahedron();
  tetrahedron.col(0).swap(tetrahedron.col(1));
  EXPECT_THROW(tetrahedron_rest(tetrahedron), AssertionError);
  TrilinearHexahedron::Positions hexahedron = skewed_hexahedron();
  hexahedron.col(0).swap(hexahedron.col(6));
  EXPECT_THROW(hexahedron_points(hexahedron), AssertionError);
}

// Against looking at many places of the way.
TEST(Inversion, EndsWaysWhereTooLittleOfTheVolumeIsLeft) {
  constexpr int kPlaces = 2000;
  RandomStream random(15);
  int shortened = 0;
  for (int trial = 0; trial < 500; ++trial) {
    Eigen::Matrix3d from, way;
    for (double& x : from.reshaped()) x = random.normal();
    for (double& x : way.reshaped()) x = random.normal();
    if (from.determinant() < 0) from.col(0) *= -1;
    const double kept = trial % 2 == 0 ? 0.2 : 0;
    const double share = share_before_inversion(from, way, kept);
    shortened += share < 1 ? 1 : 0;
    const auto ratio = [&](double s) {
      return (from + s * way).determinant() / from.determinant();
    };
    for (int i = 0; i <= kPlaces; ++i) {
      EXPECT_GE(ratio(share * i / kPlaces), kept - 1e-9) << trial;
    }
    EXPECT_TRUE(share == 1 || std::abs(ratio(share) - kept) < 1e-9) << trial;
  }
  EXPECT_GT(shortened, 100);
  EXPECT_LT(shortened, 400);
}

TEST(Inversion, LeavesAWayThatKeepsTheVolumeWhole) {
  const Eigen::Matrix3d from = Eigen::Matrix3d::Identity();
  EXPECT_EQ(share_before_inversion(from, Eigen::Matrix3d::Zero(), 0.2), 1);
  EXPECT_EQ(share_before_inversion(from, from, 0.2), 1);
  EXPECT_EQ(share_before_inversion(-from, from, 0.2), 0);
  // Half way every edge is a half: an eighth of the volume.
  EXPECT_NEAR(share_before_inversion(from, -from, 1.0 / 8), 0.5, 1e-12);
}

DiscreteShells::Positions folded(double angle) {
  DiscreteShells::Positions x;
  x.col(0) << 0, 0, 0;
  x.col(1) << 0, 1, 0;
  x.col(2) << -1, 0.3, 0;
  x.col(3) << std::cos(angle), 0.6, std::sin(angle);
  return x;
}

TEST(DiscreteShells, MeasuresTheAngleBetweenTheNormals) {
  for (const double angle : {-3.0, -1.2, -0.01, 0.0, 0.4, 2.0, 3.1}) {
    EXPECT_NEAR(std::abs(dihedral_angle(folded(angle))), std::abs(angle), 1e-14);
  }
  EXPECT_LT(dihedral_angle(folded(0.4)) * dihedral_angle(folded(-0.4)), 0);
}

TEST(DiscreteShells, GoesOnThroughAHalfTurn) {
  const double before = dihedral_angle(folded(3.1));
  DiscreteShells::Rest rest{0, 0.3, before};
  const double here = DiscreteShells::strain(rest, folded(3.1))(0);
  const double beyond = DiscreteShells::strain(rest, folded(3.2))(0);
  EXPECT_NEAR(std::abs(beyond - here), 3 * 0.1 / 0.3, 1e-12);
}

TEST(DiscreteShells, OfACylinderIsThreeTimesItsCurvature) {
  // Two flat strips of width h inscribed in a circle: theta / h tends to the curvature with h^2.
  const double radius = 0.05;
  double last_error = 0;
  for (const double half : {0.1, 0.05, 0.025}) {  // half the angle that a strip spans
    const auto on_circle = [&](double turns) {
      return Eigen::Vector3d(radius * std::sin(turns * half), 0, radius * std::cos(turns * half));
    };
    DiscreteShells::Positions x;
    x << on_circle(0), on_circle(0) + Eigen::Vector3d(0, 0.01, 0), on_circle(-2), on_circle(2);
    const double width = 2 * radius * std::sin(half);
    const DiscreteShells::Rest rest{0, width, 0};
    const double error = std::abs(std::abs(DiscreteShells::strain(rest, x)(0)) - 3 / radius);
    if (last_error > 0) {
      EXPECT_NEAR(last_error / error, 4, 0.1);  // second order
    }
    last_error = error;
  }
}

}  // namespace
}  // namespace pliant
