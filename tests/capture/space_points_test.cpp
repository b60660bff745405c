// Points in space by several cameras, on pictures that are drawn.
#include "pliant/capture/space_points.h"

#include <cmath>
#include <cstdio>
#include <map>
#include <memory>

#include <Eigen/Eigenvalues>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/errors.h"

#include "capture/drawn_label.h"
#include "capture/drawn_rig.h"
#include "support/asked_for.h"

namespace pliant {
namespace {

struct Errors {
  double in_plane = 0, off_plane = 0, largest = 0;  ///< root mean squares (m)
  int points = 0;
};

/// Of the points of a frame against how the sheet was moved.
Errors errors_of(const PointFrame& points, const test::SheetMotion& motion) {
  Errors errors;
  errors.points = points.count();
  double in_plane = 0, off_plane = 0;
  for (int i = 0; i < points.count(); ++i) {
    const Eigen::Vector3d off = points.moved.col(i) - motion(points.rest.col(i).head<2>());
    in_plane += off.head<2>().squaredNorm() / 2;
    off_plane += off.z() * off.z();
    errors.largest = std::max(errors.largest, off.norm());
  }
  errors.in_plane = std::sqrt(in_plane / points.count());
  errors.off_plane = std::sqrt(off_plane / points.count());
  return errors;
}

Eigen::Vector3d at_rest(const Eigen::Vector2d& place) { return {place.x(), place.y(), 0}; }

/// On a cylinder about an axis along v.
Eigen::Vector3d rolled(const Eigen::Vector2d& place, double radius) {
  const double angle = (place.x() - 0.03) / radius;
  return {0.03 + radius * std::sin(angle), place.y(), radius * (std::cos(angle) - 1)};
}

Eigen::Vector3d pulled_askew(const Eigen::Vector2d& place) {
  return {1.05 * place.x(), 0.98 * place.y() + 0.03 * place.x(), 0.002};
}

Eigen::Vector3d tilted_sheet(const Eigen::Vector2d& place) {
  return Eigen::AngleAxisd(0.2, Eigen::Vector3d(1, 0.5, 0.3).normalized()) * at_rest(place);
}

RunContext with(int threads) {
  RunContext context;
  context.threads = threads;
  return context;
}

TEST(SlowSpacePoints, FollowASheetThatIsStretchedTurnedAndRolled) {
  constexpr double kRadius = 0.05;
  test::DrawnRig rig(3, 480, 420, 0.06);
  rig.frames = {at_rest, pulled_askew, tilted_sheet,
                [](const Eigen::Vector2d& place) { return rolled(place, kRadius); }, at_rest};
  const DicFile dic = rig.dic();
  SpacePoints points(dic, rig.reader(), with(2));
  const Errors first = errors_of(points.read(0), rig.frames[0]);
  EXPECT_GT(first.points, 400);
  EXPECT_LT(first.off_plane, 0.006e-3);
  EXPECT_GT(points.read(0).deviations.minCoeff(), 0.3e-6);
  for (const int f : {1, 2}) {
    const PointFrame frame = points.read(f);
    const Errors errors = errors_of(frame, rig.frames[f]);
    EXPECT_EQ(frame.lost, 0) << f;
    EXPECT_LT(errors.in_plane, 0.004e-3) << f;
    EXPECT_LT(errors.off_plane, 0.006e-3) << f;
  }
  // A patch is as wide as 21 pixels, and lies where its middle and its rim are on average.
  const double patch = 21 * 0.25e-3;
  const Errors bent = errors_of(points.read(3), rig.frames[3]);
  EXPECT_LT(bent.off_plane, 1.3 * patch * patch / (24 * kRadius));
  EXPECT_LT(bent.in_plane, 0.012e-3);
  // Nothing adds up on the way there and back.
  const Errors back = errors_of(points.read(4), rig.frames[4]);
  EXPECT_EQ(back.points, first.points);
  EXPECT_LT(back.in_plane, 0.004e-3);
  EXPECT_LT(back.off_plane, 0.006e-3);
}

/// Stretched, narrowed and turned out of its plane.
/// @param part  of the whole way, 0 to 1
Eigen::Vector3d part_of_the_way(const Eigen::Vector2d& place, double part) {
  const Eigen::AngleAxisd turn(0.1 * part, Eigen::Vector3d(1, 0.5, 0.3).normalized());
  return turn *
         Eigen::Vector3d((1 + 0.06 * part) * place.x(), (1 - 0.02 * part) * place.y(), 2e-3 * part);
}

TEST(SlowSpacePoints, ComeBackToWhereTheyBeganAfterAnyNumberOfFrames) {
  const int frames = test::makes_figures() ? 200 : 10;
  test::DrawnRig rig(3, 300, 280, 0.035);
  for (int f = 0; f <= frames; ++f) {
    const double part = 1 - std::abs(1 - 2.0 * f / frames);
    rig.frames.emplace_back(
        [part](const Eigen::Vector2d& place) { return part_of_the_way(place, part); });
  }
  const DicFile dic = rig.dic();
  SpacePoints points(dic, rig.reader(), with(2));
  const int all = points.read(0).count();
  PointFrame last;
  for (int f = 1; f <= frames; ++f) last = points.read(f);
  ASSERT_EQ(last.count(), all);
  const double off = (last.moved - last.rest).norm() / std::sqrt(all);
  constexpr double kPixel = 0.25e-3;  // m, on the sheet
  const MatchQuality& matches = last.quality->matches;
  std::printf(
      "after %d frames there and back %d points are off their start by %.4f mm RMS; followed from "
      "picture to picture by %.4f px, %.4f mm (median), %d of %d broken\n",
      frames, all, 1e3 * off, matches.drift, 1e3 * kPixel * matches.drift, matches.broken,
      matches.chained);
  EXPECT_LT(off, 0.01e-3);
}

/// Draws what a picture shows once.
ReadPicture kept(const ReadPicture& read) {
  auto known = std::make_shared<std::map<std::filesystem::path, GreyPicture>>();
  return [known, read](const std::filesystem::path& file) {
    const auto found = known->find(file);
    if (found != known->end()) return found->second;
    return known->emplace(file, read(file)).first->second;
  };
}

/// Errors of cameras as a calibration has them: a pixel of focal length, a half of the principal
/// point, 0.1 mrad and 0.05 mm; those of neighbouring numbers lean on each other.
Eigen::MatrixXd errors_of_calibration(Eigen::Index cameras) {
  Eigen::Vector<double, 15> sd;
  sd << 1, 1, 0.5, 0.5, 1e-3, 5e-3, 5e-5, 5e-5, 0, 1e-4, 1e-4, 1e-4, 5e-5, 5e-5, 5e-5;
  const Eigen::Index count = sd.size();
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(count * cameras, count * cameras);
  for (Eigen::Index c = 0; c < cameras; ++c) {
    auto own = covariance.block(count * c, count * c, count, count);
    own.diagonal() = sd.cwiseAbs2();
    own(0, 1) = own(1, 0) = 0.8 * sd(0) * sd(1);
    own(9, 13) = own(13, 9) = -0.5 * sd(9) * sd(13);
  }
  return covariance;
}

/// The numbers of cameras off by errors of that covariance.
std::vector<CameraModel> drawn_cameras(std::vector<CameraModel> cameras,
                                       const Eigen::MatrixXd& covariance, std::uint64_t seed) {
  RandomStream random(seed);
  Eigen::VectorXd normal(covariance.rows());
  for (double& number : normal) number = random.normal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> split(covariance);
  const Eigen::VectorXd off =
      split.eigenvectors() * split.eigenvalues().cwiseMax(0).cwiseSqrt().cwiseProduct(normal);
  for (std::size_t c = 0; c < cameras.size(); ++c) {
    const Eigen::VectorXd own = off.segment<15>(15 * static_cast<Eigen::Index>(c));
    cameras[c].intrinsics += own.head<9>();
    cameras[c].pose.rotation += own.segment<3>(9);
    cameras[c].pose.translation += own.tail<3>();
  }
  return cameras;
}

TEST(SlowSpacePoints, StateErrorsThatCoverTheTruth) {
  test::DrawnRig rig(3, 300, 280, 0.035);
  rig.frames = {at_rest, pulled_askew, tilted_sheet};
  const ReadPicture read = kept(rig.reader());
  const Eigen::MatrixXd covariance = errors_of_calibration(3);
  const int seeds = test::makes_figures() ? 60 : 20;
  Eigen::Array3d held = Eigen::Array3d::Zero(), deviation = Eigen::Array3d::Zero();
  double count = 0;
  for (int seed = 0; seed < seeds; ++seed) {
    DicFile dic = rig.dic();
    dic.views->covariance = covariance;
    dic.views->cameras = drawn_cameras(rig.cameras, covariance, static_cast<std::uint64_t>(seed));
    SpacePoints points(dic, read, with(2));
    for (int f = 1; f < dic.frame_count(); ++f) {
      const PointFrame frame = points.read(f);
      // The axes are told by the sample's corners and move with the calibration, too.
      for (int i = 0; i < frame.count(); ++i) {
        const Eigen::Array3d off = frame.moved.col(i) - rig.frames[f](frame.rest.col(i).head<2>());
        held += (off.abs() < 1.96 * frame.deviations.col(i).array()).cast<double>();
        deviation += frame.deviations.col(i).array();
        ++count;
      }
    }
  }
  held /= count;
  deviation /= count;
  std::printf(
      "95 %% intervals hold %.1f, %.1f, %.1f %% along u, v and off the plane, of %.4f, "
      "%.4f, %.4f mm\n",
      100 * held.x(), 100 * held.y(), 100 * held.z(), 1e3 * deviation.x(), 1e3 * deviation.y(),
      1e3 * deviation.z());
  EXPECT_GT(held.minCoeff(), 0.90);
  EXPECT_LT(held.maxCoeff(), 0.995);
}

/// A board in front of a part of the sheet.
DrawnSurface board_before(double from, double to) {
  const Eigen::AlignedBox2d box(Eigen::Vector2d(from, -0.01), Eigen::Vector2d(to, 0.05));
  return flat_rectangle(box, 0.02, [](const Eigen::Vector2d&) { return 0.4; });
}

TEST(SlowSpacePoints, AreLostBehindSomethingAndFoundAgain) {
  test::DrawnRig rig(2, 360, 340, 0.04);
  rig.frames = {at_rest, pulled_askew, pulled_askew};
  rig.others = [](int frame) {
    std::vector<DrawnSurface> boards;
    if (frame == 1) boards.push_back(board_before(0.028, 0.06));
    return boards;
  };
  const DicFile dic = rig.dic();
  SpacePoints points(dic, rig.reader(), with(1));
  const int all = points.read(0).count();
  const PointFrame hidden = points.read(1);
  EXPECT_GT(hidden.lost, all / 3);
  EXPECT_GT(hidden.count(), all / 5);
  EXPECT_LT(errors_of(hidden, rig.frames[1]).largest, 0.1e-3);
  const PointFrame again = points.read(2);
  EXPECT_EQ(again.count(), all);
  EXPECT_LT(errors_of(again, rig.frames[2]).off_plane, 0.006e-3);
}

TEST(SlowSpacePoints, LeaveThePictureAndAreFoundAgain) {
  test::DrawnRig rig(2, 300, 280, 0.035);
  // Half the picture is 37 mm wide, and half the sheet 17 mm.
  const auto aside = [](const Eigen::Vector2d& place) {
    return Eigen::Vector3d(place.x() + 0.03, place.y(), 0);
  };
  rig.frames = {at_rest, aside, at_rest};
  const DicFile dic = rig.dic();
  SpacePoints points(dic, rig.reader(), with(2));
  const int all = points.read(0).count();
  const PointFrame outside = points.read(1);
  EXPECT_GT(outside.lost, all / 6);
  EXPECT_GT(outside.count(), all / 3);
  EXPECT_LT(errors_of(outside, aside).largest, 0.1e-3);
  const PointFrame again = points.read(2);
  EXPECT_EQ(again.count(), all);
  const Errors back = errors_of(again, at_rest);
  EXPECT_LT(back.in_plane, 0.004e-3);
  EXPECT_LT(back.off_plane, 0.006e-3);
}

TEST(SlowSpacePoints, AreTheSameOnAnyNumberOfThreads) {
  test::DrawnRig rig(2, 300, 280, 0.035);
  rig.frames = {at_rest, tilted_sheet};
  const DicFile dic = rig.dic();
  SpacePoints one(dic, rig.reader(), with(1)), two(dic, rig.reader(), with(2));
  EXPECT_EQ(one.read(1).moved, two.read(1).moved);
}

TEST(SlowSpacePoints, RefuseCamerasThatWereExchanged) {
  test::DrawnRig rig(3, 300, 280, 0.035);
  rig.frames = {at_rest};
  DicFile dic = rig.dic();
  std::swap(dic.views->files[1], dic.views->files[2]);
  EXPECT_THAT([&] { SpacePoints(dic, rig.reader(), with(1)); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("exchanged")));
}

TEST(SlowSpacePoints, RefuseACameraThatWasTurned) {
  test::DrawnRig rig(2, 300, 280, 0.035);
  rig.frames = {at_rest};
  DicFile dic = rig.dic();
  dic.views->cameras[1].pose.rotation.x() += 0.01;  // 20 pixels
  EXPECT_THAT([&] { SpacePoints(dic, rig.reader(), with(1)); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("moved")));
}

TEST(SpacePoints, RefuseAPictureOfAnotherSizeThanItsCameras) {
  test::DrawnRig rig(2, 120, 110, 0.02);
  rig.frames = {at_rest};
  const DicFile dic = rig.dic();
  const ReadPicture cut = [](const std::filesystem::path& file) -> GreyPicture {
    return GreyPicture::Constant(110, file == "1/0" ? 118 : 120, 0.5F);
  };
  EXPECT_THAT([&] { SpacePoints(dic, cut, with(1)); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr(
                  "1/0: is 118 x 110 pixels, and those of its camera's calibration 120 x 110")));
}

// All of them: what they see of a point goes together, and the sample is smaller by all of it.
TEST(SlowSpacePoints, AreWarnedOfCamerasThatWereRefocused) {
  test::DrawnRig rig(2, 300, 280, 0.035);
  rig.frames = {at_rest};
  DicFile dic = rig.dic();
  for (CameraModel& camera : dic.views->cameras) camera.intrinsics.head<2>() *= 1.02;
  const SpacePoints points(dic, rig.reader(), with(2));
  EXPECT_THAT(points.warnings(),
              testing::Each(testing::AllOf(testing::HasSubstr("% less than the 35"),
                                           testing::HasSubstr("was a camera refocused?"))));
  EXPECT_EQ(points.warnings().size(), 2u);  // wide, and high
}

TEST(SlowSpacePoints, AreWarnedOfACameraThatWasRefocused) {
  test::DrawnRig rig(2, 420, 400, 0.07);
  rig.frames = {at_rest};
  DicFile dic = rig.dic();
  EXPECT_THAT(SpacePoints(dic, rig.reader(), with(2)).warnings(), testing::IsEmpty());
  dic.views->cameras[1].intrinsics.head<2>() *= 1.02;  // 3 pixels at the rim of the sample
  EXPECT_THAT(SpacePoints(dic, rig.reader(), with(2)).warnings(),
              testing::Contains(testing::HasSubstr("lines of sight miss each other by")));
}

TEST(SlowSpacePoints, NameTheCameraThatFixedTagsSeeMove) {
  test::DrawnRig rig(2, 300, 280, 0.035);
  rig.frames = {at_rest, pulled_askew, pulled_askew};
  rig.others = [](int) { return std::vector{test::drawn_label(30, {-0.008, 0.018})}; };
  DicFile dic = rig.dic();
  dic.fixed = {30};
  SpacePoints points(dic, rig.reader(), with(2));
  EXPECT_EQ(points.read(1).quality->moved, "");
  rig.cameras[1].pose.rotation.x() += 0.001;  // 2 pixels
  EXPECT_THAT(points.read(2).quality->moved,
              testing::StartsWith("camera1 shows the fixed tag 30 "));
}

TEST(SlowSpacePoints, RefuseASampleWithoutTexture) {
  test::DrawnRig rig(2, 300, 280, 0.035);
  rig.frames = {at_rest};
  rig.noise = {0, 0, 8};
  rig.others = [](int) { return std::vector<DrawnSurface>{board_before(-0.01, 0.06)}; };
  const DicFile dic = rig.dic();
  EXPECT_THAT([&] { SpacePoints(dic, rig.reader(), with(1)); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("no texture")));
}

}  // namespace
}  // namespace pliant
