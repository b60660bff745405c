// Bent sheets that are laid flat.
#include "pliant/capture/unrolled_sheet.h"

#include <cmath>
#include <functional>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace pliant {
namespace {

constexpr double kSpacing = 2e-3, kReach = 2.3 * kSpacing;  // m

struct Sheet {
  Eigen::Matrix2Xd flat;
  Eigen::Matrix3Xd bent;
};

/// Of 60 mm x 40 mm.
Sheet sheet(const std::function<Eigen::Vector3d(const Eigen::Vector2d&)>& bend) {
  constexpr int kColumns = 31, kRows = 21;
  Sheet sheet{Eigen::Matrix2Xd(2, kColumns * kRows), Eigen::Matrix3Xd(3, kColumns * kRows)};
  for (int i = 0; i < kColumns * kRows; ++i) {
    sheet.flat.col(i) << (i % kColumns) * kSpacing, (i / kColumns) * kSpacing;
    sheet.bent.col(i) = bend(sheet.flat.col(i));
  }
  return sheet;
}

/// Root mean square of what a rigid motion of the plane leaves.
double miss(const Eigen::Matrix2Xd& places, const Eigen::Matrix2Xd& flat) {
  const Eigen::Matrix3d rigid = Eigen::umeyama(places, flat, false);
  const Eigen::Matrix2Xd off =
      ((rigid.topLeftCorner<2, 2>() * places).colwise() + rigid.topRightCorner<2, 1>()) - flat;
  return std::sqrt(off.squaredNorm() / static_cast<double>(off.cols()));
}

Eigen::Vector3d on_cylinder(const Eigen::Vector2d& place, double radius, double turn) {
  // Its axis lies askew to the sheet's.
  const Eigen::Vector2d along(std::cos(turn), std::sin(turn)), across(-along.y(), along.x());
  const double arc = across.dot(place - Eigen::Vector2d(0.03, 0.02));
  const Eigen::Vector2d in_plane =
      along.dot(place) * along + radius * std::sin(arc / radius) * across;
  return {in_plane.x(), in_plane.y(), radius * std::cos(arc / radius)};
}

TEST(UnrolledSheet, OfACylinderIsTheSheetThatWasBent) {
  const Sheet bent = sheet([](const auto& place) { return on_cylinder(place, 0.04, 0.5); });
  const UnrolledSheet flat = unrolled(bent.bent, kReach);
  EXPECT_GT(miss(bent.bent.topRows<2>(), bent.flat), 0.3e-3) << "seen from above it is shorter";
  EXPECT_LT(miss(flat.places, bent.flat), 0.01e-3);
  EXPECT_LT(flat.stretch, 3e-4);
}

TEST(UnrolledSheet, OfAFlatSheetIsThatSheet) {
  const Sheet level =
      sheet([](const auto& place) { return Eigen::Vector3d(place.x(), place.y(), 0.3); });
  const UnrolledSheet flat = unrolled(level.bent, kReach);
  EXPECT_LT((flat.places - level.flat).colwise().norm().maxCoeff(), 1e-9);
  EXPECT_LT(flat.stretch, 1e-9);
}

// No part of a ball can be laid flat without stretching.
TEST(UnrolledSheet, OfABallTellsHowMuchItHadToStretch) {
  const Sheet ball = sheet([](const auto& place) {
    const Eigen::Vector2d off = place - Eigen::Vector2d(0.03, 0.02);
    return Eigen::Vector3d(place.x(), place.y(), std::sqrt(0.05 * 0.05 - off.squaredNorm()));
  });
  EXPECT_GT(unrolled(ball.bent, kReach).stretch, 0.01);
}

TEST(UnrolledSheet, OfManyFoldsConvergesToo) {
  // A sine along weft, whose arc length is known by small steps.
  const auto height = [](double x) { return 1.5e-3 * std::sin(2 * M_PI * x / 0.02); };
  const Sheet folds = sheet([&](const auto& place) {
    constexpr int kSteps = 4000;
    double x = 0, length = 0;
    while (length < place.x()) {
      const double step = 0.06 / kSteps;
      length += std::hypot(step, height(x + step) - height(x));
      x += step;
    }
    return Eigen::Vector3d(x, place.y(), height(x));
  });
  const UnrolledSheet flat = unrolled(folds.bent, kReach);
  EXPECT_GT(miss(folds.bent.topRows<2>(), folds.flat), 0.5e-3);
  EXPECT_LT(miss(flat.places, folds.flat), 0.1e-3);
  EXPECT_LT(flat.stretch, 0.01);
}

}  // namespace
}  // namespace pliant
