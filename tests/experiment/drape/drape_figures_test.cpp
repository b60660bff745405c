#include "pliant/experiment/drape/drape_figures.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace pliant {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

template <class Radius>
std::vector<double> outline(Radius radius) {
  std::vector<double> radii;
  for (int i = 0; i < 720; ++i) radii.push_back(radius(kTurn * i / 720));
  return radii;
}

TEST(DrapeFigures, CoefficientGoesFromTheDiscToTheFlatSpecimen) {
  EXPECT_EQ(drape_coefficient(1, 1, 3), 0);
  EXPECT_EQ(drape_coefficient(3, 1, 3), 1);
  EXPECT_EQ(drape_coefficient(2, 1, 3), 0.5);
}

TEST(DrapeFigures, CountAndMeasureFolds) {
  for (const int nodes : {2, 5, 8}) {
    const DrapeFigures figures = fold_figures(
        outline([&](double angle) { return 0.12 + 0.01 * std::cos(nodes * angle + 0.3); }), 0.06);
    EXPECT_EQ(figures.nodes, nodes);
    EXPECT_NEAR(figures.amplitude, 0.01, 1e-5);      // of angles half a degree apart
    EXPECT_NEAR(figures.irregularity, 0, 0.5 / 45);  // half a degree of the least spacing
  }
}

TEST(DrapeFigures, ACircleHasNoFolds) {
  const DrapeFigures figures = fold_figures(outline([](double) { return 0.12; }), 0.06);
  EXPECT_EQ(figures.nodes, 0);
  EXPECT_EQ(figures.amplitude, 0);
}

TEST(DrapeFigures, WrinklesBelowAThirtiethOfTheOverhangAreNoFolds) {
  const auto wrinkled = [](double height) {
    return outline([=](double angle) {
      return 0.12 + 0.01 * std::cos(4 * angle) + height / 2 * std::cos(40 * angle + 0.1);
    });
  };
  EXPECT_EQ(fold_figures(wrinkled(0.0015), 0.06).nodes, 4);
  EXPECT_GT(fold_figures(wrinkled(0.004), 0.06).nodes, 4);
}

TEST(DrapeFigures, FoldsThatAreNotEvenlySpreadAreIrregular) {
  // Maxima at 0, 0.25 and 0.5 of a turn.
  const auto radii = outline([](double angle) {
    const double turn = angle / kTurn;
    return turn < 0.5 ? std::cos(2 * kTurn * 2 * turn) : std::cos(2 * kTurn * (turn - 0.5));
  });
  const std::vector<double> nodes = nodes_of(radii, 0.5);
  ASSERT_EQ(nodes.size(), 3U);
  EXPECT_NEAR(nodes[1], 0.25, 1.0 / 720);
  const double third = 1.0 / 3, gap = 0.25 - third;
  const double deviation = std::sqrt((2 * gap * gap + 4 * gap * gap) / 2);
  EXPECT_NEAR(fold_figures(radii, 1).irregularity, deviation / third, 0.01);
}

TEST(DrapeFigures, DoNotDependOnWhereTheOutlineBegins) {
  const auto radii = [](double begin) {
    return outline([=](double angle) {
      const double a = angle + begin;
      return 0.12 + 0.01 * std::cos(5 * a) + 0.003 * std::cos(3 * a) + 0.0005 * std::cos(31 * a);
    });
  };
  const DrapeFigures first = fold_figures(radii(0), 0.06);
  for (int i = 1; i < 720; i += 37) {
    const DrapeFigures other = fold_figures(radii(kTurn * i / 720), 0.06);
    EXPECT_EQ(other.nodes, first.nodes);
    EXPECT_NEAR(other.amplitude, first.amplitude, 1e-12);  // rounding
  }
}

}  // namespace
}  // namespace pliant
