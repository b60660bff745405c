// Bent sheets that are laid flat.
#include "pliant/capture/unrolled_sheet.h"

#include <cmath>
#include <functional>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/capture/dic_import.h"
#include "pliant/capture/rest_places.h"

#include "io/temporary_folder.h"

namespace pliant {
namespace {

using test::TemporaryFolder;

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

// A seam without points, and a stray point off the rim.
TEST(UnrolledSheet, OfPiecesIsThatOfTheLargest) {
  const Sheet bent = sheet([](const auto& place) { return on_cylinder(place, 0.04, 0.5); });
  std::vector<int> kept;
  for (Eigen::Index i = 0; i < bent.flat.cols(); ++i) {
    const double x = bent.flat(0, i);
    if (x < 0.041 || x > 0.051) kept.push_back(static_cast<int>(i));
  }
  Eigen::Matrix3Xd points(3, std::ssize(kept) + 1);
  points.leftCols(std::ssize(kept)) = bent.bent(Eigen::all, kept);
  points.rightCols<1>() << 0.08, 0.02, 0.03;
  const UnrolledSheet flat = unrolled(points, kReach);
  EXPECT_LT(flat.stretch, 3e-4);
  std::vector<int> large;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (bent.flat(0, kept[i]) < 0.041) large.push_back(static_cast<int>(i));
  }
  const Eigen::Matrix2Xd own = flat.places(Eigen::all, large);
  std::vector<int> sources;
  for (const int i : large) sources.push_back(kept[static_cast<std::size_t>(i)]);
  EXPECT_LT(miss(own, bent.flat(Eigen::all, sources)), 0.01e-3);
  EXPECT_LT((flat.places - points.topRows<2>()).colwise().norm().maxCoeff(), 5e-3);
}

TEST(UnrolledSheet, OfTooFewPointsIsWhatItsPlaneShows) {
  const Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Random(3, 4);
  EXPECT_EQ(unrolled(points, 1e-3).places, Eigen::Matrix2Xd(points.topRows<2>()));
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

// To its corners, whatever is near to them.
TEST(RestPlaces, AreUnrolledForEachPoint) {
  const Sheet bent = sheet([](const auto& place) { return on_cylinder(place, 0.04, 0.5); });
  SampleAxes axes;
  axes.off_plane = 2e-3;
  const RestPlaces places(axes, bent.bent, {0.06, 0.04}, kSpacing);
  EXPECT_LT(miss(places.of(bent.bent), bent.flat), 0.01e-3);
  const Eigen::Matrix3Xd some = bent.bent(Eigen::all, std::vector{0, 30, 200, 650});
  EXPECT_EQ(places.of(some), places.of(bent.bent)(Eigen::all, std::vector{0, 30, 200, 650}));
}

/// A table of numbered points.
std::string table_of(const Eigen::Matrix3Xd& points) {
  std::string text = "id;X [mm];Y [mm];Z [mm]\n";
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector3d at = 1e3 * points.col(i);
    text += fmt::format("{};{};{};{}\n", i, at.x(), at.y(), at.z());
  }
  return text;
}

/// Tables of a sheet that is bent in the first frame and pulled flat along warp.
std::filesystem::path described(const TemporaryFolder& folder, const Sheet& first, double strain) {
  const Sheet pulled = sheet([&](const Eigen::Vector2d& place) {
    return Eigen::Vector3d(place.x(), (1 + strain) * (place.y() - 0.02) + 0.02, 0.004);
  });
  folder.write("s/0.csv", table_of(first.bent));
  folder.write("s/1.csv", table_of(pulled.bent));
  return folder.write("s.yaml",
                      "pliant: dic/1\ntest: pull\npoints: s/*.csv\n"
                      "sample: {width: 60 mm, height: 40 mm, mass: 0.5 g}\n"
                      "clips: [{name: lower, side: bottom}, {name: upper, side: top}]\n");
}

// Seen from above an arch is 2.7 % shorter than the sheet.
TEST(UnrolledSheet, CountsStrainFromWhatItMeasuresAlongItself) {
  const TemporaryFolder folder;
  const Sheet arch = sheet([](const Eigen::Vector2d& place) -> Eigen::Vector3d {
    constexpr double kRadius = 0.05;
    const double angle = (place.y() - 0.02) / kRadius;
    return {place.x(), 0.02 + kRadius * std::sin(angle), kRadius * (std::cos(angle) - 1)};
  });
  const DicImport made = import_dic(described(folder, arch, 0.05), {}, {});
  ASSERT_TRUE(made.made.unrolled);
  EXPECT_LT(*made.made.unrolled, 1e-3);
  EXPECT_THAT(made.study.notes, ::testing::Contains(::testing::HasSubstr("it was unrolled")));
  ASSERT_EQ(made.made.middle->strain.size(), 2U);
  EXPECT_NEAR(made.made.middle->strain[1], 0.05, 5e-4);
  // A clip is where the cloth at its edge is, in the first frame too.
  const Session& session = made.made.session;
  const double end = session.frames[0].poses[1].apply({0.03, 0.04, 0}).z();
  const double middle = session.frames[0].positions.row(2).maxCoeff();
  EXPECT_NEAR(middle - end, 0.05 * (1 - std::cos(0.02 / 0.05)), 0.2e-3);
}

TEST(UnrolledSheet, WarnsOfASampleThatIsWrinkled) {
  const TemporaryFolder folder;
  const Sheet dents = sheet([](const Eigen::Vector2d& place) {
    const double height =
        1.5e-3 * std::sin(2 * M_PI * place.x() / 0.02) * std::sin(2 * M_PI * place.y() / 0.02);
    return Eigen::Vector3d(place.x(), place.y(), height);
  });
  EXPECT_THAT(
      import_dic(described(folder, dents, 0), {}, {}).study.warnings,
      ::testing::Contains(::testing::HasSubstr("s/0.csv: the sample is wrinkled in this first "
                                               "frame")));
}

}  // namespace
}  // namespace pliant
