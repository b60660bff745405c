// Cords that are drawn before three cameras, beside a printed sheet.
#include "pliant/capture/cord_line.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/capture/cord_search.h"
#include "pliant/capture/virtual_cords.h"

#include "capture/drawn_rig.h"

namespace pliant {
namespace {

using test::DrawnRig;

constexpr double kDegree = M_PI / 180;

/// Cords before a rig, in the axes of its sheet, and what the cameras see of them.
class DrawnCords {
 public:
  explicit DrawnCords(std::vector<CordForce> cords, int cameras = 3)
      : rig_(cameras, 640, 512, 0.06) {
    SessionFrame frame;
    frame.cords = {std::move(cords)};
    rig_.frames = {
        [](const Eigen::Vector2d& rest) { return Eigen::Vector3d(rest.x(), rest.y(), 0); }};
    rig_.others = [frame](int) { return cord_surfaces(frame); };
    rig_.light.samples = 2;
    for (int c = 0; c < cameras; ++c) pictures_.emplace_back(rig_.picture(c, 0));
  }

  CordViews views() const { return {rig_.cameras, pictures_}; }
  const std::vector<SplinePicture>& pictures() const { return pictures_; }
  Eigen::Vector3d in_rig(const Eigen::Vector3d& place) const { return rig_.to_rig() * place; }
  Eigen::Vector3d along(const CordForce& cord) const {
    return rig_.to_rig().linear() * cord.force.normalized();
  }
  Eigen::Vector2d pixel(std::size_t camera, const Eigen::Vector3d& place) const {
    return *rig_.cameras[camera].project(in_rig(place));
  }
  /// The plane of the sheet.
  Eigen::Hyperplane<double, 3> sheet() const {
    return {rig_.to_rig().linear().col(2), in_rig(Eigen::Vector3d::Zero())};
  }
  /// A user points beside the ends of the first 40 mm.
  std::optional<CordLine> pointed(const CordForce& cord, std::size_t camera) const {
    const Eigen::Vector2d off(1.5, -1);
    const auto look =
        look_of_cord(pictures_[camera], pixel(camera, cord.point) + off,
                     pixel(camera, cord.point + 0.04 * cord.force.normalized()) - off);
    return look ? pointed_cord(views(), camera, *look, sheet()) : std::nullopt;
  }

 private:
  DrawnRig rig_;
  std::vector<SplinePicture> pictures_;
};

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

const CordForce kCord{"1", {0.065, 0.03, 0}, {1, 0.2, 0.3}};
const CordForce kBeside{"2", {0.065, 0.045, 0}, {1, 0.2, 0.3}};

TEST(CordLine, IsFoundInSpaceFromWhereOneCameraWasPointed) {
  const DrawnCords drawn({kCord, kBeside});
  const auto line = drawn.pointed(kCord, 0);
  ASSERT_TRUE(line);
  const double angle = angle_between(line->direction, drawn.along(kCord));
  EXPECT_LT(angle, 0.1 * kDegree);
  EXPECT_LT(angle, 4 * line->error + 0.02 * kDegree);
  EXPECT_LT((line->from - drawn.in_rig(kCord.point)).cross(line->direction).norm(), 0.15e-3);
  EXPECT_NEAR(line->length, 0.04, 2e-3);
}

TEST(CordLine, OfTwoParallelCordsIsTheOneThatIsFastenedThere) {
  const DrawnCords drawn({kCord, kBeside}, 2);
  for (const CordForce& cord : {kCord, kBeside}) {
    const auto line = drawn.pointed(cord, 1);
    ASSERT_TRUE(line);
    EXPECT_LT((line->from - drawn.in_rig(cord.point)).norm(), 2e-3) << cord.cord;
  }
}

TEST(SlowCordLine, IsFoundAgainAfterAFarTurn) {
  const CordForce turned{"1", kCord.point, {0.3, 1, 0.4}};
  const DrawnCords before({kCord}), after({turned});
  CordLine last = *before.pointed(kCord, 0);
  const CordLook look = look_of_cord(before.pictures()[0], before.pixel(0, kCord.point),
                                     before.pixel(0, kCord.point + 0.04 * kCord.force.normalized()))
                            ->look;
  EXPECT_FALSE(fitted_cord(after.views(), look, last));
  const auto line = found_cord(after.views(), look, last, 1.5);
  ASSERT_TRUE(line);
  EXPECT_LT(angle_between(line->direction, after.along(turned)), 0.1 * kDegree);
}

TEST(SlowCordLine, IsSeenByTwoCamerasOrNotAtAll) {
  const DrawnCords drawn({kCord}), empty({});
  const CordLine line = *drawn.pointed(kCord, 0);
  const CordLook look{1, 3, 0.4};
  EXPECT_FALSE(fitted_cord(empty.views(), look, line));
  EXPECT_FALSE(found_cord(empty.views(), look, line, 1.5));
  const CordViews alone{drawn.views().cameras.first(1), drawn.views().pictures.first(1)};
  EXPECT_FALSE(fitted_cord(alone, look, line));
}

// No line through a print, nor one beside a cord, stands out all along.
TEST(CordLook, IsNotThatOfAPrintOrOfNothing) {
  const DrawnCords drawn({kCord});
  const auto look = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    return look_of_cord(drawn.pictures()[0], drawn.pixel(0, from), drawn.pixel(0, to));
  };
  for (int i = 0; i < 60; ++i) {
    EXPECT_FALSE(look({0.005, 0.005 + 0.0008 * i, 0}, {0.055, 0.055 - 0.0007 * i, 0})) << i;
    EXPECT_FALSE(look({0.07, -0.01 - 0.0003 * i, 0}, {0.1, -0.02, 0})) << i;
  }
  EXPECT_TRUE(look(kCord.point, kCord.point + 0.04 * kCord.force.normalized()));
}

}  // namespace
}  // namespace pliant
