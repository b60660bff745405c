#include "pliant/experiment/drape/platform.h"

#include <gtest/gtest.h>

#include "pliant/mechanics/system.h"

namespace pliant {
namespace {

constexpr double kStiffness = 5e5;  // 1/s^2

/// Three points of 1 g on, below and above a platform at z = -1 mm.
struct Rig {
  System system;
  Controls controls;

  Rig() : system(places(), Eigen::VectorXd::Constant(3, 1e-3)) {
    system.add(std::make_shared<Platform>(0, system.masses(), kStiffness));
    system.finish();
    controls.vectors = Eigen::Vector3d(0, 0, -1e-3);
  }
  static Eigen::Matrix3Xd places() {
    Eigen::Matrix3Xd at = Eigen::Matrix3Xd::Zero(3, 3);
    at.row(2) << -1e-3, -1.5e-3, 0;
    return at;
  }
};

TEST(Platform, PushesUpWhatIsBelowIt) {
  const Rig rig;
  const State state = rig.system.initial_state();
  Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, 3);
  Hessian hessian = rig.system.make_hessian();
  Derivatives derivatives{{}, &gradient, &hessian};
  rig.system.evaluate(state.configuration, {.from = state, .controls = rig.controls},
                      Curvature::exact, derivatives);
  EXPECT_DOUBLE_EQ(derivatives.energy.stored, 1e-3 * kStiffness * 0.5e-3 * 0.5e-3 / 2);
  EXPECT_DOUBLE_EQ(gradient(2, 1), -1e-3 * kStiffness * 0.5e-3);
  EXPECT_EQ(gradient.leftCols<1>().norm() + gradient.rightCols<1>().norm(), 0);
  EXPECT_EQ(gradient.topRows<2>().norm(), 0);
}

TEST(Platform, IsNotThereWithoutItsHeight) {
  Rig rig;
  rig.controls.vectors.resize(3, 0);
  const State state = rig.system.initial_state();
  Derivatives derivatives;
  rig.system.evaluate(state.configuration, {.from = state, .controls = rig.controls},
                      Curvature::exact, derivatives);
  EXPECT_EQ(derivatives.energy.stored, 0);
}

}  // namespace
}  // namespace pliant
