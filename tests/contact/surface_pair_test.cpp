#include "pliant/contact/surface_pair.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "pliant/base/random.h"

namespace pliant {
namespace {

using Kind = SurfacePair::Kind;
constexpr Kind kKinds[] = {Kind::vertex_face, Kind::edge_edge};

PairPoints random_points(RandomStream& random, double size = 1) {
  PairPoints points;
  for (double& x : points.reshaped()) x = random.uniform(-size, size);
  return points;
}

/// The least distance of many points of one part from many of the other.
double sampled_distance(Kind kind, const PairPoints& x) {
  constexpr int kSteps = 60;
  double least = INFINITY;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const double a = double(i) / kSteps, b = double(j) / kSteps;
      if (kind == Kind::edge_edge) {
        const Eigen::Vector3d one = (1 - a) * x.col(0) + a * x.col(1);
        const Eigen::Vector3d other = (1 - b) * x.col(2) + b * x.col(3);
        least = std::min(least, (one - other).norm());
      } else if (a + b <= 1) {
        const Eigen::Vector3d on_face = (1 - a - b) * x.col(1) + a * x.col(2) + b * x.col(3);
        least = std::min(least, (x.col(0) - on_face).norm());
      }
    }
  }
  return least;
}

TEST(SurfacePair, HasTheLeastDistance) {
  RandomStream random(1);
  for (int i = 0; i < 200; ++i) {
    for (const Kind kind : kKinds) {
      const PairPoints points = random_points(random);
      const double distance = gap_between(kind, points).distance();
      const double sampled = sampled_distance(kind, points);
      EXPECT_LE(distance, sampled + 1e-12);
      EXPECT_GT(distance, sampled - 0.06) << "as fine as it is sampled";
    }
  }
}

TEST(SurfacePair, ItsWeightsAreTheDerivativesOfTheDistance) {
  constexpr double kStep = 1e-6;
  RandomStream random(2);
  for (int i = 0; i < 100; ++i) {
    for (const Kind kind : kKinds) {
      const PairPoints points = random_points(random);
      const Gap gap = gap_between(kind, points);
      EXPECT_NEAR(gap.weights.sum(), 0, 1e-12);
      const PairPoints gradient = gap.line / gap.distance() * gap.weights.transpose();
      const PairPoints way = random_points(random);
      const double change = gap_between(kind, points + kStep * way).distance() -
                            gap_between(kind, points - kStep * way).distance();
      EXPECT_NEAR(change / (2 * kStep), gradient.cwiseProduct(way).sum(), 1e-5);
    }
  }
}

// Wherever they go: nearer than what is to be kept they are nowhere on the way, and where the way
// is cut short they have come that near.
TEST(SurfacePair, GoesAsFarAsItKeepsItsDistance) {
  constexpr int kSteps = 500;
  RandomStream random(3);
  int shortened = 0;
  for (int i = 0; i < 300; ++i) {
    for (const Kind kind : kKinds) {
      const PairPoints points = random_points(random), ways = random_points(random, 3);
      const double keep = random.uniform(0.05, 0.5) * gap_between(kind, points).distance();
      const double share = free_share(kind, points, ways, keep);
      ASSERT_GE(share, 0);
      ASSERT_LE(share, 1);
      for (int k = 0; k <= kSteps; ++k) {
        const PairPoints there = points + share * k / kSteps * ways;
        ASSERT_GT(gap_between(kind, there).distance(), keep * (1 - 1e-9));
      }
      if (share == 1) continue;
      ++shortened;
      EXPECT_LT(gap_between(kind, points + share * ways).distance(), 1.06 * keep);
    }
  }
  EXPECT_GT(shortened, 100);
}

TEST(SurfacePair, GoesWhereAllGo) {
  RandomStream random(4);
  for (const Kind kind : kKinds) {
    const PairPoints points = random_points(random);
    const PairPoints ways = Eigen::Vector3d(100, -50, 3).replicate<1, 4>();
    EXPECT_EQ(free_share(kind, points, ways, 0.9 * gap_between(kind, points).distance()), 1);
  }
}

TEST(SurfacePair, OfParallelEdgesHasItsDistance) {
  PairPoints points;
  points << 0, 1, 0.5, 2,  //
      0, 0, 0, 0,          //
      0, 0, 0.25, 0.25;
  EXPECT_DOUBLE_EQ(gap_between(Kind::edge_edge, points).distance(), 0.25);
}

}  // namespace
}  // namespace pliant
