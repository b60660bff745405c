#include "pliant/capture/rig_calibration.h"

#include <chrono>
#include <functional>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "capture/virtual_rig.h"

namespace pliant {
namespace {

using test::VirtualRig;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// Differences from the truth over their standard errors.
std::vector<double> errors_apart(const RigCalibration& found, const VirtualRig& rig) {
  std::vector<double> result;
  for (int c = 0; c < std::ssize(rig.cameras); ++c) {
    const CameraModel &is = found.bundle.cameras[c], &was = rig.cameras[c];
    Eigen::Vector<double, kCameraNumbers> off;
    off << is.intrinsics - was.intrinsics, is.pose.rotation - was.pose.rotation,
        is.pose.translation - was.pose.translation;
    for (int k = 0; k < kCameraNumbers; ++k) {
      const double error = found.error(c, k);
      if (error > 0) result.push_back(off(k) / error);
    }
  }
  return result;
}

TEST(RigCalibration, FindsAVirtualRigWithinItsErrors) {
  const VirtualRig rig(2);
  const RigCalibration found = calibrate_rig(rig.rig, rig.pictures(12, RandomStream(1)), {});
  for (const double apart : errors_apart(found, rig)) EXPECT_LT(std::abs(apart), 3.5);
  EXPECT_NEAR(found.bundle.noise[0], rig.noise, 0.1 * rig.noise);
  ASSERT_EQ(found.pairs.size(), 1u);
  EXPECT_NEAR(found.pairs[0].rms, rig.noise * std::sqrt(2.0), 0.2 * rig.noise);
  ASSERT_TRUE(found.held_out);
  EXPECT_LT(found.held_out->rms, 1e-4);
}

TEST(RigCalibration, IsTheSameOnAnyNumberOfThreads) {
  const VirtualRig rig(2);
  RunContext two;
  two.threads = 2;
  const RigCalibration a = calibrate_rig(rig.rig, rig.pictures(6, RandomStream(1)), {});
  const RigCalibration b = calibrate_rig(rig.rig, rig.pictures(6, RandomStream(1)), two);
  EXPECT_EQ(a.bundle.cameras[1].intrinsics, b.bundle.cameras[1].intrinsics);
  EXPECT_EQ(a.covariance.cameras, b.covariance.cameras);
  EXPECT_EQ(a.held_out->rms, b.held_out->rms);
}

std::string refusal_of(const RigFile& rig, std::vector<RigPicture> pictures) {
  try {
    calibrate_rig(rig, std::move(pictures), {});
  } catch (const InputError& error) {
    return error.what();
  }
  return "no refusal";
}

// The first and the third camera share no shot.
TEST(SlowRigCalibration, ConnectsCamerasThroughOthers) {
  const VirtualRig rig(3);
  const auto pictures = rig.pictures(12, RandomStream(2), [](int camera, int shot) {
    return shot % 2 == 0 ? camera < 2 : camera > 0;
  });
  const RigCalibration found = calibrate_rig(rig.rig, pictures, {});
  for (const double apart : errors_apart(found, rig)) EXPECT_LT(std::abs(apart), 3.5);
  EXPECT_EQ(found.pairs.size(), 2u);
}

TEST(RigCalibration, RefusesCamerasThatShareNothing) {
  const VirtualRig rig(2);
  const auto pictures =
      rig.pictures(16, RandomStream(2), [](int camera, int shot) { return shot % 2 == camera; });
  EXPECT_THAT(refusal_of(rig.rig, pictures), HasSubstr("no board was seen by this camera and one"));
}

TEST(RigCalibration, RefusesBoardsInOneTilt) {
  VirtualRig rig(1);
  rig.tilt = 0.03;
  EXPECT_THAT(refusal_of(rig.rig, rig.pictures(10, RandomStream(1))),
              HasSubstr("do not tell its focal length"));
}

TEST(RigCalibration, RefusesPicturesInAnotherOrder) {
  const VirtualRig rig(2);
  std::vector<RigPicture> pictures = rig.pictures(8, RandomStream(4));
  for (RigPicture& picture : pictures) {
    if (picture.camera == 1) picture.shot = 7 - picture.shot;
  }
  EXPECT_THAT(refusal_of(rig.rig, pictures), HasSubstr("contradict each other"));
}

TEST(RigCalibration, LeavesOutAPictureOfAnotherMoment) {
  const VirtualRig rig(2);
  std::vector<RigPicture> pictures = rig.pictures(10, RandomStream(4));
  const auto at = [&](int shot) {
    return std::ranges::find_if(pictures, [&](const RigPicture& picture) {
      return picture.camera == 1 && picture.shot == shot;
    });
  };
  std::swap(at(2)->findings, at(6)->findings);
  const RigCalibration found = calibrate_rig(rig.rig, pictures, {});
  int left_out = 0;
  for (const RigPicture& picture : found.pictures) {
    if (picture.left_out.empty()) continue;
    ++left_out;
    EXPECT_THAT(picture.left_out, HasSubstr("does not show the board where"));
  }
  EXPECT_EQ(left_out, 2);
  for (const double apart : errors_apart(found, rig)) EXPECT_LT(std::abs(apart), 3.5);
}

/// Of three cameras the second one changes after two thirds of twelve shots.
RigCalibration calibrated_with_change(const std::function<void(CameraModel&)>& change) {
  constexpr int kShots = 12, kChanged = 8;
  const VirtualRig before(3);
  VirtualRig after = before;
  change(after.cameras[1]);
  std::vector<RigPicture> pictures = before.pictures(kShots, RandomStream(8));
  const std::vector<RigPicture> later = after.pictures(kShots, RandomStream(8));
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    if (pictures[i].shot >= kChanged) pictures[i] = later[i];
  }
  return calibrate_rig(before.rig, pictures, {});
}

void expect_the_second_named(const RigCalibration& found) {
  using ::testing::Contains;
  using ::testing::StartsWith;
  EXPECT_THAT(found.warnings,
              Contains(AllOf(StartsWith("camera1: its pictures do not go together"),
                             HasSubstr(": 4 of them"), HasSubstr("was it moved, refocused"))));
  for (const char* other : {"camera0: its pictures", "camera2: its pictures"}) {
    EXPECT_THAT(found.warnings, Not(Contains(StartsWith(other))));
  }
}

TEST(SlowRigCalibration, NamesACameraThatWasMovedMeanwhile) {
  const RigCalibration found = calibrated_with_change(
      [](CameraModel& camera) { camera.pose.rotation.x() += 0.004; });  // 8 pixels
  expect_the_second_named(found);
}

TEST(SlowRigCalibration, NamesACameraThatWasRefocusedMeanwhile) {
  const RigCalibration found =
      calibrated_with_change([](CameraModel& camera) { camera.intrinsics.head<2>() *= 1.02; });
  expect_the_second_named(found);
}

TEST(SlowRigCalibration, LeavesOutCornersThatMiss) {
  const VirtualRig rig(2);
  std::vector<RigPicture> pictures = rig.pictures(10, RandomStream(5));
  for (RigPicture& picture : pictures) {
    picture.findings.boards[0].pixels.col(3) += Eigen::Vector2d(2, -1);
  }
  const RigCalibration found = calibrate_rig(rig.rig, pictures, {});
  EXPECT_EQ(found.cameras[0].left_out, 10);
  for (const double apart : errors_apart(found, rig)) EXPECT_LT(std::abs(apart), 3.5);
}

/// Two tags 0.1 m apart beside the board, which came out larger than its file says.
VirtualRig printed_rig(double scale) {
  VirtualRig rig(2);
  rig.print_scale = scale;
  rig.rig.second_length = {100, 101, 0.1, false, {"rig.yaml", 8, "second_length"}};
  return rig;
}

// By 0.3 %: several errors, and less than is refused.
TEST(SlowRigCalibration, SecondLengthShowsAScaleThatIsALittleOff) {
  for (const double scale : {1.0, 1.003}) {
    const VirtualRig rig = printed_rig(scale);
    const RigCalibration found =
        calibrate_rig(rig.rig, rig.pictures_with_ruler(8, 0.1, RandomStream(6)), {});
    ASSERT_TRUE(found.length);
    EXPECT_EQ(found.length->measured_in, 8);
    EXPECT_NEAR(found.length->measured, 0.1 / scale, 4 * found.length->error);
    EXPECT_LT(found.length->error, 1e-4);
    const bool loud = std::ranges::any_of(found.warnings, [](const std::string& warning) {
      return warning.find("SCALE") != std::string::npos;
    });
    EXPECT_EQ(loud, scale != 1);
  }
}

TEST(SlowRigCalibration, RefusesAScaleThatTheSecondLengthContradicts) {
  const VirtualRig rig = printed_rig(1.01);
  const std::string refusal = refusal_of(rig.rig, rig.pictures_with_ruler(8, 0.1, RandomStream(6)));
  EXPECT_THAT(refusal, HasSubstr("rig.yaml:8: second_length: is stated as 100 mm and comes out as "
                                 "9"));
  EXPECT_THAT(refusal, HasSubstr("by the boards, 0.9"));
  EXPECT_THAT(refusal, HasSubstr("printed at 100 %"));
}

TEST(RigCalibration, MeasuresALengthOnTheBoardWithOneCamera) {
  VirtualRig rig(1);
  rig.rig.second_length = {100, 101, 0.1, true, {"rig.yaml", 8, "second_length"}};
  const RigCalibration found =
      calibrate_rig(rig.rig, rig.pictures_with_ruler(8, 0.1, RandomStream(6)), {});
  ASSERT_TRUE(found.length);
  EXPECT_NEAR(found.length->measured, 0.1, 4 * found.length->error);
  EXPECT_LT(found.length->error, 1e-4);
}

TEST(RigCalibration, AsksForASecondLength) {
  const VirtualRig rig(1);
  const RigCalibration found = calibrate_rig(rig.rig, rig.pictures(8, RandomStream(1)), {});
  EXPECT_THAT(found.warnings, ::testing::Contains(HasSubstr("no second known length")));
}

TEST(RigCalibration, GravityIsAlongAPlumbLine) {
  VirtualRig rig(2);
  const Eigen::Vector3d down = Eigen::Vector3d(0.1, 1, 0.2).normalized(), top(0.02, -0.08, 0.45);
  PlumbLine line{{}, {"rig.yaml", 9, "gravity"}};
  for (int c = 0; c < 2; ++c) {
    line.seen.push_back(
        {c, *rig.cameras[c].project(top), *rig.cameras[c].project(top + 0.15 * down)});
  }
  rig.rig.gravity = line;
  const RigCalibration found = calibrate_rig(rig.rig, rig.pictures(10, RandomStream(1)), {});
  ASSERT_TRUE(found.gravity);
  EXPECT_LT((found.gravity->direction - down).norm(), 2e-3);
  EXPECT_LT(found.gravity->error, 0.02);
}

TEST(SlowRigCalibration, TellsABentBoard) {
  VirtualRig rig(2);
  rig.bend = 0.4e-3;
  rig.rig.warp = true;
  const RigCalibration found = calibrate_rig(rig.rig, rig.pictures(12, RandomStream(7)), {});
  EXPECT_NEAR(found.bundle.warps[0](0), rig.bend, 0.02e-3);
  EXPECT_NEAR(found.bundle.warps[0](2), 0, 0.02e-3);
  EXPECT_NEAR(found.bundle.noise[0], rig.noise, 0.1 * rig.noise);
}

TEST(SlowRigCalibration, StatesErrorsThatCoverTheTruth) {
  int inside = 0, all = 0;
  for (int seed = 0; seed < 20; ++seed) {
    const VirtualRig rig(2);
    const RigCalibration found = calibrate_rig(rig.rig, rig.pictures(8, RandomStream(seed)), {});
    for (const double apart : errors_apart(found, rig)) {
      inside += std::abs(apart) < 1.96;
      ++all;
    }
  }
  fmt::print("95 % intervals hold {} of {} numbers of cameras\n", inside, all);
  EXPECT_NEAR(static_cast<double>(inside) / all, 0.95, 0.04) << inside << " of " << all;
}

TEST(SlowRigCalibration, TakesFourCamerasWithThirtyPicturesEach) {
  const VirtualRig rig(4, {6, 8, 0.012, 0.003, 0});
  const auto begun = std::chrono::steady_clock::now();
  RunContext context;
  context.threads = 2;
  const RigCalibration found = calibrate_rig(rig.rig, rig.pictures(30, RandomStream(1)), context);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
  for (const double apart : errors_apart(found, rig)) EXPECT_LT(std::abs(apart), 4);
  fmt::print("4 cameras, 30 pictures of 192 corners each: {:.1f} s\n", took.count());
}

}  // namespace
}  // namespace pliant
