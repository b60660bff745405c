#include "pliant/capture/dic_session.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/random.h"

#include "capture/point_tables.h"

namespace pliant {
namespace {

using test::Motion;
using test::PointTables;
using test::TemporaryFolder;

constexpr int kFrames = 4;
constexpr double kRounding = 1e-9;  // m: pixels are written with all digits

/// 2 % a frame along warp, 0.6 % less across, about the middle of the lower edge.
Eigen::Vector3d stretched(int frame, const Eigen::Vector2d& place) {
  const double middle = PointTables::kWidth / 2;
  return {middle + (1 - 0.006 * frame) * (place.x() - middle), (1 + 0.02 * frame) * place.y(), 0};
}

/// Rows of force and extension, a frame each.
std::string log_of(double extension_a_frame) {
  std::string log = "force_N,extension_mm\n";
  for (int f = 0; f < kFrames; ++f) log += fmt::format("{},{}\n", 2 * f, extension_a_frame * f);
  return log;
}

DicSession session_of(const std::filesystem::path& file) {
  return make_dic_session(read_dic(file));
}

/// Largest distance of the seen vertices of a frame from where they should be.
double largest_error(const Session& session, int f, const Motion& motion) {
  double largest = 0;
  const Eigen::Matrix3Xd& positions = session.frames[static_cast<std::size_t>(f)].positions;
  for (int v = 0; v < session.rest.vertex_count(); ++v) {
    if (!positions.col(v).allFinite()) continue;
    const Eigen::Vector3d expected = motion(f, session.rest.positions.col(v).head<2>());
    largest = std::max(largest, (positions.col(v) - expected).norm());
  }
  return largest;
}

TEST(DicSession, FollowsAnAffineMotionExactly) {
  const TemporaryFolder folder;
  PointTables::write(folder, kFrames, stretched);
  folder.write("log.csv", log_of(1.6));
  const DicSession made =
      session_of(PointTables::describe(folder, std::string(PointTables::kJaws) + "mesh: 4 mm\n"));
  const Session& session = made.session;
  EXPECT_NEAR(made.spacing, 2e-3, kRounding);
  EXPECT_EQ(session.rest.vertex_count(), 11 * 21);
  EXPECT_EQ(session.frame_count(), kFrames);
  for (int f = 0; f < kFrames; ++f) {
    // Clips do not narrow, the cloth between them does.
    const auto free = [&](int frame, const Eigen::Vector2d& place) -> Eigen::Vector3d {
      const bool held = place.y() < 1e-9 || place.y() > 0.08 - 1e-9;
      const Eigen::Vector3d moved = stretched(frame, place);
      return held ? Eigen::Vector3d(place.x(), moved.y(), 0) : moved;
    };
    EXPECT_LT(largest_error(session, f, free), kRounding) << f;
    EXPECT_NEAR(made.middle->strain[static_cast<std::size_t>(f)], 0.02 * f, 1e-9);
    EXPECT_NEAR(made.middle->lateral_strain[static_cast<std::size_t>(f)], -0.006 * f, 1e-9);
  }
  EXPECT_EQ(made.middle->direction, "warp");
  EXPECT_NEAR(made.middle->length, 0.08 / 3, 1e-12);
  const CordForce& pull = session.frames[3].cords[1].front();
  EXPECT_LT((pull.force - Eigen::Vector3d(0, 6, 0)).norm(), 1e-12);
  EXPECT_LT((pull.point - Eigen::Vector3d(0.02, 0.08 * 1.06, 0)).norm(), kRounding);
  EXPECT_LT((session.frames[3].cords[0].front().force + pull.force).norm(), 1e-12);
  for (const ClipSlip& slip : made.slips) {
    for (const double s : slip.slip) EXPECT_NEAR(s, 0, kRounding) << slip.clip;
  }
}

// The upper jaw goes 0.1 mm a frame further than the cloth at its edge.
TEST(DicSession, TellsWhatHasLeftAClip) {
  const TemporaryFolder folder;
  PointTables::write(folder, kFrames, stretched);
  folder.write("log.csv", log_of(1.7));
  const DicSession made = session_of(PointTables::describe(folder, PointTables::kJaws));
  ASSERT_EQ(made.slips.size(), 2U);
  EXPECT_NEAR(made.slips[0].slip.back(), 0, kRounding);
  EXPECT_EQ(made.slips[1].clip, "upper");
  for (int f = 0; f < kFrames; ++f) {
    EXPECT_NEAR(made.slips[1].slip[static_cast<std::size_t>(f)], 0.1e-3 * f, kRounding);
  }
}

// The tester runs from 3 s after the first frame on, and by another clock.
TEST(DicSession, FindsTheClockOfALogByHowItsClipMoves) {
  constexpr double kRate = 2, kLate = 3, kOther = 100, kSpeed = 0.4e-3;  // 1/s, s, s, m/s
  const auto way = [&](double time) {
    return kSpeed * std::max(0.0, std::min(time - 5, 21 - time));
  };
  const TemporaryFolder folder;
  PointTables::write(folder, 44, [&](int f, const Eigen::Vector2d& place) -> Eigen::Vector3d {
    return {place.x(), (1 + way(f / kRate) / PointTables::kHeight) * place.y(), 0};
  });
  std::string log = "time_s,force_N,extension_mm\n";
  for (int row = 0; row < 200; ++row) {
    const double time = kLate + 0.1 * row;
    log += fmt::format("{},{},{}\n", time + kOther, 1e3 * way(time), 1e3 * way(time));
  }
  folder.write("log.csv", log);
  const std::string more =
      "clips: [{name: lower, side: bottom, motion: held}, {name: upper, side: top}]\n"
      "forces: {data: log.csv, on: upper, rate: 2 Hz, start: by motion}\n";
  const DicSession made = session_of(PointTables::describe(folder, more));
  ASSERT_FALSE(made.notes.empty());
  EXPECT_THAT(made.notes.front(), testing::HasSubstr("first frame was taken at 100 s of the log"));
  EXPECT_EQ(made.left_out.size(), 6U);
  EXPECT_EQ(made.left_out.front().why, "was taken when the log was not running");
  const SessionFrame& frame = made.session.frames[12];
  const int number = made.used[12];
  EXPECT_NEAR(*frame.time, kOther + number / kRate, 1e-3);
  EXPECT_NEAR(frame.cords[1][0].force.y(), 1e3 * way(number / kRate), 2e-3);

  const DicSession told = session_of(
      PointTables::describe(folder,
                            "clips: [{name: lower, side: bottom, motion: held}, "
                            "{name: upper, side: top, motion: extension}]\n"
                            "forces: {data: log.csv, on: upper, rate: 2 Hz, start: 100 s}\n"));
  EXPECT_EQ(told.left_out.size(), 6U);
  EXPECT_EQ(told.used, made.used);
}

TEST(DicSession, ClipsWithoutALogMoveAndTurnWithThePointsBesideThem) {
  const TemporaryFolder folder;
  const Eigen::AngleAxisd turn(0.05, Eigen::Vector3d::UnitZ());
  PointTables::write(folder, 2, [&](int f, const Eigen::Vector2d& place) -> Eigen::Vector3d {
    const Eigen::Vector3d at(place.x(), place.y(), 0);
    return f == 0 ? at : Eigen::Vector3d(turn * at + Eigen::Vector3d(1e-3, -2e-3, 0));
  });
  const DicSession made = session_of(
      PointTables::describe(folder, "clips: [{name: a, side: left}, {name: b, side: right}]\n"));
  for (const Pose& pose : made.session.frames[1].poses) {
    EXPECT_LT(pose.rotation.angularDistance(Eigen::Quaterniond(turn)), 1e-7);
    EXPECT_LT((pose.translation - Eigen::Vector3d(1e-3, -2e-3, 0)).norm(), 1e-8);
  }
  EXPECT_EQ(made.middle->direction, "weft");
  EXPECT_TRUE(made.slips.empty());
}

TEST(DicSession, LeavesOutVerticesThatNoPointIsNear) {
  const TemporaryFolder folder;
  const auto places = PointTables::places();
  const Eigen::Vector2d hole(0.02, 0.04);
  PointTables::write(
      folder, 2, stretched, [&](int f, std::size_t p, const std::string& row) -> std::string {
        const bool lost = f == 1 && (places[p] - hole).norm() < 7e-3;
        return lost ? row.substr(0, row.find(',', row.find(',') + 1)) + ",NaN," : row;
      });
  const DicSession made = session_of(PointTables::describe(
      folder, "mesh: 2 mm\nclips: [{name: a, side: bottom}, {name: b, side: top}]\n"));
  EXPECT_EQ(made.lost[0], 0);
  EXPECT_GT(made.lost[1], 20);
  const Session& session = made.session;
  for (int v = 0; v < session.rest.vertex_count(); ++v) {
    const Eigen::Vector2d place = session.rest.positions.col(v).head<2>();
    const bool held = place.y() < 1e-9 || place.y() > PointTables::kHeight - 1e-9;
    const bool near = std::ranges::any_of(places, [&](const Eigen::Vector2d& point) {
      return (point - hole).norm() >= 7e-3 && (point - place).norm() < 1.2 * PointTables::kSpacing;
    });
    EXPECT_EQ(session.frames[1].positions.col(v).allFinite(), held || near) << place.transpose();
  }
}

TEST(DicSession, LeavesOutPointsOfNegativeSigma) {
  const TemporaryFolder folder;
  const auto mark = [](int f, std::size_t p, const std::string& row) {
    // Some systems write zeros for points that they lost.
    return p == 200 && f == 1 ? row.substr(0, row.find(',', row.find(',') + 1)) + ",500,500,-1"
                              : row + ",0.01";
  };
  PointTables::write(folder, 2, stretched, mark);
  for (int f = 0; f < 2; ++f) {
    const std::string name = fmt::format("points/{:03}.csv", f);
    std::string text = test::content_of(folder.path() / name);
    folder.write(name, text.replace(0, 7, "x,y,u,v,sigma"));
  }
  const DicSession made = session_of(
      PointTables::describe(folder, "clips: [{name: a, side: bottom}, {name: b, side: top}]\n"));
  EXPECT_EQ(made.lost[1], 1);
  EXPECT_NEAR(made.middle->strain[1], 0.02, 1e-9);
}

// Stereo systems have axes of their own: the sample's plane is found, whatever its tilt.
TEST(DicSession, FollowsNumberedPointsInSpace) {
  const TemporaryFolder folder;
  const Eigen::Matrix3d tilt =
      Eigen::AngleAxisd(0.3, Eigen::Vector3d(0.2, 1, 0).normalized()).matrix();
  const Motion bent = [](int f, const Eigen::Vector2d& place) -> Eigen::Vector3d {
    return {place.x(), (1 + 0.01 * f) * place.y(), 0.05 * f * place.y()};
  };
  const auto places = PointTables::places();
  for (int f = 0; f < 2; ++f) {
    std::string text = "id;X [mm];Y [mm];Z [mm]\n";
    for (std::size_t p = 0; p < places.size(); ++p) {
      const Eigen::Vector3d at = tilt * bent(f, places[p]) + Eigen::Vector3d(0.1, 0.2, 0.5);
      text += fmt::format("{};{};{};{}\n", p, 1e3 * at.x(), 1e3 * at.y(), 1e3 * at.z());
    }
    folder.write(fmt::format("s/{}.csv", f), text);
  }
  const auto file = folder.write("s.yaml",
                                 "pliant: dic/1\ntest: bulge\npoints: s/*.csv\n"
                                 "sample: {width: 40 mm, height: 80 mm, mass: 0.5 g}\n"
                                 "clips: [{name: a, side: bottom}, {name: b, side: top}]\n");
  const DicSession made = session_of(file);
  EXPECT_LT(made.off_plane, kRounding);
  // The axes are the plane's, turned to the points' x: not the sample's own to the last degree.
  const Eigen::Vector3d weft =
      tilt.transpose() * (Eigen::Vector3d::UnitX() - tilt.col(2) * tilt(0, 2)).normalized();
  const double angle = std::atan2(weft.y(), weft.x());
  EXPECT_LT(std::abs(angle), 0.1);
  EXPECT_NEAR(made.middle->strain[1], std::hypot(1.01, 0.05) - 1, 3e-4);
}

// What the session says of its noise is what its vertices miss.
TEST(DicSession, StatesTheNoiseThatItsVerticesHave) {
  const TemporaryFolder folder;
  RandomStream random(5);
  constexpr double kNoise = 5e-6;
  PointTables::write(folder, kFrames, [&](int f, const Eigen::Vector2d& place) -> Eigen::Vector3d {
    Eigen::Vector3d at = stretched(f, place);
    if (f > 0) at += Eigen::Vector3d(kNoise * random.normal(), kNoise * random.normal(), 0);
    return at;
  });
  folder.write("log.csv", log_of(1.6));
  const DicSession made =
      session_of(PointTables::describe(folder, std::string(PointTables::kJaws) + "mesh: 2 mm\n"));
  EXPECT_NEAR(made.point_noise, kNoise, 0.1 * kNoise);
  const Session& session = made.session;
  double sum = 0;
  int count = 0;
  for (int v = 0; v < session.rest.vertex_count(); ++v) {
    const Eigen::Vector2d place = session.rest.positions.col(v).head<2>();
    const auto& at = session.frames[2].positions.col(v);
    if (place.y() < 1e-3 || place.y() > 0.079 || !at.allFinite()) continue;
    sum += (at - stretched(2, place)).squaredNorm();
    count += 2;
  }
  const double missed = std::sqrt(sum / count);
  EXPECT_LT(missed, 0.5 * kNoise);
  EXPECT_NEAR(missed, *session.noise.position, 0.3 * missed);
}

TEST(DicSession, HasLinesAlongTheEdgesOfClipsThatHoldSomeOfTheCloth) {
  const TemporaryFolder folder;
  PointTables::write(folder, 2, stretched);
  folder.write(
      "cords.csv",
      "frame,clip,px,py,pz,fx,fy,fz\n1,upper,0.02,0.085,0,0,2,0\n1,lower,0.02,-0.005,0,0,-2,0\n");
  const auto file = PointTables::describe(folder,
                                          "clips:\n  - {name: lower, side: bottom, depth: 7 mm}\n"
                                          "  - {name: upper, side: top, depth: 7 mm, along: [5 mm, "
                                          "35 mm]}\nforces: {cords: cords.csv}\n");
  const DicSession made = make_dic_session(read_dic(file));
  const Session& session = made.session;
  // Nothing pulls in the first frame: it lies on something.
  ASSERT_EQ(session.frame_count(), 1);
  EXPECT_EQ(made.slack, std::vector<int>{0});
  EXPECT_EQ(session.frames[0].cords[1].at(0).force.y(), 2);
  const auto upper = session.rest.positions(Eigen::all, session.clips[1].clamped);
  EXPECT_NEAR(upper.row(1).minCoeff(), 0.073, 1e-12);
  EXPECT_NEAR(upper.row(0).minCoeff(), 0.005, 1e-12);
  EXPECT_NEAR(upper.row(0).maxCoeff(), 0.035, 1e-12);
  const auto lower = session.rest.positions(Eigen::all, session.clips[0].clamped);
  EXPECT_NEAR(lower.row(1).maxCoeff(), 0.007, 1e-12);
}

}  // namespace
}  // namespace pliant
