// Eight stencils at once against the strain measures one by one, for the general kernel and for
// those that measures have of their own.

#include "pliant/mechanics/lane_kernel.h"

#include <array>
#include <string>
#include <type_traits>

#include <gtest/gtest.h>

#include "pliant/base/random.h"
#include "pliant/material/strain/hexahedron_dilatation.h"
#include "pliant/material/strain/linear_tetrahedron.h"
#include "pliant/material/strain/soft_constraint_membrane.h"
#include "pliant/material/strain/spring.h"
#include "pliant/material/strain/trilinear_hexahedron.h"
#include "pliant/mechanics/shells_lanes.h"
#include "pliant/mechanics/solid_lanes.h"
#include "pliant/mechanics/stvk_lanes.h"

namespace pliant {
namespace {

constexpr double kSize = 0.1;  // m, of the stencils

template <class Measure>
typename Measure::Rest random_rest(RandomStream& random);

template <>
MembraneRest random_rest<StvkMembrane>(RandomStream& random) {
  Eigen::Matrix<double, 2, 3> corners;
  corners << 0, random.uniform(0.8, 1.2), random.uniform(-0.2, 0.3), 0, random.uniform(-0.2, 0.2),
      random.uniform(0.7, 1.1);
  return membrane_rest(kSize * corners);
}

template <>
MembraneRest random_rest<SoftConstraintMembrane>(RandomStream& random) {
  return random_rest<StvkMembrane>(random);
}

template <>
Spring::Rest random_rest<Spring>(RandomStream& random) {
  return {kSize * random.uniform(0.5, 1.5)};
}

template <int Nodes>
SolidPointRest<Nodes> random_weights(RandomStream& random) {
  SolidPointRest<Nodes> rest;
  for (double& w : rest.weights.reshaped()) w = random.normal() / kSize;
  return rest;
}

template <>
LinearTetrahedron::Rest random_rest<LinearTetrahedron>(RandomStream& random) {
  return random_weights<4>(random);
}

template <>
TrilinearHexahedron::Rest random_rest<TrilinearHexahedron>(RandomStream& random) {
  return random_weights<8>(random);
}

template <>
HexahedronDilatation::Rest random_rest<HexahedronDilatation>(RandomStream& random) {
  return {kSize * kSize * kSize * random.uniform(0.5, 1.5)};
}

template <>
DiscreteShells::Rest random_rest<DiscreteShells>(RandomStream& random) {
  return {random.uniform(-1, 1), kSize * random.uniform(0.5, 1.5), random.uniform(-7, 7)};
}

/// Random stencils with a random answer of a material.
template <class Measure>
struct Stencil {
  std::array<typename Measure::Rest, kLanes> rests;
  LanePositions<Measure> positions;
  Response response{Measure::kStrains};
  Lane size;

  explicit Stencil(std::uint64_t seed) {
    RandomStream random(seed);
    for (auto& rest : rests) rest = random_rest<Measure>(random);
    for (double& x : positions.reshaped()) x = kSize * random.normal();
    for (double& y : response.stress.reshaped()) y = random.normal();
    for (double& a : size) a = random.uniform(0.1, 2);
    for (int l = 0; l < kLanes; ++l) {
      for (int i = 0; i < Measure::kStrains; ++i) {
        for (int j = 0; j <= i; ++j) {
          response.tangent(l, i * Measure::kStrains + j) =
              response.tangent(l, j * Measure::kStrains + i) = random.normal();
        }
      }
      // A stress of every pair of signs, and none at all.
      if (l == 4) response.stress.row(l) = response.stress.row(l).abs().eval();
      if (l == 5) response.stress.row(l) = -response.stress.row(l).abs().eval();
      if (l == 6) response.stress.row(l).setZero();
    }
  }

