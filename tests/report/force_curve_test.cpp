#include "pliant/report/force_curve.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "report/sample_sheets.h"
#include "support/virtual_sheets.h"

namespace pliant::report {
namespace {

using testing::hanging_sheet;
using testing::kSheetNodes;
using testing::stretched_sheet;

constexpr double kRounding = 1e-9;

/// A sheet whose clips go where a deformation takes them, each with a cord that pulls it by
/// `stiffness` (N/m) along its way.
Session moved_sheet(const std::string& test, const std::vector<std::vector<int>>& clips,
                    const Eigen::Matrix3d& deformation, double stiffness) {
  Session session = test::clamped_sheet(test, kSheetNodes, clips);
  SessionFrame frame;
  frame.positions = deformation * session.rest.positions;
  frame.poses.resize(clips.size());
  session.frames = {frame};
  session.frames[0].cords.resize(clips.size());
  for (std::size_t c = 0; c < clips.size(); ++c) {
    const Eigen::Vector3d now = clip_middle(session, 0, static_cast<int>(c));
    const Eigen::Vector3d rest = session.rest.positions(Eigen::all, clips[c]).rowwise().mean();
    session.frames[0].cords[c] = {{"", now, stiffness * (now - rest)}};
  }
  return session;
}

TEST(ForceCurve, OfAStretchIsThePullOverTheExtension) {
  const std::vector<ForceCurve> curves = force_curves(stretched_sheet(5, 4e-3, 50));
  ASSERT_EQ(curves.size(), 1u);
  ASSERT_EQ(curves[0].force.size(), 5u);
  for (std::size_t f = 0; f < 5; ++f) {
    EXPECT_NEAR(curves[0].displacement[f], static_cast<double>(f), kRounding);  // mm
    EXPECT_NEAR(curves[0].force[f], 0.05 * static_cast<double>(f), kRounding);
  }
}

TEST(ForceCurve, OfAStripIsWhatItsTesterShows) {
  Session session = stretched_sheet(3, 4e-3, 50);
  session.kind = SessionKind::strip;
  for (SessionFrame& frame : session.frames) frame.cords[0].clear();
  session.frames[1].cords[1].front().point.x() -= 1e-3;  // slack by as much
  const std::vector<ForceCurve> curves = force_curves(session);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_EQ(curves[0].of.name, "Force");
  EXPECT_NEAR(curves[0].displacement[1], 1, kRounding);  // mm
  EXPECT_NEAR(curves[0].displacement[2], 4, kRounding);
  EXPECT_NEAR(curves[0].force[2], 0.05 * 4, kRounding);
}

TEST(ForceCurve, OfBarsThatSlideIsThePullAlongThem) {
  Eigen::Matrix3d slide = Eigen::Matrix3d::Identity();
  slide(0, 1) = 0.1;
  const Session session =
      moved_sheet("complex-shear",
                  {test::side(kSheetNodes, 1, false), test::side(kSheetNodes, 1, true)}, slide, 30);
  const std::vector<ForceCurve> curves = force_curves(session);
  ASSERT_EQ(curves.size(), 1u);
  // Middles of the bars are 7/8 of the side apart, and slide a tenth of that.
  const double apart = 1e3 * testing::kSheetSide * 7 / 8 / 10;
  EXPECT_NEAR(curves[0].displacement[0], apart, kRounding);
  EXPECT_NEAR(curves[0].force[0], 30 * apart / 1e3 / 2, kRounding);
}

TEST(ForceCurve, OfFourBarsIsTheTorqueOverTheShearAngle) {
  const double half = 0.1;
  Eigen::Matrix3d shear = Eigen::Matrix3d::Identity();
  shear.topLeftCorner<2, 2>() << std::cos(half), std::sin(half), std::sin(half), std::cos(half);
  const Session session = moved_sheet(
      "shear",
      {test::middle_of_side(kSheetNodes, 0, false), test::middle_of_side(kSheetNodes, 0, true),
       test::middle_of_side(kSheetNodes, 1, false), test::middle_of_side(kSheetNodes, 1, true)},
      shear, 10);
  const std::vector<ForceCurve> curves = force_curves(session);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_EQ(curves[0].of.unit, "mN m");
  EXPECT_NEAR(curves[0].displacement[0], 2 * half * 180 / std::numbers::pi, 1e-6);
}

TEST(ForceCurve, OfThreeClipsIsTheForceOfEach) {
  const Session session = moved_sheet(
      "a test of its own",
      {test::middle_of_side(kSheetNodes, 0, false), test::middle_of_side(kSheetNodes, 0, true),
       test::middle_of_side(kSheetNodes, 1, false)},
      1.1 * Eigen::Matrix3d::Identity(), 20);
  const std::vector<ForceCurve> curves = force_curves(session);
  ASSERT_EQ(curves.size(), 3u);
  for (const ForceCurve& curve : curves) {
    EXPECT_NEAR(curve.force[0], 20 * curve.displacement[0] / 1e3, kRounding) << curve.clip;
  }
}

TEST(ForceCurve, IsNoneWithoutClips) { EXPECT_TRUE(force_curves(hanging_sheet(2)).empty()); }

}  // namespace
}  // namespace pliant::report
