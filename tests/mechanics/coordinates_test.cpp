#include "pliant/mechanics/coordinates.h"

#include <memory>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "pliant/base/assert.h"
#include "pliant/math/check_derivatives.h"
#include "pliant/mechanics/cord.h"
#include "pliant/mechanics/point_forces.h"
#include "pliant/mechanics/point_targets.h"

#include "support/cloth_systems.h"
#include "support/evaluate_system.h"

namespace pliant {
namespace {

constexpr int kNodes = 5;
constexpr double kSize = 0.1;  // m

Eigen::VectorXd random_change(RandomStream& random, Eigen::Index size, double scale) {
  Eigen::VectorXd change(size);
  for (double& x : change) x = scale * random.normal();
  return change;
}

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& a) {
  Eigen::Matrix3d m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

Pose pose_of(const Eigen::AngleAxisd& rotation, const Eigen::Vector3d& translation) {
  Pose pose;
  pose.rotation = rotation;
  pose.translation = translation;
  return pose;
}

/// A small cloth with a free clip along one side, another one of a few points inside, a prescribed
/// clip, two prescribed points, cords to a clip and to the cloth, and forces everywhere.
struct HeldCloth {
  test::ClothSystem cloth = test::cloth_system(test::jittered_grid(kSize, kSize, kNodes, kNodes, 5),
                                               test::uneven_cotton());
  System& system = *cloth.system;
  int side = 0, inside = 0, holder = 0;

  HeldCloth() {
    Coordinates& coordinates = system.coordinates();
    side = coordinates.add_clip({0, 5, 10, 15, 20}, false);
    inside = coordinates.add_clip({12, 13, 17}, false);
    holder = coordinates.add_clip({4, 9}, true);
    coordinates.prescribe(24);
    coordinates.prescribe(22);
    RandomStream random(3);
    Eigen::Matrix3Xd forces(3, system.points());
    for (double& f : forces.reshaped()) f = 0.1 * random.normal();
    system.add(std::make_shared<PointForces>(forces));
    system.add(std::make_shared<Cord>(20, 30, 0.05, Eigen::Vector3d(-0.1, 0.15, 0.02)));
    system.add(std::make_shared<Cord>(7, 15, 0.0, Eigen::Vector3d(0.1, 0.0, 0.1)));
    system.add(std::make_shared<Cord>(8, 15, 5.0, Eigen::Vector3d(0.1, 0.0, 0.1)));  // slack
    system.add(std::make_shared<PointTargets>(Eigen::VectorXd::LinSpaced(system.points(), 1, 5),
                                              cloth.mesh.positions));
    system.finish();
  }

  /// Somewhere else, with the clips turned.
  Configuration displaced(RandomStream& random) const {
    Configuration at = system.initial_state().configuration;
    const Eigen::AngleAxisd turn(0.2, Eigen::Vector3d::UnitZ());
    system.coordinates().place_clip(
        holder, pose_of(turn, at.clips[2].translation + Eigen::Vector3d(0.01, 0, 0.005)), at);
    at.positions.col(24) += Eigen::Vector3d(0.004, 0.01, 0);
    Eigen::VectorXd change = random_change(random, system.coordinates().unknowns(), 0.004);
    change.tail(12) *= 40;  // rotations by some tenths
    return system.coordinates().moved(at, change);
  }
};

TEST(Coordinates, NumberFreePointsThenTranslationsAndRotationsOfFreeClips) {
  const HeldCloth held;
  const Coordinates& coordinates = held.system.coordinates();
  EXPECT_EQ(coordinates.points(), 25);
  EXPECT_EQ(coordinates.clips(), 3);
  EXPECT_EQ(coordinates.block_rows(), 13 + 2 * 2);
  EXPECT_EQ(coordinates.unknowns(), 3 * 17);
  int next = 0;
  for (int i = 0; i < 25; ++i) {
    const bool clipped = i % 5 == 0 || i == 12 || i == 13 || i == 17 || i == 4 || i == 9;
    const bool prescribed = i == 22 || i == 24 || i == 4 || i == 9;
    EXPECT_EQ(coordinates.is_free(i), !clipped && !prescribed) << i;
    EXPECT_EQ(coordinates.is_prescribed(i), prescribed) << i;
    EXPECT_EQ(coordinates.row(i), coordinates.is_free(i) ? next++ : -1);
  }
  EXPECT_TRUE(coordinates.clip_is_prescribed(held.holder));
  EXPECT_FALSE(coordinates.clip_is_prescribed(held.side));
}

TEST(Coordinates, AreAsManyAsThePointsWhereNothingIsHeld) {
  const Coordinates coordinates(4);
  EXPECT_EQ(coordinates.unknowns(), 12);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(coordinates.row(i), i);
}

TEST(Coordinates, RefuseAPointWithTwoOwners) {
  Coordinates coordinates(6);
  coordinates.add_clip({0, 1}, false);
  EXPECT_THROW(coordinates.add_clip({1, 2}, false), AssertionError);
  EXPECT_THROW(coordinates.prescribe(0), AssertionError);
  EXPECT_THROW(coordinates.add_clip({}, true), AssertionError);
  coordinates.prescribe(5);
  EXPECT_THROW(coordinates.add_clip({4, 5}, true), AssertionError);
}

TEST(Coordinates, BeginClipsUnrotatedAtTheMeanOfTheirPoints) {
  const HeldCloth held;
  const Configuration at = held.system.initial_state().configuration;
  const Eigen::Vector3d mean =
      (at.positions.col(12) + at.positions.col(13) + at.positions.col(17)) / 3;
  EXPECT_TRUE(at.clips[1].translation.isApprox(mean, 1e-14));
  EXPECT_TRUE(at.clips[1].rotation.isApprox(Eigen::Quaterniond::Identity()));
}

TEST(Coordinates, MoveClipsRigidlyAndLeaveWhatIsPrescribed) {
  const HeldCloth held;
  const Coordinates& coordinates = held.system.coordinates();
  const Configuration start = held.system.initial_state().configuration;
  Configuration at = start;
  RandomStream random(1);
  for (int step = 0; step < 200; ++step) {
    at = coordinates.moved(at, random_change(random, coordinates.unknowns(), 0.3));
  }
  for (const int i : {22, 24, 4, 9}) EXPECT_EQ(at.positions.col(i), start.positions.col(i));
  for (int k = 0; k < 2; ++k) {
    const auto& points = coordinates.clip_points(k);
    for (const int p : points) {
      for (const int q : points) {
        EXPECT_NEAR((at.positions.col(p) - at.positions.col(q)).norm(),
                    (start.positions.col(p) - start.positions.col(q)).norm(), 1e-13);
      }
    }
    EXPECT_NEAR(at.clips[static_cast<size_t>(k)].rotation.norm(), 1, 1e-14);
  }
}

TEST(Coordinates, TurnAClipAboutItsOrigin) {
  const HeldCloth held;
  const Coordinates& coordinates = held.system.coordinates();
  const Configuration start = held.system.initial_state().configuration;
  Eigen::VectorXd change = Eigen::VectorXd::Zero(coordinates.unknowns());
  const Eigen::Vector3d turn(0.3, -1.1, 0.4), shift(0.1, 0.2, -0.3);
  const Eigen::Index first = 3 * 13;  // of the first clip
  change.segment<3>(first) = shift;
  change.segment<3>(first + 3) = turn;
  const Configuration at = coordinates.moved(start, change);
  const Eigen::Vector3d origin = start.clips[0].translation;
  const Eigen::AngleAxisd rotation(turn.norm(), turn.normalized());
  for (const int p : coordinates.clip_points(0)) {
    const Eigen::Vector3d expected = origin + shift + rotation * (start.positions.col(p) - origin);
    EXPECT_TRUE(at.positions.col(p).isApprox(expected, 1e-13));
  }
}

TEST(Coordinates, PlaceAPrescribedClipWithItsPoints) {
  const HeldCloth held;
  Configuration at = held.system.initial_state().configuration;
  const Eigen::Vector3d arm = at.positions.col(9) - at.clips[2].translation;
  const Pose pose = pose_of(Eigen::AngleAxisd(1.2, Eigen::Vector3d::UnitX()), {1, 2, 3});
  held.system.coordinates().place_clip(held.holder, pose, at);
  EXPECT_TRUE(at.positions.col(9).isApprox(pose.translation + pose.rotation * arm, 1e-14));
  EXPECT_EQ(at.clips[2].translation, pose.translation);
}

// One step of friction makes stresses that differ from element to element.
State with_history(const HeldCloth& held, RandomStream& random) {
  State state = held.system.initial_state();
  test::accept(held.system, state, held.displaced(random));
  return state;
}

TEST(Coordinates, ReduceForcesToDerivativesByTheUnknowns) {
  const HeldCloth held;
  const System& system = held.system;
  RandomStream random(2);
  for (int trial = 0; trial < 4; ++trial) {
    const State from = with_history(held, random);
    const Configuration at = held.displaced(random);
    const VectorFunction energy = [&](const Eigen::VectorXd& change) {
      const Configuration there = system.coordinates().moved(at, change);
      return Eigen::VectorXd::Constant(1, test::energy_of(system, there, from).total());
    };
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(system.coordinates().unknowns());
    // Steps of a thousandth of an edge at most: hardly an element passes its last strain.
    const DerivativeCheck check =
        check_derivatives(energy, test::reduced_gradient(system, at, from).transpose(), zero,
                          Eigen::VectorXd::Constant(zero.size(), 2e-4));
    EXPECT_LT(check.error, 1e-7) << check.describe();
  }
}

// The unknowns of a clip are a rotation from where it is: the moment there is the slope of the
// energy. Taken at a clip that has turned by w, the moment is that of a turn after w, and its
// differences are the Hessian less half the cross matrix of the moment.
TEST(Coordinates, HessianIsThatOfDifferencesWithTheTurningOfClips) {
  const HeldCloth held;
  const System& system = held.system;
  RandomStream random(4);
  for (int trial = 0; trial < 4; ++trial) {
    const State from = with_history(held, random);
    const Configuration at = held.displaced(random);
    Eigen::MatrixXd stated = test::hessian_of(system, at, from);
    const Eigen::VectorXd force = test::reduced_gradient(system, at, from);
    for (const Eigen::Index rotation : {3 * 13 + 3, 3 * 13 + 9}) {
      stated.block<3, 3>(rotation, rotation) -= cross_matrix(force.segment<3>(rotation)) / 2;
    }
    const VectorFunction reduced = [&](const Eigen::VectorXd& change) {
      return test::reduced_gradient(system, system.coordinates().moved(at, change), from);
    };
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(system.coordinates().unknowns());
    const DerivativeCheck check =
        check_derivatives(reduced, stated, zero, Eigen::VectorXd::Constant(zero.size(), 2e-4));
    EXPECT_LT(check.error, 1e-7) << check.describe();
  }
}

TEST(Coordinates, FollowASystemAsAWhole) {
  // All points in one clip: a rigid cloth, whose only forces are those from outside.
  test::ClothSystem cloth =
      test::cloth_system(test::jittered_grid(kSize, kSize, 3, 3, 5), test::frictional_cotton());
  System& system = *cloth.system;
  system.coordinates().add_clip({0, 1, 2, 3, 4, 5, 6, 7, 8}, false);
  const Eigen::Vector3d end(0.3, 0.2, 0.4);
  system.add(std::make_shared<Cord>(0, 10, 0.1, end));
  system.finish();
  EXPECT_EQ(system.coordinates().unknowns(), 6);
  const State state = system.initial_state();
  RandomStream random(5);
  const Configuration at =
      system.coordinates().moved(state.configuration, random_change(random, 6, 0.5));
  const Eigen::Vector3d way = end - at.positions.col(0);
  const Eigen::Vector3d pull = 10 * (way.norm() - 0.1) * way.normalized();
  const Eigen::Vector3d arm = at.positions.col(0) - at.clips[0].translation;
  const Eigen::VectorXd force = -test::reduced_gradient(system, at, state);
  EXPECT_TRUE(force.head<3>().isApprox(pull, 1e-11));
  EXPECT_TRUE(force.tail<3>().isApprox(arm.cross(pull), 1e-11));
}

}  // namespace
}  // namespace pliant