  typename Measure::Positions at(int lane) const {
    typename Measure::Positions x;
    for (int k = 0; k < Measure::kUnknowns; ++k) x(k) = positions(lane, k);
    return x;
  }
  typename Measure::Strain stress(int lane) const {
    return response.stress.row(lane).transpose().matrix();
  }
  Eigen::MatrixXd tangent(int lane) const {
    Eigen::MatrixXd result(Measure::kStrains, Measure::kStrains);
    for (int k = 0; k < result.size(); ++k) result(k) = response.tangent(lane, k);
    return result;
  }
};

template <class Measure>
class LaneKernels : public ::testing::Test {};

using Measures = ::testing::Types<StvkMembrane, SoftConstraintMembrane, Spring, DiscreteShells,
                                  LinearTetrahedron, TrilinearHexahedron, HexahedronDilatation>;

struct MeasureNames {
  template <class Measure>
  static std::string GetName(int) {
    if (std::is_same_v<Measure, StvkMembrane>) return "StvkMembrane";
    if (std::is_same_v<Measure, SoftConstraintMembrane>) return "SoftConstraintMembrane";
    if (std::is_same_v<Measure, LinearTetrahedron>) return "LinearTetrahedron";
    if (std::is_same_v<Measure, TrilinearHexahedron>) return "TrilinearHexahedron";
    if (std::is_same_v<Measure, HexahedronDilatation>) return "HexahedronDilatation";
    return std::is_same_v<Measure, Spring> ? "Spring" : "DiscreteShells";
  }
};

TYPED_TEST_SUITE(LaneKernels, Measures, MeasureNames);

TYPED_TEST(LaneKernels, HaveTheStrainsOfTheMeasure) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Stencil<TypeParam> s(seed);
    const LaneKernel<TypeParam> kernel(s.rests.data(), s.positions);
    const LaneStrains strain = kernel.strain();
    for (int l = 0; l < kLanes; ++l) {
      const typename TypeParam::Strain expected =
          TypeParam::strain(s.rests[static_cast<size_t>(l)], s.at(l));
      EXPECT_TRUE(strain.row(l).transpose().matrix().isApprox(expected, 1e-13));
      EXPECT_EQ(kernel.at(l), s.at(l));
    }
  }
}

TYPED_TEST(LaneKernels, HaveTheForcesOfTheMeasure) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Stencil<TypeParam> s(seed);
    LanePositions<TypeParam> gradient;
    LaneKernel<TypeParam>(s.rests.data(), s.positions).gradient(s.response, s.size, gradient);
    for (int l = 0; l < kLanes; ++l) {
      const Eigen::VectorXd expected =
          s.size(l) * TypeParam::gradient(s.rests[static_cast<size_t>(l)], s.at(l)).transpose() *
          s.stress(l);
      EXPECT_LE((gradient.row(l).transpose().matrix() - expected).norm(), 1e-12 * expected.norm());
    }
  }
}

TYPED_TEST(LaneKernels, HaveTheStiffnessOfTheMeasure) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Stencil<TypeParam> s(seed);
    for (const bool convex : {false, true}) {
      LaneHessian<TypeParam> hessian;
      LaneKernel<TypeParam>(s.rests.data(), s.positions)
          .hessian(s.response, s.size, convex, hessian);
      for (int l = 0; l < kLanes; ++l) {
        const auto& rest = s.rests[static_cast<size_t>(l)];
        const auto gradient = TypeParam::gradient(rest, s.at(l));
        const Eigen::MatrixXd expected =
            s.size(l) * (gradient.transpose() * s.tangent(l) * gradient +
                         (convex ? TypeParam::convex_weighted_hessian(rest, s.at(l), s.stress(l))
                                 : TypeParam::weighted_hessian(rest, s.at(l), s.stress(l))));
        int pair = 0;
        for (const auto& [i, j] : node_pairs<TypeParam>()) {
          Eigen::Matrix3d block;
          for (int k = 0; k < 9; ++k) block(k) = hessian(l, 9 * pair + k);
          EXPECT_LE((block - expected.block<3, 3>(3 * i, 3 * j)).norm(), 1e-12 * expected.norm())
              << "pair " << i << " " << j << (convex ? " convex" : "");
          ++pair;
        }
      }
    }
  }
}

TYPED_TEST(LaneKernels, NumberThePairsOfNodesRowByRow) {
  int next = 0;
  for (const auto& [i, j] : node_pairs<TypeParam>()) {
    EXPECT_EQ(pair_number<TypeParam>(i, j), next++);
  }
  EXPECT_EQ(next, kPairs<TypeParam>);
}

}  // namespace
}  // namespace pliant
